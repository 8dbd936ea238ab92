// What lies on the way to a light.
#pragma once

#include "tracer/intersect/intersection_filter.h"
#include "tracer/intersect/passes.h"

namespace lancer {

enum class Occlusion { clear, blocked, filtered };

struct OnTheWay {
    Occlusion occlusion;
    std::uint32_t blocker;  ///< the primitive that blocks the light, if one does
};

/// Searches once between start and light. The first opaque surface that is found ends the search.
/// Otherwise the result says whether there are transmissive surfaces; `passes` collects their
/// crossings if it is not null.
///
/// \tparam Bodies  MediaList, or NoMedia
template <class Real, class Bodies>
OnTheWay query_occlusion(const Geometry<Real>& geometry, const Ray<Real>& ray, Real distance,
                         const Start<Real>& start, const Bodies& bodies,
                         Passes<Real>* passes = nullptr);

}  // namespace lancer
