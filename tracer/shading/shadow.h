// Shadows: the share of a lamp's light that reaches a point.
#pragma once

#include "tracer/intersect/media.h"
#include "tracer/rays/crossing.h"
#include "tracer/shading/coincident_surfaces.h"
#include "tracer/shading/optics.h"
#include "tracer/shading/see_through.h"
#include "tracer/shading/surface.h"
#include "tracer/shading/unrecorded.h"

namespace lancer {

/// What lies on the way to a light.
enum class Occlusion { clear, blocked, filtered };

/// The state of query_occlusion().
template <class Real, class Bodies>
struct OcclusionQuery {
    const World<Real>& world;
    const IntersectionFilter<Real, Bodies>& accept;
    const Start<Real>& start;
    Real distance;  ///< to the light
    /// Collects the crossings with surfaces that filter. If null, the query only finds out whether
    /// there are any.
    SeeThrough<Real>* see_through = nullptr;
    std::uint32_t at = none;  ///< the primitive that is being tested
    Occlusion occlusion = Occlusion::clear;

    static constexpr bool light_may_pass = !std::is_same_v<Bodies, NoMedia>;
    bool only_filters() const { return light_may_pass && world.primitives[at].transmissive; }
    bool looks_through() const { return light_may_pass && see_through != nullptr; }
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
        return query.looks_through() ? query.see_through->reach() : query.distance;
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
[[gnu::always_inline]] inline void planes_on_the_way(const World<Real>& world, const Ray<Real>& ray,
                                                     const IntersectionFilter<Real, Bodies>& accept,
                                                     const RayInterval<Real, Last>& interval,
                                                     const Sees& is_seen, const Report& report) {
    const auto& query = interval.last.query;
    const auto end = static_cast<std::uint32_t>(world.primitives.size());
    for (std::uint32_t i = world.planes; i < end; ++i) {
        const PlaneGuess<Real> guess(plane_of(world, i), ray);
        if (interval.ends_before(guess.low) || guess.high < interval.first || !is_seen(i)) continue;
        if (!accept.lets_pass(i, guess.slope < 0) ||
            !interval.accepts_estimate(guess.low, guess.high))
            crossings(plane_of(world, i), ray, query.hints(), interval, report);
        if (query.occlusion == Occlusion::blocked) return;
    }
}

/// Searches once between start and light. The first opaque surface that is found ends the search.
/// Otherwise the result says whether there are transmissive surfaces; `see_through` collects their
/// crossings if it is not null.
template <class Real, class Bodies, class Recorder = const Unrecorded>
Occlusion query_occlusion(const World<Real>& world, const Ray<Real>& ray, Real distance,
                          const Start<Real>& start, const Bodies& bodies,
                          SeeThrough<Real>* see_through = nullptr,
                          Recorder& recorder = unrecorded) {
    const IntersectionFilter<Real, Bodies> accept(world, start, bodies);
    OcclusionQuery<Real, Bodies> query{world, accept, start, distance, see_through};
    const LightInterval<Real, Bodies> limit{query};
    const RayInterval<Real, LightInterval<Real, Bodies>> interval{Real(0), limit};
    const auto report = [&](const Crossing<Real>& c) {
        if (query.only_filters()) {
            if (c.t >= -c.error && c.t < distance) query.occlusion = Occlusion::filtered;
            if (query.collects()) see_through->add(query.at, c, accept.starts_on(query.at));
        } else if (accept(query.at, c) && c.t < distance - c.error) {
            query.occlusion = Occlusion::blocked;
        }
        return query.occlusion == Occlusion::blocked;
    };
    const auto is_seen = [&](std::uint32_t index) {
        query.at = index;
        return world.primitives[index].casts_shadow && index != start.left;
    };
    planes_on_the_way(world, ray, accept, interval, is_seen, report);
    if (query.occlusion == Occlusion::blocked) {
        recorder.block(query.at);
        return Occlusion::blocked;
    }
    candidates_from(world, ray, accept, interval, [&](std::uint32_t index) {
        if (!is_seen(index)) return false;
        crossings_from(world, index, ray, accept, query.hints(), interval,
                       [&](const Crossing<Real>& c, Real, Real) { return report(c); });
        return query.occlusion == Occlusion::blocked;
    });
    if (query.occlusion == Occlusion::blocked) recorder.block(query.at);
    return query.occlusion;
}

/// The share of light that passes where no opaque surface lies before the light, computed from
/// contact to contact: the product of T over all surfaces crossed and of the transmittance of the
/// media in between.
template <class Real, class Recorder = const Unrecorded>
Vec3<Real> light_by_contacts(const World<Real>& world, const Ray<Real>& ray, Real distance,
                             Start<Real> start, Media media, bool filtered,
                             Recorder& recorder = unrecorded) {
    MediaList& bodies = media.bodies;
    // A body that casts no shadow does not absorb light either.
    const auto casts_none = [&](std::uint32_t body) {
        return !world.primitives[body].casts_shadow;
    };
    bodies.erase(std::remove_if(bodies.begin(), bodies.end(), casts_none), bodies.end());
    Vec3<Real> light(1);
    const auto absorb_until = [&](Real t) {
        const Finish<Real>* medium = medium_of(world, bodies);
        if (medium == nullptr || !medium->absorbs) return;
        const Vec3<Real> left = beer_lambert_transmittance(medium->absorption, t - start.t);
        recorder.absorb(bodies, t, left);
        light = light * left;
    };
    while (filtered) {
        Contact<Real> contact = nearest_contact(world, ray, start, bodies, Shadows::cast);
        if (contact.empty()) break;
        const Hit<Real> nearest = contact.front();
        if (!(nearest.t < distance - nearest.error)) break;
        absorb_until(nearest.t);
        order_contact(world, contact);
        start.surfaces.clear();
        for (const Hit<Real>& hit : contact) start.surfaces.push_back(hit.surface);
        start.t = nearest.t;
        start.fresh = false;
        media = crossed(world, media, contact);
        drop_coincident(world, contact);
        for (const Hit<Real>& hit : contact) {
            const Vec3<Real> passes = make_surface(world, ray, hit).transmittance;
            recorder.filter(hit.surface, hit.t, passes);
            light = light * passes;
        }
        if (!(max_component(light) > 0)) return Vec3<Real>(0);
    }
    absorb_until(distance);
    return light;
}

/// The share of light that comes straight from `distance` away to the start of `ray`. Without
/// refraction, and without a limit on the number of surfaces.
///
/// \param media  around the first part of the ray
template <class Real, class Recorder = const Unrecorded>
Vec3<Real> light_through(const World<Real>& world, const Ray<Real>& ray, Real distance,
                         const Start<Real>& start, const Media& media,
                         Recorder& recorder = unrecorded) {
    SeeThrough<Real> see_through(world, distance);
    const Occlusion occlusion =
        query_occlusion(world, ray, distance, start, media.bodies, &see_through, recorder);
    if (occlusion == Occlusion::blocked) return Vec3<Real>(0);
    const bool filtered = occlusion == Occlusion::filtered;
    if (filtered && see_through.tells_all(start, media.bodies))
        return see_through.transmittance(media.bodies, recorder);
    return light_by_contacts(world, ray, distance, start, media, filtered, recorder);
}

/// The same in worlds where all surfaces are opaque.
template <class Real, class Recorder = const Unrecorded>
Vec3<Real> light_through(const World<Real>& world, const Ray<Real>& ray, Real distance,
                         const Start<Real>& start, NoMedia media, Recorder& recorder = unrecorded) {
    const Occlusion occlusion =
        query_occlusion<Real>(world, ray, distance, start, media, nullptr, recorder);
    return Vec3<Real>(occlusion == Occlusion::blocked ? Real(0) : Real(1));
}

}  // namespace lancer
