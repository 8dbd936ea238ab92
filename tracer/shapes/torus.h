// The torus: a tube bent into a ring round the y axis.
#pragma once

#include <array>

#include "tracer/rays/crossing.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/torus_line.h"
#include "tracer/textures/mapping.h"

namespace lancer {

/// Where a ray goes on from the torus outwards: whether it never meets it again, which is most
/// often so. False where that is not clear.
///
/// What it is known to start on lies where f is all rounding. When f climbs from there so steeply
/// that what bends it takes nothing of that back before it is clear of all rounding, that one
/// crossing is the only one next to the start, and the search goes on beyond.
template <class Real>
bool leaves_torus_for_good(const TorusLine<Real>& line, const TorusSpans<Real>& spans) {
    const Real start = line.parameter_of(Real(0));
    for (int i = 0; i < spans.count; ++i) {
        const auto [from, to] = spans.at[static_cast<std::size_t>(i)];
        if (!(start < to)) continue;
        Real at = from;
        if (from < start) {
            at = start;
            if (!line.climbs_clear(start, to)) return false;
        }
        if (line.next_root(at, to, true, from < start)) return false;
    }
    return true;
}

/// Reports crossings one by one, and no more than are asked about: of a line that nothing is known
/// about. Entries and exits alternate, for all lines begin and end outside.
template <class Real, class Last, class Report>
void crossings_in_turn(const TorusLine<Real>& line, const TorusSpans<Real>& spans,
                       const IntersectionHints& hints, const RayInterval<Real, Last>& interval,
                       Report&& report) {
    for (int i = 0; i < spans.count; ++i) {
        const auto [from, to] = spans.at[static_cast<std::size_t>(i)];
        if (interval.ends_before(line.ray_parameter(from))) return;
        // Behind the start by more than any bound.
        if (line.ray_parameter(to + (to - from)) < interval.first) continue;
        Real at = from;
        bool entering = true;
        for (int found = 0; found < TorusLine<Real>::most_roots; ++found) {
            if (!line.next_root(at, to, entering, found != 0)) break;
            Crossing<Real> c{line.ray_parameter(at), 0, 0, entering};
            if (interval.ends_before(c.t)) return;
            entering = !entering;
            if (!hints.asks_about(c.entering)) continue;
            c.error = line.bound(at);
            // Only next to the start is it asked how deep the line goes in.
            if (c.entering && !(c.t > interval.first + 4 * c.error)) {
                Real out = at;
                if (line.next_root(out, to, false, true)) c.chord = line.ray_parameter(out) - c.t;
            }
            if (interval.holds(c)) report(c);
        }
    }
}

/// The same for a line that starts on the torus, or is known to be inside.
template <class Real, class Last, class Report>
[[gnu::noinline]] void crossings_from_torus(const TorusLine<Real>& line,
                                            const TorusSpans<Real>& spans,
                                            const IntersectionHints& hints,
                                            const RayInterval<Real, Last>& interval,
                                            Report&& report) {
    using std::abs;
    constexpr std::size_t most = TorusLine<Real>::most_roots;
    std::array<Real, 2 * most> roots;
    std::size_t found = 0;
    for (int i = 0; i < spans.count; ++i) {
        const auto [from, to] = spans.at[static_cast<std::size_t>(i)];
        Real at = from;
        const std::size_t first = found;
        while (found < first + most &&
               line.next_root(at, to, (found - first) % 2 == 0, found != first))
            roots[found++] = at;
    }
    // Of a line that starts on the surface, the crossing there: the nearest to 0 of its kind.
    std::size_t start = found;
    if (hints.start_face != none) {
        for (std::size_t i = 0; i < found; ++i) {
            if ((i % 2 == 0) != hints.inside) continue;
            const Real t = abs(line.ray_parameter(roots[i]));
            if (start != found && !(t < abs(line.ray_parameter(roots[start])))) continue;
            if (t <= 4 * line.bound(roots[i])) start = i;
        }
    }
    bool leaves = false;
    for (std::size_t i = 0; i < found; ++i) {
        if (i == start) continue;
        Crossing<Real> c{line.ray_parameter(roots[i]), 0, 0, i % 2 == 0};
        leaves = leaves || (!c.entering && c.t > 0);
        if (interval.ends_before(c.t) || !hints.asks_about(c.entering)) continue;
        c.error = line.bound(roots[i]);
        leaves = leaves || (!c.entering && c.t + c.error >= 0);
        if (c.entering && i + 1 < found) c.chord = line.ray_parameter(roots[i + 1]) - c.t;
        if (interval.holds(c)) report(c);
    }
    // It is known to be inside, and so shallow that rounding denies it: it goes out where it is.
    if (hints.inside && !leaves && !interval.ends_before(Real(0))) {
        const Crossing<Real> out{0, line.bound(line.parameter_of(Real(0))), 0, false};
        if (interval.holds(out)) report(out);
    }
}

template <class Real, class Last, class Report>
void crossings(const TorusSolid<Real>& torus, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    const TorusLine<Real> line(torus, ray);
    const TorusSpans<Real> spans = line.spans();
    if (!hints.inside && spans.count == 0) return;
    if (hints.inside)
        crossings_from_torus(line, spans, hints, interval, report);
    else if (hints.start_face == none)
        crossings_in_turn(line, spans, hints, interval, report);
    else if (!(interval.first >= 0 && leaves_torus_for_good(line, spans)))
        crossings_from_torus(line, spans, hints, interval, report);
}

/// The crossing's point, put back onto the surface. The half of it that faces away from the axis is
/// that of its convex hull. Its parameters: u the angle about the axis, v
/// that about the tube, from the side that faces the axis.
template <class Real>
SurfacePoint<Real> surface_point(const TorusSolid<Real>& torus, const Ray<Real>& ray, Real t,
                                 std::uint32_t /*face*/) {
    using std::sqrt;
    const Vec3<Real> near = (start_from(ray, Vec3<Real>(0)) + t * ray.dir) * torus.shrink;
    const Real away = sqrt(near.x * near.x + near.z * near.z);
    const Real cosine = away > 0 ? near.x / away : Real(1);
    const Real sine = away > 0 ? near.z / away : Real(0);
    Real out = away - torus.ring;
    Real up = near.y;
    const Real distance = sqrt(out * out + up * up);
    out = distance > 0 ? out / distance : Real(1);
    up = distance > 0 ? up / distance : Real(0);
    SurfacePoint<Real> p;
    p.anchor = Vec3<Real>(torus.ring * cosine, 0, torus.ring * sine) * torus.grow;
    const Vec3<Real> outward(out * cosine, up, out * sine);
    p.offset = outward * (torus.tube * torus.grow);
    // Of a length that no power of two makes 1: unit() then does the same to it in the world and in
    // a space of the torus's own, where it would leave alone what is unit in only one of them.
    p.normal = outward * Real(1.5);
    p.error = gamma<Real>(8) * (torus.reach() * torus.grow);
    p.shading = p.normal;
    p.outermost = out > 0;
    p.parameter = Vec2<Real>(turn(sine, cosine), turn(-up, -out));
    return p;
}

}  // namespace lancer
