// The surface that a ray of the judge's recursion meets. It is simpler than nearest_contact.h: the
// search starts at a small distance from the surface that the ray leaves, and of several surfaces
// in one place the ray meets only one.
#pragma once

#include <optional>

#include "tracer/intersect/nearest_contact.h"
#include "tracer/rays/crossing.h"
#include "tracer/shading/surface.h"

namespace lancer {

/// The first surface between two parameters of the ray. Of several in one place it is the one
/// declared first; POV-Ray guarantees no order.
///
/// \param entered  the surface that the ray starts on and enters a body by. The ray meets another
///                 face of that body by which it leaves however near it is: the body may have no
///                 thickness
template <class Real>
std::optional<Hit<Real>> first_hit(const World<Real>& world, const Ray<Real>& ray, Real first,
                                   Real last, Shadows shadows,
                                   const std::optional<SurfaceId>& entered) {
    std::optional<Hit<Real>> nearest;
    const auto limit = [&] { return nearest ? nearest->t : last; };
    // Rounding may have carried a crossing at 0 to either side of the start.
    const RayInterval<Real, decltype(limit)> interval{entered ? -first : first, limit};
    const auto object = [&](std::uint32_t index) { return world.primitives[index].object; };
    // A body without thickness is entered before it is left.
    const auto is_later = [&](std::uint32_t index, const Crossing<Real>& c,
                              const SurfaceId& other) {
        if (index == other.primitive) return other.entering && !c.entering;
        return object(index) > object(other.primitive);
    };
    const auto visit = [&](std::uint32_t index) {
        const Primitive<Real>& p = world.primitives[index];
        if (shadows == Shadows::cast && !p.casts_shadow) return false;
        const auto is_exit = [&](const Crossing<Real>& c) {
            return entered && entered->primitive == index && !c.entering && c.face != entered->face;
        };
        primitive_crossings(
            world, p, ray, IntersectionHints{}, interval,
            [&](const Crossing<Real>& c, Real u, Real v) {
                if (!(c.t >= (is_exit(c) ? interval.first : first)) || !(c.t <= limit()))
                    return false;
                if (nearest && c.t == nearest->t && is_later(index, c, nearest->surface))
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

/// The ray that continues from a surface. The smallest distance of hits keeps it from meeting the
/// surface again.
template <class Real>
Ray<Real> ray_from(const Surface<Real>& s, const Vec3<Real>& direction) {
    return make_ray(s.position, s.position_lo, direction, s.error);
}

}  // namespace lancer
