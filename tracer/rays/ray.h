// Rays, and the errors of their starts.
#pragma once

#include "tracer/numerics/rounding.h"

namespace lancer {

/// A half line. Rays in the world have unit directions. Rays in an object's space keep the
/// parameter t of the world ray, so their directions may have any length.
template <class Real>
struct Ray {
    Vec3<Real> origin;     ///< the start is origin + origin_lo, unevaluated
    Vec3<Real> origin_lo;  ///< the low part: at most u |origin| in each component
    Vec3<Real> dir;
    Real dir_squared;  ///< dot(dir, dir)
    Real inv_squared;  ///< 1 / dir_squared
    Real
        origin_error;  ///< bound on the start's distance from the surface it was computed to lie on
    Real filter_error;  ///< the start's contribution to the error of a plain difference of points,
    ///< origin - point, summed over the components: see filter_error_of()
    Vec3<Real> inv_dir;  ///< 1 / dir, component by component
    bool whole = false;  ///< `origin_lo` is 0
};

/// A point's contribution to the error of a plain difference of points. Such a difference has an
/// error of u of both points; the difference from a ray's start also misses its low part. 16 u is
/// used instead, so that size_of_place() gives the point's size for later roundings. Filters use
/// it: they settle clear cases before exact differences are computed.
template <class Real>
Real filter_error_of(const Vec3<Real>& place) {
    const Vec3<Real> size = absolute(place);
    return gamma<Real>(16) * (size.x + size.y + size.z);
}

/// A bound on the size of a point, or on the sum of sizes of several, from their filter errors.
template <class Real>
Real size_of_place(Real filter_errors) {
    return filter_errors * (1 / gamma<Real>(16));
}

/// 1 / square. Directions of world rays are unit vectors up to rounding, and 1 / (1 + e) is 1 - e
/// up to e^2, which is below a rounding error for such an e.
template <class Real>
Real inverse_square(Real square) {
    using std::abs;
    const Real excess = square - 1;
    return abs(excess) < gamma<Real>(16) ? 1 - excess : 1 / square;
}

/// \param origin_lo  at most u |origin| in a component: see normalized()
template <class Real>
Ray<Real> make_ray(const Vec3<Real>& origin, const Vec3<Real>& origin_lo, const Vec3<Real>& dir,
                   Real origin_error) {
    const Real square = dot(dir, dir);
    return {origin,
            origin_lo,
            dir,
            square,
            inverse_square(square),
            origin_error,
            filter_error_of(origin) + origin_error,
            Vec3<Real>(1 / dir.x, 1 / dir.y, 1 / dir.z),
            origin_lo == Vec3<Real>(0)};
}

/// The ray's start relative to `point`.
template <class Real>
[[gnu::always_inline]] inline Vec3<Real> start_from(const Ray<Real>& ray, const Vec3<Real>& point) {
    if (ray.whole) return ray.origin - point;  // then equal to the difference below
    return difference(ray.origin, ray.origin_lo, point);
}

/// The rounding error of component `axis` of start_from(): the exact value minus the rounded one.
template <class Real>
Real lost_from_start(const Ray<Real>& ray, const Vec3<Real>& point, int axis) {
    const DoubleWord<Real> d = two_sum(ray.origin[axis], -point[axis]);
    const Real rest = d.lo + ray.origin_lo[axis];
    return rest - ((d.hi + rest) - d.hi);
}

}  // namespace lancer
