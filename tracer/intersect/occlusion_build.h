// The search of a shadow ray.
#pragma once

#include "tracer/intersect/candidates.h"
#include "tracer/intersect/occlusion.h"

namespace lancer {

/// The state of query_occlusion().
template <class Real, class Bodies>
struct OcclusionQuery {
    const Geometry<Real>& geometry;
    const IntersectionFilter<Real, Bodies>& accept;
    const Start<Real>& start;
    Real distance;  ///< to the light
    /// Collects the crossings with surfaces that filter. If null, the query only finds out whether
    /// there are any.
    Passes<Real>* passes = nullptr;
    std::uint32_t at = none;  ///< the primitive that is being tested
    Occlusion occlusion = Occlusion::clear;

    static constexpr bool light_may_pass = !std::is_same_v<Bodies, NoMedia>;
    bool only_filters() const { return light_may_pass && geometry.primitives[at].transmissive; }
    bool looks_through() const { return light_may_pass && passes != nullptr; }
    bool collects() const { return looks_through() && only_filters(); }

    /// For a primitive that filters, both entries and exits are needed: the ray may enter it and
    /// leave it later.
    IntersectionHints hints() const {
        IntersectionHints hints = accept.hints(at);
        if (collects()) hints.one_way = false;
        return hints;
    }
};

/// The end of the interval up to the light, as RayInterval passes it to shapes.
template <class Real, class Bodies>
struct LightInterval {
    OcclusionQuery<Real, Bodies>& query;

    Real operator()() const {
        return query.looks_through() ? query.passes->reach() : query.distance;
    }
    /// Accepts an estimate [low, high] that lies wholly between start and light, unless the ray
    /// starts on the primitive or its crossings are collected.
    bool accepts_estimate(Real low, Real high) const {
        if (!(low > query.start.t && high < query.distance)) return false;
        if (query.collects() || query.accept.starts_on(query.at)) return false;
        query.occlusion = query.only_filters() ? Occlusion::filtered : Occlusion::blocked;
        return true;
    }
};

/// Tests all planes until one blocks the light. Calls `report` with a plane's exact crossings where
/// the estimate does not decide.
///
/// \param is_seen  called with a primitive before its test; false leaves it out
template <class Real, class Bodies, class Last, class Sees, class Report>
[[gnu::always_inline]] inline void planes_on_the_way(const Geometry<Real>& geometry,
                                                     const Ray<Real>& ray,
                                                     const IntersectionFilter<Real, Bodies>& accept,
                                                     const RayInterval<Real, Last>& interval,
                                                     const Sees& is_seen, const Report& report) {
    const auto& query = interval.last.query;
    const auto end = static_cast<std::uint32_t>(geometry.primitives.size());
    for (std::uint32_t i = geometry.planes; i < end; ++i) {
        const PlaneGuess<Real> guess(plane_of(geometry, i), ray);
        if (interval.ends_before(guess.low) || guess.high < interval.first || !is_seen(i)) continue;
        if (!accept.lets_pass(i, guess.slope < 0) ||
            !interval.accepts_estimate(guess.low, guess.high))
            crossings(plane_of(geometry, i), ray, query.hints(), interval, report);
        if (query.occlusion == Occlusion::blocked) return;
    }
}

template <class Real, class Bodies>
OnTheWay query_occlusion(const Geometry<Real>& geometry, const Ray<Real>& ray, Real distance,
                         const Start<Real>& start, const Bodies& bodies, Passes<Real>* passes) {
    const IntersectionFilter<Real, Bodies> accept(geometry, start, bodies);
    OcclusionQuery<Real, Bodies> query{geometry, accept, start, distance, passes};
    const LightInterval<Real, Bodies> limit{query};
    const RayInterval<Real, LightInterval<Real, Bodies>> interval{Real(0), limit};
    const auto report = [&](const Crossing<Real>& c) {
        if (query.only_filters()) {
            if (c.t >= -c.error && c.t < distance) query.occlusion = Occlusion::filtered;
            if (query.collects()) passes->add(geometry, query.at, c, accept.starts_on(query.at));
        } else if (accept(query.at, c) && c.t < distance - c.error) {
            query.occlusion = Occlusion::blocked;
        }
        return query.occlusion == Occlusion::blocked;
    };
    const auto is_seen = [&](std::uint32_t index) {
        query.at = index;
        return geometry.primitives[index].casts_shadow && index != start.left;
    };
    planes_on_the_way(geometry, ray, accept, interval, is_seen, report);
    if (query.occlusion == Occlusion::blocked) return {query.occlusion, query.at};
    candidates_from(geometry, ray, accept, interval, [&](std::uint32_t index) {
        if (!is_seen(index)) return false;
        crossings_from(geometry, index, ray, accept, query.hints(), interval,
                       [&](const Crossing<Real>& c, Real, Real) { return report(c); });
        return query.occlusion == Occlusion::blocked;
    });
    return {query.occlusion, query.at};
}

}  // namespace lancer
