// Compiles those members of a light that only its kind has.
#pragma once

#include <numbers>

#include "model/light.h"
#include "tracer/scene/world.h"

namespace lancer {

/// Colour, shadows, position and fade of `made` are already set.
template <class Real>
struct LightCompiler {
    using Kind = typename LightSource<Real>::Kind;

    LightSource<Real>& made;
    int scale;  ///< World::scale_exponent

    void operator()(const PointLight&) const { made.kind = Kind::point; }
    void operator()(const DirectionalLight& light) const {
        made.kind = Kind::directional;
        made.direction = -unit_of(light.direction);
    }
    void operator()(const SpotLight& light) const {
        made.kind = Kind::spot;
        made.direction = unit_of(scaled(light.look_at, scale) - scaled(light.position, scale));
        made.cos_radius = cosine(light.radius);
        made.cos_falloff = cosine(light.falloff);
        made.tightness = static_cast<Real>(light.tightness);
    }

  private:
    static Vec3<Real> unit_of(const Vec3d& v) {
        return normalize(convert<Real>(v / max_component(absolute(v))));
    }
    static Real cosine(double degrees) {
        return elementary::cos(static_cast<Real>(degrees) *
                               static_cast<Real>(std::numbers::pi_v<Wide<Real>> / 180));
    }
};

}  // namespace lancer
