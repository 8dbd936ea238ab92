// Checker and gradient: colours that depend only on the point.
#pragma once

#include <algorithm>
#include <vector>

#include "tracer/textures/placement.h"

namespace lancer {

template <class Real>
struct CheckerPattern {
    Vec3<Real> even;
    Vec3<Real> odd;
};

/// Cubes of edge 1: the parity of floor(x) + floor(y) + floor(z) decides.
template <class Real>
Vec3<Real> color_at(const CheckerPattern<Real>& checker, const PatternPoint<Real>& p) {
    using std::floor;
    bool odd = false;
    for (int i = 0; i < 3; ++i) {
        const Real whole = whole_part(p.at[i], p.bound[i]);
        odd ^= whole != 2 * floor(whole / 2);  // exact for numbers of any size
    }
    return odd ? checker.odd : checker.even;
}

template <class Real>
struct GradientPattern {
    struct Stop {
        Real at;
        Vec3<Real> color;
    };
    Vec3<Real> axis;  ///< unit
    std::vector<Stop> stops;
};

/// Linear between the stops around the fractional part of p along the axis; beyond the first and
/// last stop their colours. Two stops at the same position make a step; the position itself belongs
/// to the upper side.
template <class Real>
Vec3<Real> color_at(const GradientPattern<Real>& gradient, const PatternPoint<Real>& p) {
    const Real along = dot(gradient.axis, p.at);
    const Vec3<Real> weights = absolute(gradient.axis);
    const Real bound = dot(weights, p.bound) + gamma<Real>(4) * dot(weights, absolute(p.at));
    const Real g = std::max(Real(0), along - whole_part(along, bound));
    const auto& stops = gradient.stops;
    const auto above = std::upper_bound(
        stops.begin(), stops.end(), g + bound,
        [](Real value, const typename GradientPattern<Real>::Stop& s) { return value < s.at; });
    if (above == stops.begin()) return stops.front().color;
    if (above == stops.end()) return stops.back().color;
    const auto& low = *(above - 1);
    const Real share = std::max(Real(0), (g - low.at) / (above->at - low.at));
    return (1 - share) * low.color + share * above->color;
}

/// The background as a function of the direction.
template <class Real>
struct SkyPattern {
    Vec3<Real> axis;                                          ///< unit
    std::vector<typename GradientPattern<Real>::Stop> stops;  ///< from -1, against the axis, to 1
};

/// Linear between the stops around the cosine of the direction with the axis.
///
/// \param direction  unit
template <class Real>
Vec3<Real> color_at(const SkyPattern<Real>& sky, const Vec3<Real>& direction) {
    const Real cosine = dot(sky.axis, direction);
    const auto above = std::upper_bound(
        sky.stops.begin(), sky.stops.end(), cosine,
        [](Real value, const typename GradientPattern<Real>::Stop& s) { return value < s.at; });
    if (above == sky.stops.begin()) return sky.stops.front().color;
    if (above == sky.stops.end()) return sky.stops.back().color;
    const auto& low = *(above - 1);
    const Real share = (cosine - low.at) / (above->at - low.at);
    return (1 - share) * low.color + share * above->color;
}

}  // namespace lancer
