// Light at a surface: mirror, Snell, Fresnel, absorption. The formulas are those of
// docs/shading.md. recursion/whitted.h uses them for glass.
#pragma once

#include <algorithm>
#include <numbers>

#include "tracer/numerics/rounding.h"

namespace lancer {

/// d mirrored at the plane with unit normal n.
template <class Real>
Vec3<Real> mirrored(const Vec3<Real>& d, const Vec3<Real>& n) {
    return normalize(d - 2 * dot(d, n) * n);
}

/// Refracts d at a surface with unit normal n, n·d <= 0. `ratio` is the index before over the index
/// after, and not 1. Returns false under total internal reflection.
///
/// q = 1 - ratio^2 (1 - c^2) is computed as (1 - ratio)(1 + ratio) + (ratio c)^2. This form has the
/// right sign near the critical angle, and a small relative error where ratio is near 1
/// (docs/numerics.md).
template <class Real>
bool refracted(const Vec3<Real>& d, const Vec3<Real>& n, Real ratio, Vec3<Real>& bent) {
    using std::sqrt;
    const Real c = -dot(d, n);
    const Real q = (1 - ratio) * (1 + ratio) + (ratio * c) * (ratio * c);
    if (q < 0) return false;
    // ratio d + (ratio c - sqrt q) n. For ratio near 1 the bracket is small, so it is computed
    // without cancellation, as
    // (ratio^2 c^2 - q) / (ratio c + sqrt q) = (ratio - 1)(ratio + 1) / (ratio c + sqrt q).
    const Real sum = ratio * c + sqrt(q);
    bent = normalize(ratio * d + (ratio - 1) * (ratio + 1) / sum * n);
    return true;
}

/// Reflectance of a dielectric for unpolarised light. `cosine` >= 0 is that of the angle of
/// incidence; `index` is the index after the surface over that before it. 1 under total internal
/// reflection. Cook, Torrance, "A Reflectance Model for Computer Graphics", ACM TOG 1(1) 1982,
/// eq. 3.
template <class Real>
Real fresnel_reflectance(Real cosine, Real index) {
    using std::sqrt;
    const Real g2 = (index - 1) * (index + 1) + cosine * cosine;
    if (g2 <= 0) return 1;
    const Real g = sqrt(g2);
    const Real a = (g - cosine) / (g + cosine);
    const Real b = (cosine * (g + cosine) - 1) / (cosine * (g - cosine) + 1);
    return a * a * (1 + b * b) / 2;
}

/// F of POV-Ray's `metallic`: the share of the highlight that keeps the light's own colour.
/// `cosine` is that of the angle between normal and light. An approximation of Fresnel's equations;
/// docs/shading.md has its source.
template <class Real>
Real metallic_share(Real cosine) {
    const Real x = elementary::acos(std::clamp(cosine, Real(-1), Real(1))) /
                   static_cast<Real>(std::numbers::pi_v<Wide<Real>> / 2);
    const Real f =
        Real(0.014567225L) / ((x - Real(1.12L)) * (x - Real(1.12L))) - Real(0.011612903L);
    return std::min(f, Real(1));
}

/// Beer-Lambert: the transmittance of a path of this length, which may be infinite.
template <class Real>
Vec3<Real> beer_lambert_transmittance(const Vec3<Real>& absorption, Real way) {
    const Real finite = std::min(way, std::numeric_limits<Real>::max());
    const auto left = [&](Real a) { return elementary::exp(-a * finite); };
    return {left(absorption.x), left(absorption.y), left(absorption.z)};
}

}  // namespace lancer
