// A point of a surface, as a shape gives it.
#pragma once

#include "model/math.h"

namespace lancer {

/// Where a surface was hit, in the space of the ray that was given to the shape.
template <class Real>
struct SurfacePoint {
    Vec3<Real> anchor;  ///< the point is anchor + offset, unevaluated
    Vec3<Real> offset;
    Real error;              ///< bound on the point's distance from the surface
    Vec3<Real> normal;       ///< geometric, outward; any length but 0
    Vec3<Real> shading;      ///< interpolated where the shape does so, else = normal
    Vec2<Real> parameter;    ///< face-dependent: barycentrics of a triangle, parameters of a spline
    Vec3<Real> rest{0};      ///< a small third part of the point, where two do not hold it
    bool outermost = false;  ///< on the shape's convex hull: a line that goes out there stays out
};

}  // namespace lancer
