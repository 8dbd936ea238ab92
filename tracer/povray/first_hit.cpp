#include "tracer/povray/first_hit.h"

#include "tracer/intersect/candidates.h"

namespace lancer {

template <class Real>
std::optional<Hit<Real>> first_hit(const Geometry<Real>& geometry, const Ray<Real>& ray, Real first,
                                   Real last, Shadows shadows,
                                   const std::optional<SurfaceId>& entered) {
    std::optional<Hit<Real>> nearest;
    const auto limit = [&] { return nearest ? nearest->t : last; };
    // Rounding may have carried a crossing at 0 to either side of the start.
    const RayInterval<Real, decltype(limit)> interval{entered ? -first : first, limit};
    const auto object = [&](std::uint32_t index) { return geometry.primitives[index].object; };
    // A body without thickness is entered before it is left.
    const auto is_later = [&](std::uint32_t index, const Crossing<Real>& c,
                              const SurfaceId& other) {
        if (index == other.primitive) return other.entering && !c.entering;
        return object(index) > object(other.primitive);
    };
    const auto visit = [&](std::uint32_t index) {
        const Primitive<Real>& p = geometry.primitives[index];
        if (shadows == Shadows::cast && !p.casts_shadow) return false;
        const auto is_exit = [&](const Crossing<Real>& c) {
            return entered && entered->primitive == index && !c.entering && c.face != entered->face;
        };
        primitive_crossings(
            geometry, p, ray, IntersectionHints{}, interval,
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
    const auto end = static_cast<std::uint32_t>(geometry.primitives.size());
    for (std::uint32_t i = geometry.planes; i < end; ++i) visit(i);
    candidates(geometry, ray, interval, visit);
    return nearest;
}

template std::optional<Hit<double>> first_hit(const Geometry<double>&, const Ray<double>&, double,
                                              double, Shadows, const std::optional<SurfaceId>&);

}  // namespace lancer
