// Intersects eight rays with one mesh, with or without a transform: shapes/mesh.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

class MeshQuery {
  public:
    MeshQuery(const Scene& scene, const Mesh& mesh, std::uint32_t item, const Rays& world,
              const Starts& starts)
        : mesh_(*mesh.shape), starts_(starts), own_(equal(starts.item, item)) {
        rays_ = mesh.frame == nothing ? world : to_local(world, scene.frames[mesh.frame]);
    }

    /// The rays that start on the mesh.
    Mask own() const { return own_; }

    /// Starting faces are not left out.
    void keep_start_faces() { keeps_start_faces_ = true; }

    /// Calls met(hits, face) for every face that rays of the mask cross between 0 and `last`, with
    /// the rays that cross it. A ray's own start face is left out. Crossings behind the start may
    /// be among them. `met` returns the rays that need no further crossings.
    template <Order order, class Met>
    void crossings(Mask mask, const Numbers& last, Met&& met) {
        const Mask all_rays = mask;
        Shears shears;  // computed at the first leaf
        traverse<order>(mesh_.tree, nullptr, rays_, mask, last,
                        [&](std::uint32_t index, std::uint32_t count, Mask some) {
                            if (shears.count == 0) shears.set(rays_, mesh_.reach, all_rays);
                            mask &= ~leaf(shears, mesh_.leaves[index], static_cast<int>(count),
                                          some & mask, last, met);
                        });
    }

  private:
    /// Up to this many rays are tested one by one, with four triangles each.
    static constexpr int few = 2;

    template <class Met>
    LANCER_INLINE Mask leaf(const Shears& shears, const TriangleBlock& block, int count, Mask mask,
                            const Numbers& last, Met&& met) {
        Mask done = 0;
        for (int k = 0; k < shears.count; ++k) {
            const Shears::Group& g = shears.groups[k];
            const Mask some = mask & g.mask;
            if (some == 0) continue;
            if (__builtin_popcount(some) <= few) {
                for_each_lane(some, [&](int i) {
                    const Mask bit = Mask(1) << i;
                    const Mask met_by_it =
                        may_meet(block, rays_, shears, g, i) & ((1U << count) - 1);
                    for_each_lane(met_by_it, [&](int c) {
                        if ((done & bit) != 0) return;
                        done |=
                            meet(shears, g, block, c, TriangleCorners(block, c), bit, last, met);
                    });
                });
                continue;
            }
            for (int c = 0; c < count; ++c) {
                const TriangleCorners triangle(block, c);
                const Mask may = some & ~done & triangle.may_meet(rays_, shears, g);
                if (may != 0) done |= meet(shears, g, block, c, triangle, may, last, met);
            }
        }
        return done;
    }

    template <class Met>
    LANCER_INLINE Mask meet(const Shears& shears, const Shears::Group& g,
                            const TriangleBlock& block, int c, const TriangleCorners& triangle,
                            Mask mask, const Numbers& last, Met&& met) {
        const std::uint32_t face = block.face[c];
        if (!keeps_start_faces_) mask &= ~(own_ & equal(starts_.face, face));
        if (mask == 0) return 0;
        TriangleHits hits = intersect_exactly(triangle, rays_, shears, g, mask, last);
        if (hits.mask == 0) return 0;
        if (mesh_.inward != nullptr && mesh_.inward[face] != 0) hits.entering = ~hits.entering;
        return met(hits, face);
    }

    const MeshShape& mesh_;
    const Starts& starts_;
    const Mask own_;
    bool keeps_start_faces_ = false;
    Rays rays_;
};

[[gnu::noinline]] inline void mesh_crossings(const Scene& scene, const Mesh& mesh,
                                             std::uint32_t item, const Rays& r,
                                             const Starts& starts, Mask active, NearestHits& hits,
                                             const Ways& ways = {}) {
    MeshQuery query(scene, mesh, item, r, starts);
    query.crossings<Order::nearest_first>(
        active, hits.limit, [&](const TriangleHits& h, std::uint32_t face) {
            // At its start, a ray meets no other face of the mesh that it starts on, except where
            // it leaves a body that it is in (IntersectionFilter).
            const Mask counts = h.mask & ((h.entering & ways.in) | (~h.entering & ways.out));
            const Mask own = counts & query.own();
            const Mask ahead = less(h.error, h.t);
            hits.unsure |= own & ways.inside & ~ahead & ~less(h.t, -h.error);
            const Mask taken = hits.add(own & ahead, h.t, h.error, item, h.entering) |
                               hits.add_ahead(counts & ~own, h.t, h.error, item, h.entering);
            hits.set_triangle(taken, face, h.u, h.v);
            return Mask(0);
        });
}

/// Whether the mesh hides the light from eight rays.
struct MeshShadow {
    Mask blocks = 0;
    Mask unsure = 0;

    MeshShadow() = default;
    MeshShadow(const Scene& scene, const Mesh& mesh, std::uint32_t item, const Rays& r,
               const Starts& starts, Mask active, const Numbers& distance) {
        MeshQuery query(scene, mesh, item, r, starts);
        query.crossings<Order::any>(active, distance, [&](const TriangleHits& h, std::uint32_t) {
            const Mask ahead = less(h.error, h.t);
            const Mask behind = less(h.t, -h.error);
            const Mask before_light = less(h.t, distance - h.error);
            unsure |= h.mask & ~query.own() & ~ahead & ~behind;
            blocks |= h.mask & ahead & before_light;
            return blocks;
        });
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
