// Shadows: the share of a lamp's light that reaches a point.
#pragma once

#include "tracer/intersect/media.h"
#include "tracer/intersect/nearest_contact.h"
#include "tracer/intersect/occlusion.h"
#include "tracer/shading/coincident_surfaces.h"
#include "tracer/shading/optics.h"
#include "tracer/shading/see_through.h"
#include "tracer/shading/surface.h"
#include "tracer/shading/unrecorded.h"

namespace lancer {

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
    const OnTheWay found = query_occlusion(world, ray, distance, start, media.bodies, &see_through);
    if (found.occlusion == Occlusion::blocked) {
        recorder.block(found.blocker);
        return Vec3<Real>(0);
    }
    const bool filtered = found.occlusion == Occlusion::filtered;
    if (filtered && see_through.tells_all(start, media.bodies))
        return see_through.transmittance(media.bodies, recorder);
    return light_by_contacts(world, ray, distance, start, media, filtered, recorder);
}

/// The same in worlds where all surfaces are opaque.
template <class Real, class Recorder = const Unrecorded>
Vec3<Real> light_through(const World<Real>& world, const Ray<Real>& ray, Real distance,
                         const Start<Real>& start, NoMedia media, Recorder& recorder = unrecorded) {
    const OnTheWay found = query_occlusion(world, ray, distance, start, media);
    if (found.occlusion != Occlusion::blocked) return Vec3<Real>(1);
    recorder.block(found.blocker);
    return Vec3<Real>(0);
}

}  // namespace lancer
