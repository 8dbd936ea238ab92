// The surfaces of eight hits with balls, boxes and planes: surface_point() of shapes/ for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The points of hits with balls, projected onto the balls: surface_point().
///
/// \return hits that are left to scalar code: those so near to the start that another formula is
///         needed
LANCER_INLINE Mask put_balls(const Scene& scene, const Rays& r, const NearestHits& hits, Mask mask,
                             Surfaces& s) {
    Vectors center = all(scene.items[hits.item[__builtin_ctz(mask)]].ball.center);
    Numbers radius = all(1.0);
    for_each_item(hits.item, mask, [&](std::uint32_t item, Mask same) {
        const Ball& ball = scene.items[item].ball;
        center = select(same, all(ball.center), center);
        radius = select(same, all(ball.radius), radius);
    });
    Vectors normal = normalize(start_from(r, center) + hits.t * r.dir);
    const Numbers way = hits.t * hits.t * r.dir_squared;
    const Numbers scale = radius * all(1.0 / 1024);
    // unit() keeps vectors that are unit up to rounding, which nearly all are. The others are odd.
    const Numbers square = dot(normal, normal);
    const Mask odd =
        mask & (less(way, scale * scale) | ~at_most(absolute(square - all(1.0)), all(4 * 0x1p-52)));
    put(mask & ~odd, center, radius * normal, bound<6>() * radius, normal, s);
    return odd;
}

/// The points of hits with boxes, projected onto their faces: surface_point().
LANCER_INLINE void put_boxes(const Scene& scene, const Rays& r, const NearestHits& hits, Mask mask,
                             Surfaces& s) {
    const Numbers zero = all(0.0);
    Vectors anchor{zero, zero, zero};
    Vectors width = anchor;
    Vectors normal = anchor;
    Mask across[3] = {0, 0, 0};
    const auto put_face = [&](const Box& box, std::uint32_t face, Mask same) {
        const auto axis = static_cast<int>(face / 2);
        const bool at_max = face % 2 == 1;
        double corner[] = {box.min[0], box.min[1], box.min[2]};
        const double size[] = {box.max[0] - box.min[0], box.max[1] - box.min[1],
                               box.max[2] - box.min[2]};
        double out[] = {0, 0, 0};
        if (at_max) corner[axis] = box.max[axis];
        out[axis] = at_max ? 1 : -1;
        anchor = select(same, all(corner), anchor);
        width = select(same, all(size), width);
        normal = select(same, all(out), normal);
        across[axis] |= same;
    };
    for_each_item(hits.item, mask, [&](std::uint32_t item, Mask same) {
        const Box& box = scene.items[item].box;
        for_each_item(hits.face, same,
                      [&](std::uint32_t face, Mask alike) { put_face(box, face, alike); });
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
    put(mask, anchor, offset, zero, normal, s);
}

/// The points of hits with one plane, projected onto it: surface_point().
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
    s.note(mask, anchor, offset, error);
    s.note_rest(mask, rest);
    put(mask, place, error, all(plane.unit_normal), s);
}

}  // namespace lancer::wide::LANCER_LEVEL
