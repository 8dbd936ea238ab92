// The surfaces of eight hits: make_surface() for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

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
        if (one.outermost) s.convex[i] = hits.item[i];
    });
}

/// Calls give(to, from) for all members that a surface takes from its material.
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
    alignas(32) std::uint32_t materials[lanes]{};
    for_each_lane(mask, [&](int i) { materials[i] = scene.items[hits.item[i]].material; });
    const std::uint32_t first = materials[__builtin_ctz(mask)];
    give_finish(scene.finishes[first], s, [](auto& to, const auto& from) { to = all(from); });
    mask &= ~equal(materials, first);
    while (mask != 0) {
        const std::uint32_t next = materials[__builtin_ctz(mask)];
        const Mask same = mask & equal(materials, next);
        give_finish(scene.finishes[next], s,
                    [same](auto& to, const auto& from) { to = select(same, all(from), to); });
        mask &= ~same;
    }
}

/// Makes the surfaces of the hits in the mask, which is not empty. Other lanes hold meaningless
/// numbers.
inline void make_surfaces(const Job& job, const Rays& r, const NearestHits& hits, Mask mask,
                          Surfaces& s) {
    const Scene& scene = *job.scene;
    const Numbers zero = all(0.0);
    const Vectors zeros{zero, zero, zero};
    s = {zeros, zeros, zeros, zeros, zeros, zeros, zeros, zero, zero,   zero,
         zero,  zero,  zero,  zero,  zero,  zero,  zero,  {},   nullptr};
    put_some(s.convex, 255, nothing);
    put_finishes(scene, hits, mask, s);
    Mask balls = 0;
    Mask planes = 0;
    Mask boxes = 0;
    Mask meshes = 0;
    Mask frustums = 0;
    Mask tori = 0;
    Mask patches = 0;
    Mask exact = 0;
    Mask textured = 0;
    for_each_lane(mask, [&](int i) {
        const Item& item = scene.items[hits.item[i]];
        const Mask bit = Mask(1) << i;
        if (item.convex) s.convex[i] = hits.item[i];
        if (scene.finishes[item.material].textured) {
            if (scene.texture_of == nullptr || scene.texture_of[hits.item[i]] == nothing) {
                exact |= bit;
                return;
            }
            textured |= bit;
        }
        if (hits.item[i] >= scene.bounded)
            planes |= bit;
        else if (item.kind == Kind::ball)
            balls |= bit;
        else if (item.kind == Kind::box)
            boxes |= bit;
        else if (item.kind == Kind::mesh)
            meshes |= bit;
        else if (item.kind == Kind::frustum)
            frustums |= bit;
        else if (item.kind == Kind::torus)
            tori |= bit;
        else if (item.kind == Kind::patch)
            patches |= bit;
        else
            exact |= bit;
    });
    SurfacePoints points;
    if (textured != 0) {
        points = {zeros, zeros, zero};
        s.points = &points;
    }
    if (balls != 0) exact |= put_balls(scene, r, hits, balls, s);
    if (boxes != 0) put_boxes(scene, r, hits, boxes, s);
    if (frustums != 0) exact |= put_frustums(scene, r, hits, frustums, s);
    while (planes != 0) {
        const std::uint32_t item = hits.item[__builtin_ctz(planes)];
        const Mask same = planes & equal(hits.item, item);
        put_plane(scene.planes[item - scene.bounded], r, hits, same, s);
        planes &= ~same;
    }
    while (meshes != 0) {
        const std::uint32_t item = hits.item[__builtin_ctz(meshes)];
        const Mask same = meshes & equal(hits.item, item);
        exact |= put_mesh(scene, scene.meshes[scene.items[item].shape], hits, same, s);
        meshes &= ~same;
    }
    while (tori != 0) {
        const std::uint32_t item = hits.item[__builtin_ctz(tori)];
        const Mask same = tori & equal(hits.item, item);
        exact |= put_torus(scene, scene.tori[scene.items[item].shape], r, hits, same, s);
        tori &= ~same;
    }
    while (patches != 0) {
        const int any = __builtin_ctz(patches);
        const std::uint32_t item = hits.item[any];
        const Mask same = patches & equal(hits.item, item) & equal(hits.face, hits.face[any]);
        exact |= put_piece(job, scene.patches[scene.items[item].shape], hits, same, s);
        patches &= ~same;
    }
    s.normal = select(less(zero, dot(s.normal, r.dir)), -s.normal, s.normal);
    textured &= ~exact;
    if (textured != 0) put_texture_colors(scene, hits, points, textured, s);
    s.points = nullptr;
    if (exact != 0) put_exactly(*job.exact, r, hits, exact, s);
}

}  // namespace lancer::wide::LANCER_LEVEL
