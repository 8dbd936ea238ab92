// The plane: boundary of a half space, infinite, so it is in no tree.
#pragma once

#include "tracer/ray.h"

namespace lancer {

template <class Real>
struct HalfSpace {
    Vec3<Real> normal;  ///< unit length, out of the half space
    Vec3<Real> point;   ///< on the plane
    Real placed = 0;  ///< bound on how far rounding moved it when a transform put it into the world
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
    // Both dot products are rounded at the size of their terms, which for a normal along an axis is
    // their own.
    const Real size = dot(absolute(half.normal), absolute(rel));
    const Real error = (ray.origin_error + half.placed + gamma<Real>(4) * size +
                        gamma<Real>(3) * abs(t) * dot(absolute(half.normal), absolute(ray.dir))) /
                           abs(slope) +
                       gamma<Real>(2) * abs(t);
    report(Crossing<Real>{t, error, 0, slope < 0});
}

/// The crossing's point, put back onto the plane.
template <class Real>
SurfacePoint<Real> surface_point(const HalfSpace<Real>& half, const Ray<Real>& ray, Real t,
                                 std::uint32_t /*face*/) {
    // Along an axis that lies in the plane the anchor may slide to where the ray starts: the offset
    // is then small and keeps its digits however far all this is from the origin.
    Vec3<Real> anchor = half.point;
    for (int i = 0; i < 3; ++i) {
        if (half.normal[i] == 0) anchor[i] = ray.origin[i];
    }
    Vec3<Real> rest(0);
    Vec3<Real> offset = start_from(ray, anchor);
    for (int i = 0; i < 3; ++i) {
        if (half.normal[i] == 0) std::swap(rest[i], offset[i]);
    }
    offset += t * ray.dir;
    offset -= dot(half.normal, offset) * half.normal;
    const Real error = gamma<Real>(4) * dot(absolute(half.normal), absolute(offset));
    return {anchor, offset, error, half.normal, half.normal, Vec2<Real>(0), rest};
}

}  // namespace lancer
