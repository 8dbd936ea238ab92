// The plane: boundary of a half space, infinite, so it is in no tree.
#pragma once

#include "tracer/ray.h"

namespace lancer {

template <class Real>
struct HalfSpace {
    Vec3<Real> normal;  ///< unit length, out of the half space
    Vec3<Real> point;   ///< on the plane
};

template <class Real, class Report>
void crossings(const HalfSpace<Real>& half, const Ray<Real>& ray, const Known& known,
               Report&& report) {
    using std::abs;
    if (known.start_face != none) return;  // a line meets a plane once
    const Real slope = dot(half.normal, ray.dir);
    if (slope == 0) return;
    const Vec3<Real> rel = start_from(ray, half.point);
    const Real height = dot(half.normal, rel);
    const Real t = -height / slope;
    // The dot product is rounded at the size of its terms, which for a normal along an axis is
    // the height itself.
    const Real size = dot(absolute(half.normal), absolute(rel));
    const Real error =
        (ray.origin_error + gamma<Real>(4) * size) / abs(slope) + gamma<Real>(3) * abs(t);
    report(Crossing<Real>{t, error, 0, slope < 0});
}

/// The crossing's point, put back onto the plane.
template <class Real>
SurfacePoint<Real> surface_point(const HalfSpace<Real>& half, const Ray<Real>& ray, Real t,
                                 std::uint32_t /*face*/) {
    Vec3<Real> offset = start_from(ray, half.point) + t * ray.dir;
    offset -= dot(half.normal, offset) * half.normal;
    const Real error = gamma<Real>(4) * dot(absolute(half.normal), absolute(offset));
    return {half.point, offset, error, half.normal, half.normal, Vec2<Real>(0)};
}

}  // namespace lancer
