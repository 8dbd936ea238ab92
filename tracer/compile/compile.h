// Compiles a Scene to a World: scale, materials, textures and lights here, shapes in geometry.h.
// Only the files that instantiate it include it.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "model/diagnostic.h"
#include "model/light_facts.h"
#include "model/plain_color.h"
#include "model/requirements.h"
#include "tracer/compile/geometry.h"
#include "tracer/compile/light_compiler.h"
#include "tracer/compile/scale.h"
#include "tracer/compile/texture_compiler.h"
#include "tracer/scene/povray_rules.h"

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
          world_(std::make_unique<World<Real>>()) {}

    std::unique_ptr<World<Real>> run() {
        if (settings_.max_depth > deepest)
            throw SceneError({}, "max_depth above 1000 is not supported");
        world_->settings = settings_;
        world_->has_textures = requirements_.needs(Feature::textures);
        world_->scale_exponent = scale_exponent(scene_);
        world_->background = in_range(scene_.background, {}, "background");
        if (scene_.sky) add_sky(*scene_.sky);
        world_->ambient = in_range(scene_.ambient, {}, "ambient");
        for (const Material& m : scene_.materials) add_finish(m);
        if (world_->has_textures) compile_textures(scene_, *world_);
        for (const Light& light : scene_.lights) add_light(light);
        compile_geometry<Real>(scene_, settings_, requirements_, by_povray_, *world_);
        mark_even_filters();
        return std::move(world_);
    }

  private:
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

    /// Marks the primitives that a shadow ray may cross without a look at the place.
    void mark_even_filters() {
        for (Primitive<Real>& p : world_->primitives) {
            const Finish<Real>& f = world_->finishes[p.material];
            p.filters_evenly = f.texture == none && !(p.medium && f.absorbs);
        }
    }

    const Scene& scene_;
    const Settings& settings_;
    const PovRayRules* by_povray_;
    const Requirements requirements_;
    std::unique_ptr<World<Real>> world_;
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
