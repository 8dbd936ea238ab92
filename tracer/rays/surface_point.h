// A point of a surface, as a shape computes it.
#pragma once

#include "model/math.h"

namespace lancer {

/// The point where a ray hits a surface, in the space of the ray that was given to the shape.
template <class Real>
struct SurfacePoint {
    Vec3<Real> anchor;  ///< the point is anchor + offset, unevaluated
    Vec3<Real> offset;
    Real error;              ///< bound on the point's distance from the surface
    Vec3<Real> normal;       ///< geometric, outward; any length but 0
    Vec3<Real> shading;      ///< interpolated normal if the shape has one, else = normal
    Vec2<Real> parameter;    ///< barycentric coordinates of a triangle, parameters of a spline
    Vec3<Real> rest{0};      ///< a small third part of the point, if two are not precise enough
    bool outermost = false;  ///< on the shape's convex hull: a line that leaves there stays outside
};

}  // namespace lancer
