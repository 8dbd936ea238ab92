// Cylinders and cones, truncated or not, as one solid whose radius is linear along its axis.
#pragma once

#include "tracer/rays/faces.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/frustum_line.h"

namespace lancer {

/// The solid is the side's interval within that between the two caps.
///
/// \param line  computed from the plain difference of points
template <class Real, class Last, class Report>
[[gnu::noinline]] void all_crossings(const FrustumSolid<Real>& f, const Ray<Real>& ray,
                                     IntersectionHints hints, FrustumLine<Real> line,
                                     const RayInterval<Real, Last>& interval, Report& report) {
    using std::abs;
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const bool on_side = hints.start_face == frustum_face::side;
    if (!ray.whole) set_start(line, f, start_from(ray, f.small_end));

    Crossing<Real> in{-infinity, 0, 0, true};
    Crossing<Real> out{infinity, 0, 0, false};
    bool certainly_inside = hints.inside && f.capped;
    const Real to_small = -line.start_axial;
    const Vec3<Real> from_large = start_from(ray, f.large_end);
    const Real to_large = -dot(f.axis, from_large);
    if (line.dir_axial == 0) {
        if ((to_small > 0 || to_large < 0) && !certainly_inside) return;
    } else {
        const bool forward = line.dir_axial > 0;
        Crossing<Real> small{to_small / line.dir_axial, 0, frustum_face::small_cap, forward};
        Crossing<Real> large{to_large / line.dir_axial, 0, frustum_face::large_cap, !forward};
        if (hints.start_face == frustum_face::small_cap) small.t = 0;
        if (hints.start_face == frustum_face::large_cap) large.t = 0;
        in = forward ? small : large;
        out = forward ? large : small;
        if (f.capped && hints.start_face == in.face) certainly_inside = true;
        if (interval.ends_before(in.t)) return;
    }

    SideSpan<Real> span;
    const IntersectionHints side_hints{hints.start_face, certainly_inside};
    if (!side_span(f, line, side_hints, in.t, out.t, span)) return;
    const auto offer = [&](Crossing<Real> c) {
        if (c.face == hints.start_face && c.t == 0) return;
        if (!(abs(c.t) < infinity) || interval.ends_before(c.t) || !hints.asks_about(c.entering))
            return;
        c.error = c.face == frustum_face::side
                      ? side_bound(f, ray, line, span, on_side, c.t)
                      : cap_bound(f, ray, line,
                                  c.face == frustum_face::small_cap ? line.start : from_large, c.t);
        if (interval.holds(c)) report(c);
    };
    const Crossing<Real> side_in{span.in, 0, frustum_face::side, true};
    const Crossing<Real> side_out{span.out, 0, frustum_face::side, false};
    if (!f.capped) {
        const auto is_between = [&](Real t) { return t >= in.t && t <= out.t; };
        if (is_between(span.in)) offer(side_in);
        if (is_between(span.out)) offer(side_out);
        return;
    }
    if (on_side && span.in == 0) certainly_inside = true;
    if (!(in.t > span.in)) in = side_in;
    if (!(out.t < span.out)) out = side_out;
    if (in.t > out.t && !certainly_inside) return;
    in.chord = out.t - in.t;
    offer(in);
    offer(out);
}

template <class Real, class Last, class Report>
void crossings(const FrustumSolid<Real>& f, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    const FrustumLine<Real> plain = frustum_line(f, ray, ray.origin - f.small_end);
    if (!hints.inside && hints.start_face == none && is_settled(f, ray, plain, hints, interval))
        return;
    all_crossings(f, ray, hints, plain, interval, report);
}

/// The point of a crossing, projected onto its face.
template <class Real>
SurfacePoint<Real> surface_point(const FrustumSolid<Real>& f, const Ray<Real>& ray, Real t,
                                 std::uint32_t face) {
    if (face != frustum_face::side) {
        const bool small = face == frustum_face::small_cap;
        const Vec3<Real> end = small ? f.small_end : f.large_end;
        Vec3<Real> offset = start_from(ray, end) + t * ray.dir;
        offset -= dot(f.axis, offset) * f.axis;
        const Vec3<Real> normal = small ? -f.axis : f.axis;
        return {end,    offset, gamma<Real>(4) * dot(absolute(f.axis), absolute(offset)),
                normal, normal, Vec2<Real>(0)};
    }
    const FrustumLine<Real> line = frustum_line(f, ray, start_from(ray, f.small_end));
    const Real axial = line.start_axial + t * line.dir_axial;
    // If the start is far away, its rounding errors leave a part along the axis. It is subtracted
    // once more, so that the radius stays perpendicular to the axis.
    Vec3<Real> radial = line.start_perp + t * line.dir_perp;
    if (f.tilted) radial -= dot(f.axis, radial) * f.axis;
    const Real distance = length(radial);
    const Real radius = f.radius + f.slope * axial;
    if (!(distance > 0)) {  // the apex itself
        return {f.small_end, axial * f.axis, gamma<Real>(6) * radius,
                -f.axis,     -f.axis,        Vec2<Real>(0)};
    }
    const Vec3<Real> outward = radial / distance;
    const Vec3<Real> normal = outward - f.slope * f.axis;
    const Vec3<Real> offset = axial * f.axis + radius * outward;
    return {f.small_end, offset, gamma<Real>(8) * length(offset), normal, normal, Vec2<Real>(0)};
}

}  // namespace lancer
