// Which surface a ray of the judge's recursion meets, more simply than nearest_contact.h says it: a
// ray starts a small way off the surface that it leaves, and of what lies in one place it meets one
// surface.
#pragma once

#include <optional>

#include "tracer/intersect/nearest_contact.h"
#include "tracer/rays/crossing.h"
#include "tracer/shading/surface.h"

namespace lancer {

/// The one surface that is seen first between two parameters of the ray; of several in one place
/// the first declared, though POV-Ray promises none.
template <class Real>
std::optional<Hit<Real>> first_hit(const World<Real>& world, const Ray<Real>& ray, Real first,
                                   Real last, Shadows shadows) {
    std::optional<Hit<Real>> nearest;
    const auto limit = [&] { return nearest ? nearest->t : last; };
    const RayInterval<Real, decltype(limit)> interval{first, limit};
    const auto object = [&](std::uint32_t index) { return world.primitives[index].object; };
    const auto visit = [&](std::uint32_t index) {
        const Primitive<Real>& p = world.primitives[index];
        if (shadows == Shadows::cast && !p.casts_shadow) return false;
        primitive_crossings(
            world, p, ray, IntersectionHints{}, interval,
            [&](const Crossing<Real>& c, Real u, Real v) {
                if (!(c.t >= first) || !(c.t <= limit())) return false;
                if (nearest && c.t == nearest->t &&
                    object(index) > object(nearest->surface.primitive))
                    return false;
                nearest = Hit<Real>{c.t, c.error, {index, c.face, c.entering}, u, v};
                return false;
            });
        return false;
    };
    const auto end = static_cast<std::uint32_t>(world.primitives.size());
    for (std::uint32_t i = world.planes; i < end; ++i) visit(i);
    candidates(world, ray, interval, visit);
    return nearest;
}

/// The ray goes on from a surface, which a rule of distance keeps it from meeting again.
template <class Real>
Ray<Real> ray_from(const Surface<Real>& s, const Vec3<Real>& direction) {
    return make_ray(s.position, s.position_lo, direction, s.error);
}

}  // namespace lancer
