// A compiled scene, as the tracer reads it. It never changes after it is compiled.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "tracer/scene/geometry.h"

namespace lancer {

/// A material in the tracer's number type, with values derived from it.
template <class Real>
struct Finish {
    Vec3<Real> color;
    std::uint32_t texture = none;
    Real ambient, diffuse;
    Vec3<Real> emission;
    Real phong, shininess, blinn, inverse_roughness, metallic;
    Vec3<Real> reflection;
    bool fresnel = false;
    Real transmission, filter, ior;
    Vec3<Real> absorption;
    bool absorbs = false;
    Real diffuse_transmission, phong_transmission;
    bool lit_from_behind = false;

    bool operator==(const Finish&) const = default;
};

template <class Real>
struct LightSource {
    enum class Kind { point, directional, spot };
    Kind kind;
    Vec3<Real> position;  ///< point, spot
    Vec3<Real>
        direction;  ///< unit; directional: towards the light; spot: its axis, away from the light
    Vec3<Real> color;
    bool shadows;  ///< false: a fill light
    bool fades = false;
    Real fade_distance = 1, fade_power = 2;
    Real cos_radius = 1, cos_falloff = 0, tightness = 0;  ///< spot
};

template <class Real>
struct World : Geometry<Real> {
    std::vector<Finish<Real>> finishes;
    std::vector<Pattern<Real>> textures;               ///< in the order of Scene::textures
    std::vector<std::shared_ptr<const Image>> images;  ///< `textures` point to them
    std::vector<LightSource<Real>> lights;
    Vec3<Real> background{0};
    std::optional<SkyPattern<Real>> sky;  ///< replaces `background`
    Vec3<Real> ambient{1};
    Settings settings;
    bool has_textures = false;
};

/// The colour of a ray that hits nothing.
template <class Real>
Vec3<Real> color_behind(const World<Real>& world, const Vec3<Real>& direction) {
    return world.sky ? color_at(*world.sky, direction) : world.background;
}

}  // namespace lancer
