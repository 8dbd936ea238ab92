// Compiles a Scene to a World: number type, scale, primitives, trees. Only the files that
// instantiate it include it.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <thread>
#include <utility>

#include "model/bodies.h"
#include "model/diagnostic.h"
#include "model/light_facts.h"
#include "model/parts.h"
#include "model/plain_color.h"
#include "model/requirements.h"
#include "model/splines.h"
#include "tracer/bvh/build.h"
#include "tracer/compile/composite_compiler.h"
#include "tracer/compile/light_compiler.h"
#include "tracer/compile/primitive_bounds.h"
#include "tracer/compile/scale.h"
#include "tracer/compile/shape_compiler.h"
#include "tracer/compile/texture_compiler.h"
#include "tracer/shapes/mesh_build.h"

namespace lancer {

/// A deeper recursion would need more stack than a thread has, and would change no picture visibly.
inline constexpr int deepest = 1000;

template <class Real>
class Compiler {
  public:
    Compiler(const Scene& scene, const Settings& settings, const PovRayRules* by_povray)
        : scene_(scene),
          settings_(settings),
          by_povray_(by_povray),
          requirements_(requirements_of(scene, settings)),
          world_(std::make_unique<World<Real>>()) {
        threads_ = settings.threads > 0 ? settings.threads
                                        : static_cast<int>(std::thread::hardware_concurrency());
    }

    std::unique_ptr<World<Real>> run() {
        if (settings_.max_depth > deepest)
            throw SceneError({}, "max_depth above 1000 is not supported");
        world_->settings = settings_;
        world_->has_transmission = requirements_.needs(Feature::transmission);
        world_->has_media = requirements_.needs(Feature::media);
        world_->has_smooth_media = requirements_.needs(Feature::smooth_media);
        world_->has_textures = requirements_.needs(Feature::textures);
        world_->scale_exponent = scale_exponent(scene_);
        world_->background = in_range(scene_.background, {}, "background");
        if (scene_.sky) add_sky(*scene_.sky);
        world_->ambient = in_range(scene_.ambient, {}, "ambient");
        for (const Material& m : scene_.materials) add_finish(m);
        if (world_->has_textures) compile_textures(scene_, *world_);
        for (const Light& light : scene_.lights) add_light(light);
        add_objects();
        add_tree();
        list_mediums();
        return std::move(world_);
    }

  private:
    using MeshTable = std::map<std::uint32_t, const TriangleMesh<Real>*>;

    int scale() const { return world_->scale_exponent; }

    Vec3<Real> in_range(const Vec3d& v, const SourceSpan& place, const char* what) const {
        const Vec3<Real> r = convert<Real>(v);
        if (!is_finite(r))
            throw SceneError(place,
                             std::string(what) + " leaves the range of the chosen precision");
        return r;
    }
    Real length_in_world(double x) const { return ldexp(static_cast<Real>(x), scale()); }

    void add_sky(const Gradient& from) {
        const Vec3<Wide<Real>> axis =
            convert<Wide<Real>>(from.axis / max_component(absolute(from.axis)));
        SkyPattern<Real> sky;
        sky.axis = convert<Real>(normalize(axis));
        for (const Gradient::Stop& stop : from.stops)
            sky.stops.push_back({static_cast<Real>(stop.at), in_range(stop.color, {}, "the sky")});
        world_->sky = std::move(sky);
    }

    void add_finish(const Material& m) {
        Finish<Real> f;
        f.color = in_range(settings_.textures ? m.color : plain_color(scene_, m), {},
                           "a material's color");
        f.texture = settings_.textures ? m.texture : none;
        f.ambient = static_cast<Real>(m.ambient);
        f.diffuse = static_cast<Real>(m.diffuse);
        f.emission = in_range(m.emission, {}, "a material's emission");
        f.phong = static_cast<Real>(m.phong);
        f.shininess = static_cast<Real>(m.shininess);
        f.blinn = static_cast<Real>(m.blinn);
        f.inverse_roughness = 1 / static_cast<Real>(m.roughness);
        f.metallic = static_cast<Real>(m.metallic);
        f.reflection = in_range(m.reflection, {}, "a material's reflection");
        f.fresnel = m.fresnel;
        f.transmission = static_cast<Real>(m.transmission);
        f.filter = static_cast<Real>(m.filter);
        f.ior = static_cast<Real>(m.ior);
        const Vec3d& a = m.absorption;
        f.absorption = Vec3<Real>(ldexp(static_cast<Real>(a.x), -scale()),
                                  ldexp(static_cast<Real>(a.y), -scale()),
                                  ldexp(static_cast<Real>(a.z), -scale()));
        f.absorbs = max_component(f.absorption) > 0;
        f.diffuse_transmission = static_cast<Real>(m.diffuse_transmission);
        f.phong_transmission = static_cast<Real>(m.phong_transmission);
        f.lit_from_behind = m.diffuse_transmission > 0 || m.phong_transmission > 0;
        world_->finishes.push_back(f);
    }

    void add_light(const Light& light) {
        LightSource<Real> s{};
        s.color = in_range(light.color, light.place, "a light's color");
        s.shadows = light.shadows;
        const LightFacts facts = facts_of(light.kind);
        if (facts.position) s.position = convert<Real>(scaled(*facts.position, scale()));
        if (facts.fade && *facts.fade) {
            s.fades = true;
            s.fade_distance = length_in_world((*facts.fade)->distance);
            s.fade_power = static_cast<Real>((*facts.fade)->power);
        }
        std::visit(LightCompiler<Real>{s, scale()}, light.kind);
        world_->lights.push_back(s);
    }

    void add_objects() {
        const MeshTable meshes = mesh_needs();
        std::vector<Primitive<Real>> unbounded;
        std::vector<Primitive<Real>> planes;
        std::vector<Primitive<Real>>& bounded = world_->primitives;
        bounded.reserve(scene_.objects.size());
        ShapeCompiler<Real> solids(scene_, settings_, by_povray_, *world_);
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
        world_->bounded = static_cast<std::uint32_t>(bounded.size());
        bounded.insert(bounded.end(), unbounded.begin(), unbounded.end());
        world_->planes = static_cast<std::uint32_t>(bounded.size());
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
        if (world_->finishes[object.material].texture != none) {
            p.texture_binding = static_cast<std::uint32_t>(world_->texture_bindings.size());
            world_->texture_bindings.push_back(
                bind_texture(scene_, *world_, object, p, solids.own_exponent(object, mesh), space));
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
        CompositeCompiler<Real> tree(composite, *world_);
        for (const Composite::Leaf& leaf : composite.leaves) {
            const Primitive<Real> made = part(solids, leaf.object, leaf.texture_space, meshes);
            p.transmissive = p.transmissive || made.transmissive;
            check_size(made, leaf.object);
            tree.add(made);
        }
        world_->composites.push_back(
            std::make_unique<CompositeTree<Real>>(tree.finish(*world_, object.place, threads_)));
        p.solid = CompositeSolid<Real>{world_->composites.back().get()};
        return p;
    }

    /// Squares of sizes must stay in the number type's range.
    void check_size(const Primitive<Real>& p, const Object& object) const {
        using std::sqrt;
        const bool vanishes = std::visit([](const auto& solid) { return solid.size(); }, p.solid) <
                              16 * sqrt(std::numeric_limits<Real>::min());
        const Bounds<Real> box = bounds_of(*world_, p);
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
            world_->meshes.push_back(
                compile_mesh<Real>(scene_.meshes[index], exponent, n, threads_));
            table[index] = world_->meshes.back().get();
        }
        return table;
    }
    const TriangleMesh<Real>* mesh_of(const Object& object, const MeshTable& table) const {
        const auto* ref = std::get_if<MeshRef>(&object.shape);
        return ref == nullptr ? nullptr : table.at(ref->mesh);
    }

    void add_tree() {
        std::vector<Bounds<Real>> boxes;
        boxes.reserve(world_->bounded);
        Bounds<Real> all;
        for (std::uint32_t i = 0; i < world_->bounded; ++i) {
            const Primitive<Real>& p = world_->primitives[i];
            check_size(p, scene_.objects[p.object]);
            boxes.push_back(box_in_tree(*world_, p));
            all.extend(bounds_of(*world_, p));
        }
        world_->bvh = build_bvh(std::move(boxes), most_in_leaf(), threads_);
        if (world_->bounded > 0) {  // begin_near_scene() reads it; it must not depend on the tree
            world_->bvh.bounds = widened(all);
            world_->bvh.reach = world_->bvh.bounds.reach();
        }
        put_in_leaf_order();
    }

    /// A box test costs a few instructions; mapping a ray to the space of a mesh or a patch costs
    /// some hundred. If most primitives are of that kind, each has its own box.
    std::uint32_t most_in_leaf() const {
        std::uint32_t expensive = 0;
        for (std::uint32_t i = 0; i < world_->bounded; ++i) {
            const Solid<Real>& solid = world_->primitives[i].solid;
            expensive += std::holds_alternative<MeshInstance<Real>>(solid) ||
                         std::holds_alternative<BicubicSolid<Real>>(solid) ||
                         std::holds_alternative<PatchSolid<Real>>(solid) ||
                         std::holds_alternative<LatheSolid<Real>>(solid);
        }
        return expensive > world_->bounded / 2 ? 1 : 2;
    }

    /// Sorts the primitives into leaf order, so that primitives that are visited together lie
    /// together in memory. It moves them cycle by cycle, so no second copy of the array is needed.
    void put_in_leaf_order() {
        std::vector<Primitive<Real>>& primitives = world_->primitives;
        std::vector<std::uint32_t>& order = world_->bvh.order;
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
        if (!world_->has_media) return;
        struct Entry {
            std::uint32_t primitive;
            Bounds<Real> box;
            Real size;
        };
        std::vector<Entry> entries;
        constexpr Real infinity = std::numeric_limits<Real>::infinity();
        for (std::uint32_t i = 0; i < world_->primitives.size(); ++i) {
            if (!world_->primitives[i].medium) continue;
            Bounds<Real> box = around(Vec3<Real>(0), Vec3<Real>(infinity));
            Real size = infinity;
            if (i < world_->bounded) {
                box = widened(bounds_of(*world_, world_->primitives[i]));
                const Vec3<Real> d = box.max - box.min;
                size = d.x * d.y * d.z;
            }
            entries.push_back({i, box, size});
        }
        std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
            if (a.size != b.size) return a.size > b.size;
            return world_->primitives[a.primitive].object < world_->primitives[b.primitive].object;
        });
        for (const Entry& e : entries) {
            world_->primitives[e.primitive].medium_slot =
                static_cast<std::uint32_t>(world_->mediums.size());
            world_->mediums.push_back(e.primitive);
            world_->medium_bounds.push_back(e.box);
        }
    }

    const Scene& scene_;
    const Settings& settings_;
    const PovRayRules* by_povray_;
    const Requirements requirements_;
    std::unique_ptr<World<Real>> world_;
    int threads_ = 1;
};

/// Compiles for one number type. Throws SceneError, with the place in the script, if a coordinate
/// or colour leaves the type's range.
///
/// \param by_povray  POV-Ray's rules, by which shapes are then drawn; may be null
template <class Real>
std::unique_ptr<World<Real>> compile_world(const Scene& scene, const Settings& settings,
                                           const PovRayRules* by_povray = nullptr) {
    return Compiler<Real>(scene, settings, by_povray).run();
}

}  // namespace lancer
