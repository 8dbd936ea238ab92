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

/// Sets what surfaces take from their materials. The first material is given to all lanes.
LANCER_INLINE void put_finishes(const Scene& scene, const std::uint32_t* materials, Mask mask,
                                Surfaces& s) {
    const std::uint32_t first = materials[__builtin_ctz(mask)];
    give_finish(scene.finishes[first], s, [](auto& to, const auto& from) { to = all(from); });
    for_each_item(materials, mask & ~equal(materials, first), [&](std::uint32_t other, Mask same) {
        give_finish(scene.finishes[other], s,
                    [same](auto& to, const auto& from) { to = select(same, all(from), to); });
    });
}

/// Makes the surfaces of the hits in the mask, which is not empty. Other lanes hold meaningless
/// numbers.
inline void make_surfaces(const Job& job, const Rays& r, const NearestHits& hits, Mask mask,
                          Surfaces& s) {
    const Scene& scene = *job.scene;
    const Numbers zero = all(0.0);
    const Vectors zeros{zero, zero, zero};
    // Member by member: the rest comes from the materials.
    s.position = s.position_lo = s.geometric = s.normal = zeros;
    s.error = zero;
    s.points = nullptr;
    put_some(s.convex, 255, nothing);
    Mask balls = 0;
    Mask planes = 0;
    Mask boxes = 0;
    Mask meshes = 0;
    Mask frustums = 0;
    Mask tori = 0;
    Mask patches = 0;
    Mask exact = 0;
    Mask textured = 0;
    alignas(32) std::uint32_t materials[lanes]{};
    for_each_item(hits.item, mask, [&](std::uint32_t index, Mask same) {
        const Item& item = scene.items[index];
        put_some(materials, same, item.material);
        if (item.convex) put_some(s.convex, same, index);
        if (scene.finishes[item.material].textured) {
            if (scene.texture_of == nullptr || scene.texture_of[index] == nothing) {
                exact |= same;
                return;
            }
            textured |= same;
        }
        if (index >= scene.bounded)
            planes |= same;
        else if (item.kind == Kind::ball)
            balls |= same;
        else if (item.kind == Kind::box)
            boxes |= same;
        else if (item.kind == Kind::mesh)
            meshes |= same;
        else if (item.kind == Kind::frustum)
            frustums |= same;
        else if (item.kind == Kind::torus)
            tori |= same;
        else if (item.kind == Kind::patch)
            patches |= same;
        else
            exact |= same;
    });
    put_finishes(scene, materials, mask, s);
    SurfacePoints points;
    if (textured != 0) {
        points = {zeros, zeros, zeros, zero};
        s.points = &points;
    }
    if (balls != 0) exact |= put_balls(scene, r, hits, balls, s);
    if (boxes != 0) put_boxes(scene, r, hits, boxes, s);
    if (frustums != 0) exact |= put_frustums(scene, r, hits, frustums, s);
    for_each_item(hits.item, planes, [&](std::uint32_t item, Mask same) {
        put_plane(scene.planes[item - scene.bounded], r, hits, same, s);
    });
    for_each_item(hits.item, meshes, [&](std::uint32_t item, Mask same) {
        exact |= put_mesh(scene, scene.meshes[scene.items[item].shape.index], hits, same, s);
    });
    for_each_item(hits.item, tori, [&](std::uint32_t item, Mask same) {
        exact |= put_torus(scene, scene.tori[scene.items[item].shape.index], r, hits, same, s);
    });
    while (patches != 0) {
        const int any = __builtin_ctz(patches);
        const std::uint32_t item = hits.item[any];
        const Mask same = patches & equal(hits.item, item) & equal(hits.face, hits.face[any]);
        exact |= put_piece(job, scene.patches[scene.items[item].shape.index], hits, same, s);
        patches &= ~same;
    }
    s.normal = select(less(zero, dot(s.normal, r.dir)), -s.normal, s.normal);
    textured &= ~exact;
    if (textured != 0) put_texture_colors(scene, hits, points, textured, s);
    s.points = nullptr;
    if (exact != 0) put_exactly(*job.exact, r, hits, exact, s);
}

}  // namespace lancer::wide::LANCER_LEVEL
