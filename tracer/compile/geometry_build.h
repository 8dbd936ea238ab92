// The compiler of shapes, for the one file in which a number type is instantiated.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <thread>
#include <utility>

#include "model/bodies.h"
#include "model/diagnostic.h"
#include "model/parts.h"
#include "model/splines.h"
#include "tracer/bvh/build.h"
#include "tracer/compile/composite_compiler.h"
#include "tracer/compile/geometry.h"
#include "tracer/compile/primitive_bounds.h"
#include "tracer/compile/scale.h"
#include "tracer/compile/shape_compiler.h"
#include "tracer/compile/texture_binder.h"
#include "tracer/shapes/mesh_build.h"

namespace lancer {

template <class Real>
class GeometryCompiler {
  public:
    GeometryCompiler(const Scene& scene, const Settings& settings, const Requirements& requirements,
                     const PovRayRules* by_povray, Geometry<Real>& geometry)
        : scene_(scene),
          settings_(settings),
          by_povray_(by_povray),
          requirements_(requirements),
          geometry_(geometry),
          threads_(settings.threads > 0 ? settings.threads
                                        : static_cast<int>(std::thread::hardware_concurrency())) {}

    void run() {
        geometry_.has_transmission = requirements_.needs(Feature::transmission);
        geometry_.has_media = requirements_.needs(Feature::media);
        geometry_.has_smooth_media = requirements_.needs(Feature::smooth_media);
        add_objects();
        add_tree();
        list_mediums();
    }

  private:
    using MeshTable = std::map<std::uint32_t, const TriangleMesh<Real>*>;

    void add_objects() {
        const MeshTable meshes = mesh_needs();
        std::vector<Primitive<Real>> unbounded;
        std::vector<Primitive<Real>> planes;
        std::vector<Primitive<Real>>& bounded = geometry_.primitives;
        bounded.reserve(scene_.objects.size());
        ShapeCompiler<Real> solids(scene_, settings_, by_povray_, geometry_);
        for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
            const Object& object = scene_.objects[i];
            if (is_nothing(object.shape)) continue;
            const auto* made = std::get_if<CompositeRef>(&object.shape);
            Primitive<Real> p =
                made == nullptr ? part(solids, object, object.transform, meshes)
                                : whole(solids, scene_.composites[made->composite], object, meshes);
            p.object = i;
            p.casts_shadow = object.casts_shadow;
            p.medium = requirements_.is_medium(i);
            // Whether a mesh has an inside is computed only when it matters.
            p.body = std::holds_alternative<MeshRef>(object.shape) ? p.medium
                                                                   : is_body(scene_, object.shape);
            p.convex = traits_of(p.solid).convex;
            if (made == nullptr)
                (std::holds_alternative<HalfSpace<Real>>(p.solid) ? planes : bounded).push_back(p);
            else if (const Bounds<Real>& box = p.composite()->bounds; !is_empty(box))
                (is_finite(box.min) && is_finite(box.max) ? bounded : unbounded).push_back(p);
        }
        geometry_.bounded = static_cast<std::uint32_t>(bounded.size());
        bounded.insert(bounded.end(), unbounded.begin(), unbounded.end());
        geometry_.planes = static_cast<std::uint32_t>(bounded.size());
        bounded.insert(bounded.end(), planes.begin(), planes.end());
    }

    /// The primitive of one shape, which is an object or a leaf of a composite.
    ///
    /// \param space  the space of its texture: see bind_texture()
    Primitive<Real> part(ShapeCompiler<Real>& solids, const Object& object, std::uint32_t space,
                         const MeshTable& meshes) {
        const TriangleMesh<Real>* mesh = mesh_of(object, meshes);
        Primitive<Real> p = solids.make(object, mesh);
        p.material = object.material;
        if (settings_.textures && scene_.materials[object.material].texture != none) {
            p.texture_binding = static_cast<std::uint32_t>(geometry_.texture_bindings.size());
            geometry_.texture_bindings.push_back(bind_texture(
                scene_, geometry_, object, p, solids.own_exponent(object, mesh), space));
        }
        p.transmissive =
            lets_light_through(scene_, scene_.materials[object.material], settings_.textures);
        return p;
    }

    /// The primitive of a composite.
    Primitive<Real> whole(ShapeCompiler<Real>& solids, const Composite& composite,
                          const Object& object, const MeshTable& meshes) {
        Primitive<Real> p;
        p.material = object.material;
        CompositeCompiler<Real> tree(composite, geometry_);
        for (const Composite::Leaf& leaf : composite.leaves) {
            const Primitive<Real> made = part(solids, leaf.object, leaf.texture_space, meshes);
            p.transmissive = p.transmissive || made.transmissive;
            check_size(made, leaf.object);
            tree.add(made);
        }
        geometry_.composites.push_back(
            std::make_unique<CompositeTree<Real>>(tree.finish(geometry_, object.place, threads_)));
        p.solid = CompositeSolid<Real>{geometry_.composites.back().get()};
        return p;
    }

    /// Squares of sizes must stay in the number type's range.
    void check_size(const Primitive<Real>& p, const Object& object) const {
        using std::sqrt;
        const bool vanishes = std::visit([](const auto& solid) { return solid.size(); }, p.solid) <
                              16 * sqrt(std::numeric_limits<Real>::min());
        const Bounds<Real> box = bounds_of(geometry_, p);
        const bool endless = std::holds_alternative<HalfSpace<Real>>(p.solid);
        if (vanishes || (!endless && !(is_finite(box.min) && is_finite(box.max))))
            throw SceneError(object.place, out_of_range);
    }

    /// A patch that is a single point has no surface.
    bool is_nothing(const Shape& shape) const {
        const auto* ref = std::get_if<PatchRef>(&shape);
        return ref != nullptr && is_single_point(scene_.patches[ref->patch].control);
    }

    /// Compiles every mesh that some object uses, once.
    MeshTable mesh_needs() {
        std::map<std::uint32_t, MeshNeeds> needs;
        for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
            const Object& object = scene_.objects[i];
            for_each_part(scene_, object, [&](const Object& shown) {
                const auto* ref = std::get_if<MeshRef>(&shown.shape);
                if (ref == nullptr) return;
                MeshNeeds& n = needs[ref->mesh];
                n.normals |= ref->smooth && settings_.smooth;
                n.body |= requirements_.is_medium(i) || &shown != &object;
            });
        }
        MeshTable table;
        for (const auto& [index, n] : needs) {
            const int exponent = exponent_for(extent_of(MeshRef{index, true}, scene_));
            geometry_.meshes.push_back(
                compile_mesh<Real>(scene_.meshes[index], exponent, n, threads_));
            table[index] = geometry_.meshes.back().get();
        }
        return table;
    }
    const TriangleMesh<Real>* mesh_of(const Object& object, const MeshTable& table) const {
        const auto* ref = std::get_if<MeshRef>(&object.shape);
        return ref == nullptr ? nullptr : table.at(ref->mesh);
    }

    void add_tree() {
        std::vector<Bounds<Real>> boxes;
        boxes.reserve(geometry_.bounded);
        Bounds<Real> all;
        for (std::uint32_t i = 0; i < geometry_.bounded; ++i) {
            const Primitive<Real>& p = geometry_.primitives[i];
            check_size(p, scene_.objects[p.object]);
            boxes.push_back(box_in_tree(geometry_, p));
            all.extend(bounds_of(geometry_, p));
        }
        geometry_.bvh = build_bvh(std::move(boxes), most_in_leaf(), threads_);
        if (geometry_.bounded > 0) {  // begin_near_scene() reads it; it must not depend on the tree
            geometry_.bvh.bounds = widened(all);
            geometry_.bvh.reach = geometry_.bvh.bounds.reach();
        }
        put_in_leaf_order();
    }

    /// A box test costs a few instructions; mapping a ray to the space of a mesh or a patch costs
    /// some hundred. If most primitives are of that kind, each has its own box.
    std::uint32_t most_in_leaf() const {
        std::uint32_t expensive = 0;
        for (std::uint32_t i = 0; i < geometry_.bounded; ++i) {
            const Solid<Real>& solid = geometry_.primitives[i].solid;
            expensive += std::holds_alternative<MeshInstance<Real>>(solid) ||
                         std::holds_alternative<BicubicSolid<Real>>(solid) ||
                         std::holds_alternative<PatchSolid<Real>>(solid) ||
                         std::holds_alternative<LatheSolid<Real>>(solid);
        }
        return expensive > geometry_.bounded / 2 ? 1 : 2;
    }

    /// Sorts the primitives into leaf order, so that primitives that are visited together lie
    /// together in memory. It moves them cycle by cycle, so no second copy of the array is needed.
    void put_in_leaf_order() {
        std::vector<Primitive<Real>>& primitives = geometry_.primitives;
        std::vector<std::uint32_t>& order = geometry_.bvh.order;
        for (std::uint32_t i = 0; i < order.size(); ++i) {
            if (order[i] == i) continue;
            const Primitive<Real> first = primitives[i];
            std::uint32_t to = i;
            while (order[to] != i) {
                primitives[to] = primitives[order[to]];
                to = std::exchange(order[to], to);
            }
            primitives[to] = first;
            order[to] = to;
        }
    }

    void list_mediums() {
        if (!geometry_.has_media) return;
        struct Entry {
            std::uint32_t primitive;
            Bounds<Real> box;
            Real size;
        };
        std::vector<Entry> entries;
        constexpr Real infinity = std::numeric_limits<Real>::infinity();
        for (std::uint32_t i = 0; i < geometry_.primitives.size(); ++i) {
            if (!geometry_.primitives[i].medium) continue;
            Bounds<Real> box = around(Vec3<Real>(0), Vec3<Real>(infinity));
            Real size = infinity;
            if (i < geometry_.bounded) {
                box = widened(bounds_of(geometry_, geometry_.primitives[i]));
                const Vec3<Real> d = box.max - box.min;
                size = d.x * d.y * d.z;
            }
            entries.push_back({i, box, size});
        }
        std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
            if (a.size != b.size) return a.size > b.size;
            return geometry_.primitives[a.primitive].object <
                   geometry_.primitives[b.primitive].object;
        });
        for (const Entry& e : entries) {
            geometry_.primitives[e.primitive].medium_slot =
                static_cast<std::uint32_t>(geometry_.mediums.size());
            geometry_.mediums.push_back(e.primitive);
            geometry_.medium_bounds.push_back(e.box);
        }
    }

    const Scene& scene_;
    const Settings& settings_;
    const PovRayRules* by_povray_;
    const Requirements& requirements_;
    Geometry<Real>& geometry_;
    const int threads_;
};

template <class Real>
void compile_geometry(const Scene& scene, const Settings& settings,
                      const Requirements& requirements, const PovRayRules* by_povray,
                      Geometry<Real>& geometry) {
    GeometryCompiler<Real>(scene, settings, requirements, by_povray, geometry).run();
}

}  // namespace lancer
