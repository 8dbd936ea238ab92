// From a point to image coordinates: u to the right, v up, one image per unit.
#pragma once

#include "tracer/textures/placement.h"

namespace lancer {

/// Image coordinates, and bounds on their rounding errors.
template <class Real>
struct ImagePoint {
    Real u;
    Real v;
    Real u_bound;
    Real v_bound;
};

/// atan2(y, x) / 2 pi in [0, 1).
template <class Real>
Real turn(Real y, Real x) {
    using std::floor;
    constexpr Real one_turn = static_cast<Real>(6.283185307179586476925286766559005768L);
    const Real t = elementary::atan2(y, x) / one_turn;
    const Real positive = t - floor(t);
    return positive - floor(positive);  // a tiny negative t gives 1, which becomes 0
}

template <class Real>
ImagePoint<Real> planar(const PatternPoint<Real>& p) {
    return {p.at.x, p.at.y, p.bound.x, p.bound.y};
}

/// u goes once about the y axis, from +x towards +z; v = y.
template <class Real>
ImagePoint<Real> cylindrical(const PatternPoint<Real>& p) {
    using std::sqrt;
    const Real from_axis = sqrt(p.at.x * p.at.x + p.at.z * p.at.z);
    const Real aside = p.bound.x + p.bound.z;
    const Real u_bound = gamma<Real>(4) + aside / from_axis;  // infinite on the axis
    return {turn(p.at.z, p.at.x), p.at.y, u_bound, p.bound.y};
}

/// u as in cylindrical(); v = 1/2 + asin(y / |p|) / pi. The angle is computed from its tangent,
/// which is as precise at the poles as elsewhere.
template <class Real>
ImagePoint<Real> spherical(const PatternPoint<Real>& p) {
    using std::sqrt;
    ImagePoint<Real> image = cylindrical(p);
    const Real from_axis = sqrt(p.at.x * p.at.x + p.at.z * p.at.z);
    constexpr Real half_turn = static_cast<Real>(3.141592653589793238462643383279502884L);
    image.v = Real(0.5) + elementary::atan2(p.at.y, from_axis) / half_turn;
    const Real size = length(p.at);
    image.v_bound = gamma<Real>(4) + (p.bound.x + p.bound.y + p.bound.z) / size;
    return image;
}

}  // namespace lancer
