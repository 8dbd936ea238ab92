// The torus: a tube around a circle about the y axis.
#pragma once

#include <array>

#include "tracer/rays/crossing.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/torus_line.h"
#include "tracer/textures/mapping.h"

namespace lancer {

/// Whether a ray that starts on the torus and goes outwards certainly never meets it again. This is
/// the usual case. False if it is not certain.
///
/// At the start, f is below its rounding error. If f rises so steeply that its curvature cannot
/// bring it back before it exceeds the rounding error, the start is the only crossing near it, and
/// the search continues from there.
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

/// Reports crossings one by one, and computes no more than the query needs. For a line that does
/// not start on the torus and is not known to be inside. Entries and exits alternate, because all
/// lines begin and end outside.
template <class Real, class Last, class Report>
void crossings_in_turn(const TorusLine<Real>& line, const TorusSpans<Real>& spans,
                       const IntersectionHints& hints, const RayInterval<Real, Last>& interval,
                       Report&& report) {
    for (int i = 0; i < spans.count; ++i) {
        const auto [from, to] = spans.at[static_cast<std::size_t>(i)];
        if (interval.ends_before(line.ray_parameter(from))) return;
        // The span lies behind the start, farther than any error bound.
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
            // The chord is needed only near the start.
            if (c.entering && !(c.t > interval.first + 4 * c.error)) {
                Real out = at;
                if (line.next_root(out, to, false, true)) c.chord = line.ray_parameter(out) - c.t;
            }
            if (interval.holds(c)) report(c);
        }
    }
}

/// Reports the crossings of a line that starts on the torus or is known to be inside.
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
    // The crossing at the start of a line that starts on the surface: of its kind (entry or exit),
    // the one nearest to 0.
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
    // The line is known to be inside, but so shallow that rounding hides its exit: the exit is at
    // the start.
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
    if (!hints.inside && hints.start_face == none)
        crossings_in_turn(line, spans, hints, interval, report);
    else if (hints.inside || !(interval.first >= 0 && leaves_torus_for_good(line, spans)))
        crossings_from_torus(line, spans, hints, interval, report);
}

/// The point of a crossing, projected onto the surface. Points on the half that faces away from the
/// axis lie on the convex hull. The parameters: u is the angle about the axis, v the angle about
/// the tube, from the side that faces the axis.
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
    // A length of 1.5 times a power of two is never 1. So unit() normalizes the vector both in the
    // world and in the torus's own space. It leaves unit vectors unchanged, and a vector may have
    // unit length in only one of the two.
    p.normal = outward * Real(1.5);
    p.error = gamma<Real>(8) * (torus.reach() * torus.grow);
    p.shading = p.normal;
    p.outermost = out > 0;
    p.parameter = Vec2<Real>(turn(sine, cosine), turn(-up, -out));
    return p;
}

}  // namespace lancer
