// The plane: boundary of a half space, infinite, so it is in no tree.
#pragma once

#include "tracer/ray.h"

namespace lancer {

template <class Real>
struct HalfSpace {
    Vec3<Real> normal;  ///< unit length, out of the half space
    Vec3<Real> point;   ///< on the plane
    Real placed = 0;  ///< bound on how far rounding moved it when a transform put it into the world
    Real plain_error = placed + plain_error_of(point);  ///< of `point` in a plain difference
};

/// Whether the plain difference of places tells all that the query wants to know. See misses() of
/// the ball.
///
/// \param slope  dot(normal, dir): of two unit vectors, so it errs by less than 8 u
template <class Real, class Last>
bool is_settled(const HalfSpace<Real>& half, const Ray<Real>& ray, Real slope, const Known& known,
                const Stretch<Real, Last>& stretch) {
    using std::abs;
    const Real noise = 2 * (ray.plain_error + half.plain_error);
    const Real height = dot(half.normal, ray.origin - half.point);
    const Real ahead = slope < 0 ? height : -height;  // t |slope|
    const Real steep = abs(slope);
    if (!(steep > gamma<Real>(64))) return false;
    // The crossing lies behind the start or after the stretch for certain.
    if (stretch.first >= 0 && ahead < -noise) return true;
    if (ahead - noise > (1 + gamma<Real>(8)) * stretch.last() * (steep + gamma<Real>(8)))
        return true;
    if (!stretch.may_settle || !known.asks_about(slope < 0)) return false;
    // By crossing(), |slope| times the bound is at most noise / 2 + 7 u |t|, and the heights differ
    // by half of the noise.
    const Real inv = 1 / steep;
    const Real t = ahead * inv;
    const Real slack = (5 * noise + gamma<Real>(64) * abs(t)) * inv;
    return stretch.settles(t - slack, t + slack);
}

/// The one crossing, where it may matter.
template <class Real, class Last, class Report>
[[gnu::noinline]] void crossing(const HalfSpace<Real>& half, const Ray<Real>& ray, Real slope,
                                const Stretch<Real, Last>& stretch, Report& report) {
    using std::abs;
    const Vec3<Real> rel = start_from(ray, half.point);
    const Real height = dot(half.normal, rel);
    const Real inv = 1 / slope;
    const Real t = -height * inv;
    if (stretch.ends_before(t)) return;
    // Both dot products are rounded at the size of their terms, which for a normal along an axis is
    // their own.
    const Vec3<Real> steep = absolute(half.normal);
    const Real error =
        (ray.origin_error + half.placed + gamma<Real>(4) * dot(steep, absolute(rel)) +
         gamma<Real>(3) * abs(t) * dot(steep, absolute(ray.dir))) *
            abs(inv) +
        gamma<Real>(4) * abs(t);
    const Crossing<Real> c{t, error, 0, slope < 0};
    if (stretch.holds(c)) report(c);
}

template <class Real, class Last, class Report>
void crossings(const HalfSpace<Real>& half, const Ray<Real>& ray, const Known& known,
               const Stretch<Real, Last>& stretch, Report&& report) {
    if (known.start_face != none) return;  // a line meets a plane once
    const Real slope = dot(half.normal, ray.dir);
    if (slope == 0 || is_settled(half, ray, slope, known, stretch)) return;
    crossing(half, ray, slope, stretch, report);
}

/// The crossing's point, put back onto the plane.
template <class Real>
SurfacePoint<Real> surface_point(const HalfSpace<Real>& half, const Ray<Real>& ray, Real t,
                                 std::uint32_t /*face*/) {
    // Along an axis that lies in the plane the anchor may slide to where the ray starts: the offset
    // is then small and keeps its digits however far all this is from the origin.
    const Vec3<Real> rel = start_from(ray, half.point);
    Vec3<Real> anchor(0);
    Vec3<Real> offset(0);
    Vec3<Real> rest(0);
    for (int i = 0; i < 3; ++i) {
        const bool across = half.normal[i] != 0;
        anchor[i] = across ? half.point[i] : ray.origin[i];
        offset[i] = (across ? rel[i] : Real(0)) + t * ray.dir[i];
        rest[i] = across ? Real(0) : ray.origin_lo[i];
    }
    offset -= dot(half.normal, offset) * half.normal;
    const Real error = gamma<Real>(4) * dot(absolute(half.normal), absolute(offset));
    return {anchor, offset, error, half.normal, half.normal, Vec2<Real>(0), rest};
}

}  // namespace lancer
