// How much of a light reaches a point.
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

/// What query_occlusion() has found, and where it is.
template <class Real, class Bodies>
struct OcclusionQuery {
    const World<Real>& world;
    const IntersectionFilter<Real, Bodies>& accept;
    const Start<Real>& start;
    Real distance;  ///< to the light
    /// Gets the crossings with what only filters; null: that there are some is enough.
    SeeThrough<Real>* see_through = nullptr;
    std::uint32_t at = none;  ///< the primitive that is asked about
    Occlusion occlusion = Occlusion::clear;

    static constexpr bool light_may_pass = !std::is_same_v<Bodies, NoMedia>;
    bool only_filters() const { return light_may_pass && world.primitives[at].transmissive; }
    bool looks_through() const { return light_may_pass && see_through != nullptr; }
    bool collects() const { return looks_through() && only_filters(); }

    /// A primitive that only filters is asked for entries and exits: the ray may enter it and later
    /// leave it.
    IntersectionHints hints() const {
        IntersectionHints hints = accept.hints(at);
        if (collects()) hints.one_way = false;
        return hints;
    }
};

/// The interval to the light, for shapes: RayInterval.
template <class Real, class Bodies>
struct LightInterval {
    OcclusionQuery<Real, Bodies>& query;

    Real operator()() const {
        return query.looks_through() ? query.see_through->reach() : query.distance;
    }
    /// A crossing farther ahead than its error counts, unless the ray starts on the primitive.
    bool accepts_estimate(Real low, Real high) const {
        if (!(low > query.start.t && high < query.distance)) return false;
        if (query.collects() || query.accept.starts_on(query.at)) return false;
        query.occlusion = query.only_filters() ? Occlusion::filtered : Occlusion::blocked;
        return true;
    }
};

/// Reports the crossings with planes that plain numbers do not settle, until one blocks the way.
///
/// \param is_seen  called with the primitive before it is asked about
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

/// Looks once along the way to the light: an opaque surface ends it; that something transmissive
/// lies there is noted, and its crossings are collected where somebody wants them.
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
    candidates(world, ray, interval, [&](std::uint32_t index) {
        if (!is_seen(index)) return false;
        crossings_from(world, index, ray, accept, query.hints(), interval,
                       [&](const Crossing<Real>& c, Real, Real) { return report(c); });
        return query.occlusion == Occlusion::blocked;
    });
    if (query.occlusion == Occlusion::blocked) recorder.block(query.at);
    return query.occlusion;
}

/// The share of light that is left on a way on which only filters lie, from contact to contact: the
/// product of T over every surface crossed and of the absorption in between.
template <class Real, class Recorder = const Unrecorded>
Vec3<Real> light_by_contacts(const World<Real>& world, const Ray<Real>& ray, Real distance,
                             Start<Real> start, Media media, bool filtered,
                             Recorder& recorder = unrecorded) {
    MediaList& bodies = media.bodies;
    // What casts no shadow does not weaken light inside it either.
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

/// The share of light that comes straight to the start of `ray` from `distance` away. No
/// refraction, no limit on the number of surfaces.
///
/// \param media  around the first part of the way
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

/// The same where no light passes through anything.
template <class Real, class Recorder = const Unrecorded>
Vec3<Real> light_through(const World<Real>& world, const Ray<Real>& ray, Real distance,
                         const Start<Real>& start, NoMedia media, Recorder& recorder = unrecorded) {
    const Occlusion occlusion =
        query_occlusion<Real>(world, ray, distance, start, media, nullptr, recorder);
    return Vec3<Real>(occlusion == Occlusion::blocked ? Real(0) : Real(1));
}

}  // namespace lancer
