// How much of a light reaches a point.
#pragma once

#include "tracer/media.h"
#include "tracer/optics.h"
#include "tracer/seams.h"
#include "tracer/surface.h"

namespace lancer {

enum class Way { clear, blocked, filtered };

/// What survey() has found, and where it is.
template <class Real, class Bodies>
struct Survey {
    const World<Real>& world;
    const Acceptance<Real, Bodies>& accept;
    const Start<Real>& start;
    Real distance;            ///< to the light
    std::uint32_t at = none;  ///< the primitive that is asked about
    Way way = Way::clear;

    static constexpr bool light_may_pass = !std::is_same_v<Bodies, NoMedia>;
    bool only_filters() const { return light_may_pass && world.primitives[at].transmissive; }
};

/// The stretch to the light, for shapes: Stretch.
template <class Real, class Bodies>
struct WayToLight {
    Survey<Real, Bodies>& survey;

    Real operator()() const { return survey.distance; }
    /// A crossing farther ahead than its error counts, unless the ray starts on the primitive.
    bool settles(Real low, Real high) const {
        if (!(low > survey.start.t && high < survey.distance)) return false;
        if (survey.accept.starts_on(survey.at)) return false;
        survey.way = survey.only_filters() ? Way::filtered : Way::blocked;
        return true;
    }
};

/// Reports the crossings with planes that plain numbers do not settle, until one blocks the way.
///
/// \param is_seen  called with the primitive before it is asked about
template <class Real, class Bodies, class Last, class Sees, class Report>
[[gnu::always_inline]] inline void planes_on_the_way(const World<Real>& world, const Ray<Real>& ray,
                                                     const Acceptance<Real, Bodies>& accept,
                                                     const Stretch<Real, Last>& stretch,
                                                     const Sees& is_seen, const Report& report) {
    const auto end = static_cast<std::uint32_t>(world.primitives.size());
    for (std::uint32_t i = world.bounded; i < end; ++i) {
        const PlaneGuess<Real> guess(plane_of(world, i), ray);
        if (stretch.ends_before(guess.low) || guess.high < stretch.first || !is_seen(i)) continue;
        if (!accept.lets_pass(i, guess.slope < 0) || !stretch.settles(guess.low, guess.high))
            crossings(plane_of(world, i), ray, accept.known(i), stretch, report);
        if (stretch.last.survey.way == Way::blocked) return;
    }
}

/// Looks once along the way to the light: an opaque surface ends it; whether something transmissive
/// lies there is only noted.
template <class Real, class Bodies>
Way survey(const World<Real>& world, const Ray<Real>& ray, Real distance, const Start<Real>& start,
           const Bodies& bodies) {
    const Acceptance<Real, Bodies> accept(world, start, bodies);
    Survey<Real, Bodies> survey{world, accept, start, distance};
    const WayToLight<Real, Bodies> limit{survey};
    const Stretch<Real, WayToLight<Real, Bodies>> stretch{Real(0), limit};
    const auto report = [&](const Crossing<Real>& c) {
        if (survey.only_filters()) {
            if (c.t >= -c.error && c.t < distance) survey.way = Way::filtered;
        } else if (accept(survey.at, c) && c.t < distance - c.error) {
            survey.way = Way::blocked;
        }
        return survey.way == Way::blocked;
    };
    const auto is_seen = [&](std::uint32_t index) {
        survey.at = index;
        return world.primitives[index].casts_shadow && index != start.left;
    };
    planes_on_the_way(world, ray, accept, stretch, is_seen, report);
    if (survey.way == Way::blocked) return Way::blocked;
    candidates(world, ray, stretch, [&](std::uint32_t index) {
        if (!is_seen(index)) return false;
        primitive_crossings(world, world.primitives[index], ray, accept.known(index), stretch,
                            [&](const Crossing<Real>& c, Real, Real) { return report(c); });
        return survey.way == Way::blocked;
    });
    return survey.way;
}

/// The share of light that comes straight to the start of `ray` from `distance` away: the product
/// of T over every surface crossed and of the absorption on the way. No refraction, no limit on the
/// number of surfaces.
///
/// \param media  around the first stretch of the way
template <class Real>
Vec3<Real> light_through(const World<Real>& world, const Ray<Real>& ray, Real distance,
                         Start<Real> start, Media media) {
    MediaList& bodies = media.bodies;
    const Way way = survey(world, ray, distance, start, bodies);
    if (way == Way::blocked) return Vec3<Real>(0);
    // What casts no shadow does not weaken light inside it either.
    const auto casts_none = [&](std::uint32_t body) {
        return !world.primitives[body].casts_shadow;
    };
    bodies.erase(std::remove_if(bodies.begin(), bodies.end(), casts_none), bodies.end());
    Vec3<Real> light(1);
    while (way == Way::filtered) {
        Contact<Real> contact = nearest_contact(world, ray, start, bodies, Shadows::cast);
        if (contact.empty()) break;
        const Hit<Real> nearest = contact.front();
        if (!(nearest.t < distance - nearest.error)) break;
        if (const Finish<Real>* medium = medium_of(world, bodies); medium && medium->absorbs)
            light = light * absorbed(medium->absorption, nearest.t - start.t);
        order_contact(world, contact);
        start.surfaces.clear();
        for (const Hit<Real>& hit : contact) start.surfaces.push_back(hit.surface);
        start.t = nearest.t;
        start.fresh = false;
        media = crossed(world, media, contact);
        drop_seams(world, contact);
        for (const Hit<Real>& hit : contact) light = light * make_surface(world, ray, hit).passing;
        if (!(max_component(light) > 0)) return Vec3<Real>(0);
    }
    if (const Finish<Real>* medium = medium_of(world, bodies); medium && medium->absorbs)
        light = light * absorbed(medium->absorption, distance - start.t);
    return light;
}

/// The same where no light passes through anything.
template <class Real>
Vec3<Real> light_through(const World<Real>& world, const Ray<Real>& ray, Real distance,
                         const Start<Real>& start, NoMedia media) {
    const Way way = survey(world, ray, distance, start, media);
    return Vec3<Real>(way == Way::blocked ? Real(0) : Real(1));
}

}  // namespace lancer
