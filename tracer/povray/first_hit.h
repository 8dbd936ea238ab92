// The surface that a ray of the judge's recursion meets. It is simpler than nearest_contact.h: the
// search starts at a small distance from the surface that the ray leaves, and of several surfaces
// in one place the ray meets only one.
#pragma once

#include <optional>

#include "tracer/intersect/nearest_contact.h"

namespace lancer {

/// The first surface between two parameters of the ray. Of several in one place it is the one
/// declared first; POV-Ray guarantees no order.
///
/// \param entered  the surface that the ray starts on and enters a body by. The ray meets another
///                 face of that body by which it leaves however near it is: the body may have no
///                 thickness
template <class Real>
std::optional<Hit<Real>> first_hit(const Geometry<Real>& geometry, const Ray<Real>& ray, Real first,
                                   Real last, Shadows shadows,
                                   const std::optional<SurfaceId>& entered);

}  // namespace lancer
