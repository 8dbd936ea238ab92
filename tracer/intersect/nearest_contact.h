// The nearest contact of a ray. (For shadow rays: occlusion.h.)
#pragma once

#include "tracer/intersect/contact.h"
#include "tracer/intersect/intersection_filter.h"

namespace lancer {

/// Which objects a query sees: all, or those that cast shadows.
enum class Shadows { ignore, cast };

/// The nearest contact, with the nearest hit in front. Empty if the ray leaves the scene.
///
/// \tparam Bodies  MediaList, or NoMedia
template <class Real, class Bodies>
Contact<Real> nearest_contact(const Geometry<Real>& geometry, const Ray<Real>& ray,
                              const Start<Real>& start, const Bodies& bodies,
                              Shadows shadows = Shadows::ignore);

}  // namespace lancer
