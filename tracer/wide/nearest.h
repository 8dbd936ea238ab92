// The nearest contacts of eight rays: intersect/nearest_contact.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Adds the crossings with one item by the exact methods, for the rays of the mask.
[[gnu::noinline]] inline void exact_crossings(ExactMethods& exact, std::uint32_t item,
                                              const Rays& r, const Starts& starts, Mask mask,
                                              NearestHits& hits) {
    struct Lane {
        NearestHits& hits;
        int i;
    };
    for_each_lane(mask, [&](int i) {
        Lane own{hits, i};
        const HitSink sink{&own,
                           [](void* self) {
                               const Lane& to = *static_cast<Lane*>(self);
                               return lane(to.hits.limit, to.i);
                           },
                           [](void* self, const LaneHit& hit) {
                               const Lane& to = *static_cast<Lane*>(self);
                               to.hits.add(to.i, hit);
                           }};
        exact.crossings(item, lane_ray(r, i), starts.lane(i), sink);
    });
}

/// Adds the crossings with one item of the tree. The mask is not empty.
LANCER_INLINE void add_crossings(const Job& job, std::uint32_t index, const Rays& r,
                                 const Starts& starts, Mask mask, PatchSpaces& patches,
                                 NearestHits& hits) {
    const Scene& scene = *job.scene;
    if (const Mesh* mesh = mesh_of(scene, index)) {
        const Ways ways(mesh->clear, index, starts.bodies);
        if (is_better_alone(scene, *mesh, mask))
            for_each_lane(
                mask, [&](int i) { lone_mesh_crossings(*mesh, index, r, starts, i, hits, ways); });
        else
            mesh_crossings(scene, *mesh, index, r, starts, mask, hits, ways);
        return;
    }
    const Item& item = scene.items[index];
    if (item.kind == Kind::patch && !item.glassy) {
        const PatchRays& local = patches.rays_in(scene, scene.patches[item.shape.index], r, starts);
        patch_crossings(job, index, local, starts, mask, hits);
        return;
    }
    const Mask own = mask & equal(starts.item, index);
    const Mask others = mask & ~own;
    const Ways ways(item.clear, index, starts.bodies);
    Mask asked = mask;
    if (item.kind == Kind::ball) {
        asked = ball_crossings(item.ball, index, r, others, ways, hits);
        if (own != 0) crossings_from_ball(item.ball, index, r, own, ways, hits);
    } else if (item.kind == Kind::box) {
        // A box of glass is crossed by the same formula from its own surface. A ray that has left
        // it does not enter it again.
        const Mask left = item.clear ? others | (own & ways.inside) : others;
        asked = box_crossings(item.box, index, r, left, ways, hits);
        if (!item.clear) asked |= own;
    } else if (item.kind == Kind::frustum) {
        const Frustum& frustum = scene.frustums[item.shape.index];
        if (item.clear)
            asked = crossings_of_clear(frustum, index, r, starts, mask, ways, hits);
        else
            asked = own | (item.glassy ? FrustumGuess(frustum, r, others, hits.limit).unsettled
                                       : frustum_crossings(item.shape.around, frustum, index, r,
                                                           others, hits));
    } else if (item.kind == Kind::torus && !item.glassy) {
        asked = torus_crossings(scene, scene.tori[item.shape.index], index, r, mask, own, hits);
    }
    if (asked != 0) exact_crossings(*job.exact, index, r, starts, asked, hits);
}

inline void find_nearest(const Job& job, const Rays& r, const Starts& starts, Mask active,
                         NearestHits& hits) {
    const Scene& scene = *job.scene;
    for (std::uint32_t i = scene.bounded; i < scene.item_count; ++i) {
        // A line meets a plane once.
        const Mask mask = active & ~equal(starts.item, i) & ~equal(starts.left, i);
        plane_crossings(scene.planes[i - scene.bounded], i, r, mask, hits);
    }
    PatchSpaces patches;
    traverse<Order::nearest_first>(scene.tree, scene.meshes_of_items, r, active, hits.limit,
                                   [&](std::uint32_t first, std::uint32_t count, Mask met) {
                                       for (std::uint32_t i = first; i < first + count; ++i) {
                                           const Mask mask = met & ~equal(starts.left, i);
                                           if (mask != 0)
                                               add_crossings(job, i, r, starts, mask, patches,
                                                             hits);
                                       }
                                   });
    hits.unsure &= active;
}

}  // namespace lancer::wide::LANCER_LEVEL
