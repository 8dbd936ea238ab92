// Eight hits become surfaces: make_surface() for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The points of hits with balls, put back onto them: surface_point().
///
/// \return the hits next to a giant ball, which is another formula's, nothing put
LANCER_INLINE Mask put_balls(const Scene& scene, const Rays& r, const NearestHits& hits, Mask mask,
                             Surfaces& s) {
    Vectors center = all(scene.balls[0].center);
    Numbers radius = all(1.0);
    for_each_lane(mask, [&](int i) {
        const Ball& ball = scene.balls[scene.items[hits.item[i]].shape];
        set_lane(center, i, ball.center);
        set_lane(radius, i, ball.radius);
    });
    Vectors normal = normalize(start_from(r, center) + hits.t * r.dir);
    const Numbers way = hits.t * hits.t * r.dir_squared;
    const Numbers scale = radius * all(1.0 / 1024);
    // unit() leaves alone what is unit but for its rounding; nearly all is.
    const Numbers square = dot(normal, normal);
    const Mask odd =
        mask & (less(way, scale * scale) | ~at_most(absolute(square - all(1.0)), all(4 * 0x1p-52)));
    put(mask & ~odd, two_sum(center, radius * normal), bound<6>() * radius, normal, s);
    return odd;
}

/// The points of hits with boxes, on their faces: surface_point().
LANCER_INLINE void put_boxes(const Scene& scene, const Rays& r, const NearestHits& hits, Mask mask,
                             Surfaces& s) {
    const Numbers zero = all(0.0);
    Vectors anchor{zero, zero, zero};
    Vectors width = anchor;
    Vectors normal = anchor;
    Mask across[3] = {0, 0, 0};
    for_each_lane(mask, [&](int i) {
        const Box& box = scene.boxes[scene.items[hits.item[i]].shape];
        const auto axis = static_cast<int>(hits.face[i] / 2);
        const bool at_max = hits.face[i] % 2 == 1;
        double corner[] = {box.min[0], box.min[1], box.min[2]};
        const double size[] = {box.max[0] - box.min[0], box.max[1] - box.min[1],
                               box.max[2] - box.min[2]};
        double out[] = {0, 0, 0};
        if (at_max) corner[axis] = box.max[axis];
        out[axis] = at_max ? 1 : -1;
        set_lane(anchor, i, corner);
        set_lane(width, i, size);
        set_lane(normal, i, out);
        across[axis] |= Mask(1) << i;
    });
    Vectors offset = start_from(r, anchor) + hits.t * r.dir;
    const auto keep_on_face = [&](Numbers& x, const Numbers& most, Mask is_across) {
        x = select(less(x, zero), zero, x);
        x = select(less(most, x), most, x);
        x = select(is_across, zero, x);
    };
    keep_on_face(offset.x, width.x, across[0]);
    keep_on_face(offset.y, width.y, across[1]);
    keep_on_face(offset.z, width.z, across[2]);
    put(mask, two_sum(anchor, offset), zero, normal, s);
}

/// The points of hits with one plane, put back onto it: surface_point().
LANCER_INLINE void put_plane(const Plane& plane, const Rays& r, const NearestHits& hits, Mask mask,
                             Surfaces& s) {
    const Vectors normal = all(plane.normal);
    Vectors anchor = all(plane.point);
    Vectors offset = start_from(r, anchor) + hits.t * r.dir;
    const Numbers zero = all(0.0);
    Vectors rest{zero, zero, zero};
    const auto slide = [&](int axis, const Numbers& origin, const Numbers& origin_lo,
                           const Numbers& dir, Numbers& to, Numbers& by, Numbers& low) {
        if (plane.normal[axis] != 0) return;
        to = origin;
        by = hits.t * dir;
        low = origin_lo;
    };
    slide(0, r.origin.x, r.origin_lo.x, r.dir.x, anchor.x, offset.x, rest.x);
    slide(1, r.origin.y, r.origin_lo.y, r.dir.y, anchor.y, offset.y, rest.y);
    slide(2, r.origin.z, r.origin_lo.z, r.dir.z, anchor.z, offset.z, rest.z);
    offset = offset - dot(normal, offset) * normal;
    const Numbers error = bound<4>() * dot(absolute(normal), absolute(offset));
    VectorPair place = two_sum(anchor, offset);
    const Mask exact = is_zero(rest);
    if ((mask & ~exact) != 0) {
        const VectorPair sum = two_sum(place.hi, place.lo + rest);
        place = {select(exact, place.hi, sum.hi), select(exact, place.lo, sum.lo)};
    }
    put(mask, place, error, all(plane.unit_normal), s);
}

[[gnu::noinline]] inline void put_exactly(ExactMethods& exact, const Rays& r,
                                          const NearestHits& hits, Mask mask, Surfaces& s) {
    for_each_lane(mask, [&](int i) {
        LaneSurface one;
        exact.surface(lane_ray(r, i), hits.lane(i), one);
        set_lane(s.position, i, one.position);
        set_lane(s.position_lo, i, one.position_lo);
        set_lane(s.geometric, i, one.geometric);
        set_lane(s.normal, i, one.normal);
        set_lane(s.color, i, one.color);
        set_lane(s.error, i, one.error);
        set_lane(s.opacity, i, one.opacity);
    });
}

/// Calls give(to, from) for all that a material gives a surface.
template <class Give>
LANCER_INLINE void give_finish(const Finish& f, Surfaces& s, const Give& give) {
    give(s.color, f.color);
    give(s.reflection, f.reflection);
    give(s.own, f.own);
    give(s.opacity, f.opacity);
    give(s.diffuse, f.diffuse);
    give(s.phong, f.phong);
    give(s.shininess, f.shininess);
    give(s.blinn, f.blinn);
    give(s.inverse_roughness, f.inverse_roughness);
    give(s.metallic, f.metallic);
    give(s.ior, f.ior);
    give(s.fresnel, f.fresnel);
}

LANCER_INLINE void put_finishes(const Scene& scene, const NearestHits& hits, Mask mask,
                                Surfaces& s) {
    const std::uint32_t first = scene.items[hits.item[__builtin_ctz(mask)]].material;
    bool one = true;
    for_each_lane(mask, [&](int i) { one = one && scene.items[hits.item[i]].material == first; });
    if (one) {
        give_finish(scene.finishes[first], s, [](auto& to, const auto& from) { to = all(from); });
        return;
    }
    for_each_lane(mask, [&](int i) {
        give_finish(scene.finishes[scene.items[hits.item[i]].material], s,
                    [i](auto& to, const auto& from) { set_lane(to, i, from); });
    });
}

/// The surfaces of the hits in the mask, which is not empty; other lanes hold numbers that nobody
/// reads.
inline void make_surfaces(const Job& job, const Rays& r, const NearestHits& hits, Mask mask,
                          Surfaces& s) {
    const Scene& scene = *job.scene;
    const Numbers zero = all(0.0);
    const Vectors zeros{zero, zero, zero};
    s = {zeros, zeros, zeros, zeros, zeros, zeros, zeros, zero, zero,
         zero,  zero,  zero,  zero,  zero,  zero,  zero,  zero};
    put_finishes(scene, hits, mask, s);
    Mask balls = 0;
    Mask planes = 0;
    Mask boxes = 0;
    Mask meshes = 0;
    Mask exact = 0;
    for_each_lane(mask, [&](int i) {
        const Item& item = scene.items[hits.item[i]];
        const Mask bit = Mask(1) << i;
        if (scene.finishes[item.material].textured)
            exact |= bit;
        else if (hits.item[i] >= scene.bounded)
            planes |= bit;
        else if (item.kind == Kind::ball)
            balls |= bit;
        else if (item.kind == Kind::box)
            boxes |= bit;
        else if (item.kind == Kind::mesh)
            meshes |= bit;
        else
            exact |= bit;
    });
    if (balls != 0) exact |= put_balls(scene, r, hits, balls, s);
    if (boxes != 0) put_boxes(scene, r, hits, boxes, s);
    while (planes != 0) {
        const std::uint32_t item = hits.item[__builtin_ctz(planes)];
        const Mask same = planes & equal(hits.item, item);
        put_plane(scene.planes[item - scene.bounded], r, hits, same, s);
        planes &= ~same;
    }
    while (meshes != 0) {
        const std::uint32_t item = hits.item[__builtin_ctz(meshes)];
        const Mask same = meshes & equal(hits.item, item);
        exact |= put_mesh(scene.meshes[scene.items[item].shape], hits, same, s);
        meshes &= ~same;
    }
    s.normal = select(less(zero, dot(s.normal, r.dir)), -s.normal, s.normal);
    if (exact != 0) put_exactly(*job.exact, r, hits, exact, s);
}

}  // namespace lancer::wide::LANCER_LEVEL
