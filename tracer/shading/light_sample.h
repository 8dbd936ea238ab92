// The light that a lamp sends to a point, without shadows.
#pragma once

#include "tracer/numerics/rounding.h"
#include "tracer/scene/world.h"

namespace lancer {

template <class Real>
struct LightSample {
    Vec3<Real> direction;  ///< unit, from the point to the light
    Real distance;         ///< infinite for directional lights
    Vec3<Real> color;      ///< after fade and spotlight
};

template <class Real>
[[gnu::always_inline]] inline LightSample<Real> sample_light(const LightSource<Real>& light,
                                                             const Vec3<Real>& point,
                                                             const Vec3<Real>& point_lo) {
    using Kind = typename LightSource<Real>::Kind;
    if (light.kind == Kind::directional)
        return {light.direction, std::numeric_limits<Real>::infinity(), light.color};
    const Vec3<Real> way = -difference(point, point_lo, light.position);
    LightSample<Real> at{way, length(way), light.color};
    if (is_sound_square(length_squared(way))) {
        at.direction = way / at.distance;
    } else {
        const Real longest = max_component(absolute(way));
        if (!(longest > 0)) return {way, longest, way};  // all 0: the light is on the point
        const Vec3<Real> scaled = way / longest;
        const Real scaled_length = length(scaled);
        at.direction = scaled / scaled_length;
        at.distance = longest * scaled_length;
    }
    Real factor = 1;
    if (light.fades)
        factor = 2 / (1 + elementary::pow(at.distance / light.fade_distance, light.fade_power));
    switch (light.kind) {  // no default: the compiler warns of a missing kind
        case Kind::directional:
        case Kind::point:
            break;
        case Kind::spot: {
            const Real cosine = -dot(at.direction, light.direction);
            if (cosine <= 0) {
                factor = 0;
                break;
            }
            factor *= elementary::pow(cosine, light.tightness);
            if (cosine < light.cos_radius) {
                const Real x = std::max(
                    Real(0), (cosine - light.cos_falloff) / (light.cos_radius - light.cos_falloff));
                factor *= x * x * (3 - 2 * x);
            }
        }
    }
    at.color = at.color * factor;
    return at;
}

}  // namespace lancer
