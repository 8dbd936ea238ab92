// The plane, the boundary of a half space. It is infinite, so it is not in the tree.
#pragma once

#include <limits>

#include "tracer/rays/crossing.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/traits.h"

namespace lancer {

template <class Real>
struct HalfSpace {
    Vec3<Real> normal;  ///< unit length, out of the half space
    Vec3<Real> point;   ///< on the plane
    Real transform_error =
        0;  ///< bound on how far rounding moved it when a transform put it into the world
    Real filter_error =
        transform_error + filter_error_of(point);  ///< error of `point` in a plain difference
    Real offset = dot(normal, point);

    static constexpr SolidTraits traits{.convex = true, .face_by_face = false};
    /// The measure in its own space that must not be too small; infinite if there is none.
    Real size() const { return std::numeric_limits<Real>::infinity(); }
};

/// An estimate of the crossing of a line with a plane, from plain differences of points. The result
/// of crossing(), with eight times its error bound on either side, lies between `low` and `high`. A
/// filter: see is_settled() of the ball. NaNs decide nothing.
template <class Real>
struct PlaneGuess {
    Real slope;  ///< dot(normal, dir)
    Real low, high;

    /// The heights by plain and by exact differences differ by less than `noise`. In crossing(),
    /// |slope| times the error bound is at most `noise` plus 7 u |t|.
    PlaneGuess(const HalfSpace<Real>& half, const Ray<Real>& ray)
        : slope(dot(half.normal, ray.dir)) {
        using std::abs;
        const Real noise = ray.filter_error + half.filter_error;
        const Real inv = 1 / slope;
        const Real t = (half.offset - dot(half.normal, ray.origin)) * inv;
        const Real slack = (9 * noise + gamma<Real>(64) * abs(t)) * abs(inv);
        low = t - slack;
        high = t + slack;
    }
};

/// Reports the crossing, of which there is only one, if it may lie on the interval. `slope` is
/// dot(normal, dir) and not 0.
template <class Real, class Last, class Report>
void crossing(const HalfSpace<Real>& half, const Ray<Real>& ray, Real slope,
              const RayInterval<Real, Last>& interval, Report& report) {
    using std::abs;
    const Vec3<Real> rel = start_from(ray, half.point);
    const Real height = dot(half.normal, rel);
    const Real inv = 1 / slope;
    const Real t = -height * inv;
    if (interval.ends_before(t)) return;
    // Both dot products are rounded relative to their terms. For a normal along an axis there is
    // only one term.
    const Vec3<Real> steep = absolute(half.normal);
    const Real error =
        (ray.origin_error + half.transform_error + gamma<Real>(4) * dot(steep, absolute(rel)) +
         gamma<Real>(3) * abs(t) * dot(steep, absolute(ray.dir))) *
            abs(inv) +
        gamma<Real>(4) * abs(t);
    const Crossing<Real> c{t, error, 0, slope < 0};
    if (interval.holds(c)) report(c);
}

template <class Real, class Last, class Report>
[[gnu::noinline]] void crossings(const HalfSpace<Real>& half, const Ray<Real>& ray,
                                 const IntersectionHints& hints,
                                 const RayInterval<Real, Last>& interval, Report&& report) {
    if (hints.start_face != none) return;  // a line meets a plane once
    const Real slope = dot(half.normal, ray.dir);
    if (slope != 0) crossing(half, ray, slope, interval, report);
}

/// The point of a crossing, projected onto the plane.
template <class Real>
SurfacePoint<Real> surface_point(const HalfSpace<Real>& half, const Ray<Real>& ray, Real t,
                                 std::uint32_t /*face*/) {
    // Along a coordinate axis that is parallel to the plane, the anchor moves to the ray's start.
    // The offset is then small, and keeps its digits even far from the origin.
    const Vec3<Real> rel = start_from(ray, half.point);
    Vec3<Real> anchor = half.point;
    Vec3<Real> offset = rel + t * ray.dir;
    Vec3<Real> rest(0);
    for (int i = 0; i < 3; ++i) {
        if (half.normal[i] != 0) continue;
        anchor[i] = ray.origin[i];
        offset[i] = t * ray.dir[i];
        rest[i] = ray.origin_lo[i];
    }
    offset -= dot(half.normal, offset) * half.normal;
    const Real error = gamma<Real>(4) * dot(absolute(half.normal), absolute(offset));
    return {anchor, offset, error, half.normal, half.normal, Vec2<Real>(0), rest};
}

}  // namespace lancer
