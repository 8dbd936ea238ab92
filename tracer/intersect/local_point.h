// The point of a hit on its primitive.
#pragma once

#include "tracer/intersect/contact.h"
#include "tracer/rays/surface_point.h"

namespace lancer {

/// In the primitive's own space.
///
/// \param ray  in that space, too
template <class Real>
SurfacePoint<Real> local_point(const Geometry<Real>& geometry, const Primitive<Real>& primitive,
                               const Ray<Real>& ray, const Hit<Real>& hit);

}  // namespace lancer
