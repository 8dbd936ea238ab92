// Intersects one of eight rays with a mesh that has a transform: it maps the ray alone to the
// mesh's space, and tests the triangles of a leaf side by side.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The mesh that an item is; null if it is none.
LANCER_INLINE const Mesh* mesh_of(const Scene& scene, std::uint32_t index) {
    if (scene.meshes_of_items != nullptr) return scene.meshes_of_items + index;
    const Item& item = scene.items[index];
    return item.kind == Kind::mesh ? scene.meshes + item.shape.index : nullptr;
}

/// Whether the rays are so few that they are better traced one by one.
LANCER_INLINE bool is_better_alone(const Scene& scene, const Mesh& mesh, Mask mask) {
    const int few = scene.meshes_of_items != nullptr ? few_rays_among_meshes : few_rays;
    return mesh.frame != nothing && __builtin_popcount(mask) <= few;
}

class LoneMeshQuery {
  public:
    LoneMeshQuery(const Mesh& mesh, const Rays& world, int i)
        : placed_(mesh),
          mesh_(*mesh.shape),
          ray_(world, i, mesh),
          world_error_(lane(world.origin_error, i)) {}

    /// Calls met(hit) for every face, except for `start_face`, that the ray crosses between 0 and
    /// `last`. Crossings behind the start may be among them. `met` returns true to stop.
    ///
    /// \param last  last() returns the parameter up to which crossings are wanted
    template <Order order, class Last, class Met>
    LANCER_INLINE void crossings(std::uint32_t start_face, const Last& last, const Met& met) {
        const LoneBoxRay box_ray(mesh_.tree, ray_, last());
        if (box_ray.misses) return;
        descend<order>(
            mesh_.tree, nullptr, box_ray.slabs, 0, [&] { return box_ray.parameter(last()); },
            [&](std::uint32_t index, std::uint32_t count) {
                if (shears_.count == 0) set_shear();  // not needed before the first leaf
                const TriangleBlock& block = mesh_.leaves[index];
                Mask some = filter_.may_meet(block) & ((1U << count) - 1);
                if (start_face != nothing) {
                    for_each_lane(some, [&](int c) {
                        if (block.face[c] == start_face) some &= ~(1U << c);
                    });
                }
                return some != 0 && meet(block, some, last(), met);
            });
    }

  private:
    [[gnu::noinline]] void set_shear() {
        double dir[4], inverse[4], size[4], origin[4];
        store(dir, ray_.dir);
        store(inverse, ray_.inv_dir);
        store(size, absolute(ray_.dir));
        store(origin, ray_.origin);
        Shears::Group& g = shears_.groups[0];
        g.z = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
        const bool backward = dir[g.z] < 0;
        g.x = (g.z + (backward ? 2 : 1)) % 3;
        g.y = (g.z + (backward ? 1 : 2)) % 3;
        g.mask = 255;
        shears_.count = 1;
        const double sz = inverse[g.z];
        filter_.x = g.x;
        filter_.y = g.y;
        filter_.z = g.z;
        filter_.sx = four(dir[g.x] * sz);
        filter_.sy = four(dir[g.y] * sz);
        filter_.ox = four(origin[g.x]);
        filter_.oy = four(origin[g.y]);
        filter_.oz = four(origin[g.z]);
        const double error = ray_.error(world_error_, placed_);
        double noise = 0;
        if (!ray_.whole) {
            double place[4];
            store(place, absolute(ray_.origin));
            const double filter_error =
                gamma<double, 16> * (place[0] + place[1] + place[2]) + error;
            const double places = mesh_.reach + filter_error * (1 / gamma<double, 16>);
            noise = gamma<double, 512> * places * places;
        }
        filter_.noise = four(noise);
        shears_.sx = all(first(filter_.sx));
        shears_.sy = all(first(filter_.sy));
        shears_.sz = all(sz);
        rays_.origin = all(ray_.origin);
        rays_.origin_lo = all(ray_.origin_lo);
        rays_.origin_error = all(error);
        rays_.whole = ray_.whole ? 255 : 0;
    }

    /// Intersects the triangles of the mask, side by side.
    template <class Met>
    [[gnu::noinline]] bool meet(const TriangleBlock& block, Mask mask, double last,
                                const Met& met) const {
        const TriangleHits hits = intersect_exactly(TriangleCorners(block), rays_, shears_,
                                                    shears_.groups[0], mask, all(last));
        for (Mask left = hits.mask; left != 0; left &= left - 1) {
            const int c = __builtin_ctz(left);
            const std::uint32_t face = block.face[c];
            const bool inward = mesh_.inward != nullptr && mesh_.inward[face] != 0;
            const LaneHit hit{lane(hits.t, c),
                              lane(hits.error, c),
                              lane(hits.u, c),
                              lane(hits.v, c),
                              nothing,
                              face,
                              ((hits.entering >> c & 1) != 0) != inward};
            if (met(hit)) return true;
        }
        return false;
    }

    const Mesh& placed_;
    const MeshShape& mesh_;
    const LoneRay ray_;
    const double world_error_;
    LoneShear filter_;
    Shears shears_;
    Rays rays_;  ///< the ray in all lanes; only `origin`, `origin_lo`, `origin_error`, `whole`
};

/// mesh_crossings() for one ray
[[gnu::noinline]] inline void lone_mesh_crossings(const Mesh& mesh, std::uint32_t item,
                                                  const Rays& r, const Starts& starts, int i,
                                                  NearestHits& hits, const Ways& ways = {}) {
    LoneMeshQuery query(mesh, r, i);
    const bool own = starts.item[i] == item;
    const bool inside = (ways.inside >> i & 1) != 0;
    query.crossings<Order::nearest_first>(
        own ? starts.face[i] : nothing, [&] { return lane(hits.limit, i); },
        [&](LaneHit hit) {
            const Mask way = hit.entering ? ways.in : ways.out;
            if (hit.t < -hit.error || (way >> i & 1) == 0) return false;
            hit.item = item;
            if (hit.error < hit.t)
                hits.add(i, hit);
            else if (!own || inside)
                hits.unsure |= Mask(1) << i;
            return false;
        });
}

/// MeshShadow for one ray
[[gnu::noinline]] inline MeshShadow lone_mesh_shadow(const Mesh& mesh, std::uint32_t item,
                                                     const Rays& r, const Starts& starts, int i,
                                                     double distance) {
    LoneMeshQuery query(mesh, r, i);
    const bool own = starts.item[i] == item;
    MeshShadow shadow;
    const Mask bit = Mask(1) << i;
    query.crossings<Order::any>(
        own ? starts.face[i] : nothing, [&] { return distance; },
        [&](const LaneHit& hit) {
            const bool ahead = hit.error < hit.t;
            if (!own && !ahead && !(hit.t < -hit.error)) shadow.unsure |= bit;
            if (ahead && hit.t < distance - hit.error) shadow.blocks |= bit;
            return shadow.blocks != 0;
        });
    return shadow;
}

}  // namespace lancer::wide::LANCER_LEVEL
