// Cylinders and cones, truncated or not: one solid, whose radius is linear along its axis.
#pragma once

#include "tracer/ray.h"

namespace lancer {

/// All points whose distance from the axis is at most radius + slope s, 0 <= s <= height, with s
/// measured from the smaller end. A cone's apex is thus the reference itself, and near it
/// everything keeps its relative precision.
template <class Real>
struct FrustumSolid {
    Vec3<Real> small_end;  ///< centre of the smaller end: radius + slope 0
    Vec3<Real> large_end;
    Vec3<Real> axis;  ///< unit, from the smaller end to the larger
    Real height;
    Real radius;  ///< of the smaller end, >= 0
    Real slope;   ///< >= 0
    bool capped;
    bool tilted = true;  ///< false: the axis is one of the coordinate axes
    Real placed = 0;  ///< bound on how far rounding moved it when a transform put it into the world
};

namespace frustum_face {
inline constexpr std::uint32_t mantle = 0;
inline constexpr std::uint32_t small_cap = 1;
inline constexpr std::uint32_t large_cap = 2;
}  // namespace frustum_face

template <class Real>
struct FrustumLine {
    Vec3<Real> start;       ///< relative to the smaller end
    Vec3<Real> start_perp;  ///< its part perpendicular to the axis
    Vec3<Real> dir_perp;
    Real start_axial;
    Real dir_axial;
};

template <class Real>
FrustumLine<Real> frustum_line(const FrustumSolid<Real>& f, const Ray<Real>& ray) {
    FrustumLine<Real> line;
    line.start = start_from(ray, f.small_end);
    line.start_axial = dot(f.axis, line.start);
    line.start_perp = line.start - line.start_axial * f.axis;
    line.dir_axial = dot(f.axis, ray.dir);
    line.dir_perp = ray.dir - line.dir_axial * f.axis;
    return line;
}

/// Where the line is inside the mantle prolonged to infinity, on the nappe of the solid.
/// Returns false when nowhere.
///
/// With the radius R and the perpendicular part o at the start, their rates K and d along the line,
/// the line is inside where qa t^2 + 2 qb t + qc <= 0: qa = d·d - K^2, qb = o·d - R K, qc = o·o -
/// R^2. Its discriminant is |R d - K o|^2 - (w·(o x d))^2 by Lagrange's identity, a difference of
/// two squares, both of which do not change when the start slides along the line; so the start
/// slides to where the line is nearest to the axis, and both keep their relative precision, at an
/// apex as well (the moment form; for the cylinder, K = 0, this is r^2 - distance^2 of the two
/// axes).
template <class Real>
bool mantle_span(const FrustumSolid<Real>& f, const Ray<Real>& ray, const FrustumLine<Real>& line,
                 const Known& known, Real slab_in, Real slab_out, Crossing<Real>& in,
                 Crossing<Real>& out) {
    using std::abs;
    using std::copysign;
    using std::sqrt;
    const Real dd = dot(line.dir_perp, line.dir_perp);
    const Real rate = f.slope * line.dir_axial;
    const Real d_length = sqrt(dd);
    const Real qa = (d_length - rate) * (d_length + rate);
    const bool on_mantle = known.start_face == frustum_face::mantle;

    Real slide = 0;
    if (!on_mantle) {
        if (dd > 0) slide = -dot(line.start_perp, line.dir_perp) / dd;
        if (!(slide > slab_in)) slide = slab_in;
        if (!(slide < slab_out)) slide = slab_out;
        if (!(abs(slide) < std::numeric_limits<Real>::infinity())) slide = 0;
    }
    // What rounding moves the line by, across the axis. The part along an axis is taken out twice,
    // of the start and of the direction, and each leaves some 8 roundings of the whole; where the
    // axis is a coordinate axis it is taken out exactly, and only the last difference is rounded.
    // The radius is rounded at the size of its terms.
    Real place =
        ray.origin_error + f.placed + gamma<Real>(4) * (length(line.start_perp) + f.radius);
    if (f.tilted) place += gamma<Real>(16) * length(line.start);
    if (f.slope != 0)
        place += gamma<Real>(6) * f.slope * (abs(line.start_axial) + abs(slide * line.dir_axial));
    const Vec3<Real> o = line.start_perp + slide * line.dir_perp;
    const Real radius = f.radius + f.slope * (line.start_axial + slide * line.dir_axial);
    const Real qb = dot(o, line.dir_perp) - radius * rate;

    Real discriminant = 0;
    // The root that was divided by qa inherits the rounding of qa, which is a difference.
    Real divided = std::numeric_limits<Real>::infinity();
    Real low = 0;
    Real high = 0;
    if (on_mantle) {
        const Real other = qa != 0 ? -2 * qb / qa : std::numeric_limits<Real>::infinity();
        low = other < 0 ? other : 0;
        high = other < 0 ? 0 : other;
        divided = other;
    } else {
        const Real o_length = length(o);
        const Real qc = (o_length - abs(radius)) * (o_length + abs(radius));
        const Real v = length(radius * line.dir_perp - rate * o);
        const Real moment = abs(dot(f.axis, cross(o, line.dir_perp)));
        discriminant = (v - moment) * (v + moment);
        if (discriminant < 0) {
            // A line steeper than the mantle meets it always.
            if (qa > 0 && !known.inside) return false;
            discriminant = 0;
        }
        const Real root = sqrt(discriminant);
        const Real q = -(qb + copysign(root, qb));
        if (q == 0) {
            if (qa == 0 && qc > 0 && !known.inside) return false;
            low = high = qa == 0 && qc <= 0 ? std::numeric_limits<Real>::infinity() : Real(0);
            if (qa == 0) low = -high;
        } else {
            const Real r0 = qa != 0 ? q / qa : copysign(std::numeric_limits<Real>::infinity(), q);
            const Real r1 = qc / q;
            divided = r0;
            low = r0 < r1 ? r0 : r1;
            high = r0 < r1 ? r1 : r0;
        }
        divided += slide;
        low += slide;
        high += slide;
    }

    const auto error_at = [&](Real t) {
        // A displacement by `place` changes qa t^2 + 2 qb t + qc by up to w at the root, hence the
        // discriminant by |qa| w; a root by w over twice the derivative, or near a tangent by the
        // half chord that it adds. From a start on the mantle the other root is -2 qb / qa.
        const Real size =
            abs(f.radius + f.slope * (line.start_axial + t * line.dir_axial)) * (1 + f.slope);
        const Real w = place * (2 * size + place);
        const Real steep = abs(qa);
        Real along = 0;
        if (on_mantle)
            along = 2 * place * (d_length + abs(rate)) / steep;
        else
            along = discriminant > 4 * steep * w ? Real(0.54) * w / sqrt(discriminant)
                                                 : sqrt(w / steep);
        if (t == divided) {
            const Real terms = d_length + abs(rate);
            along += gamma<Real>(4) * (terms * terms / steep) * abs(t - slide);
        }
        return along + gamma<Real>(6) * (abs(t) + abs(slide));
    };
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    in = {-infinity, 0, frustum_face::mantle, true};
    out = {infinity, 0, frustum_face::mantle, false};
    if (qa > 0) {
        in.t = low;
        out.t = high;
    } else if (qa < 0) {
        // Inside beyond the roots; the nappe of the solid is where the radius grows.
        if (rate > 0)
            in.t = high;
        else
            out.t = low;
    } else if (dd > 0) {
        // Parallel to the mantle: one finite root.
        if (qb < 0)
            in.t = abs(low) < infinity ? low : high;
        else
            out.t = abs(low) < infinity ? low : high;
    } else {
        // Parallel to the axis of a cylinder: inside everywhere or nowhere.
        if (length(o) > radius && !known.inside && !on_mantle) return false;
        return true;
    }
    if (abs(in.t) < infinity) in.error = error_at(in.t);
    if (abs(out.t) < infinity) out.error = error_at(out.t);
    return true;
}

/// The solid is the mantle's interval within that between the two caps.
template <class Real, class Report>
void crossings(const FrustumSolid<Real>& f, const Ray<Real>& ray, const Known& known,
               Report&& report) {
    using std::abs;
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const FrustumLine<Real> line = frustum_line(f, ray);

    Crossing<Real> slab_in{-infinity, 0, 0, true};
    Crossing<Real> slab_out{infinity, 0, 0, false};
    bool certainly_inside = known.inside && f.capped;
    const Real to_small = -line.start_axial;
    const Vec3<Real> from_large = start_from(ray, f.large_end);
    const Real to_large = -dot(f.axis, from_large);
    if (line.dir_axial == 0) {
        if ((to_small > 0 || to_large < 0) && !certainly_inside) return;
    } else {
        const bool forward = line.dir_axial > 0;
        const Real small_error = ray.origin_error + f.placed +
                                 gamma<Real>(4) * dot(absolute(f.axis), absolute(line.start));
        const Real large_error = ray.origin_error + f.placed +
                                 gamma<Real>(4) * dot(absolute(f.axis), absolute(from_large));
        // The direction along the axis is rounded at the size of its terms.
        const Real rate_error = gamma<Real>(3) * dot(absolute(f.axis), absolute(ray.dir));
        Crossing<Real> small{to_small / line.dir_axial, small_error / abs(line.dir_axial),
                             frustum_face::small_cap, forward};
        Crossing<Real> large{to_large / line.dir_axial, large_error / abs(line.dir_axial),
                             frustum_face::large_cap, !forward};
        if (known.start_face == frustum_face::small_cap) small.t = 0;
        if (known.start_face == frustum_face::large_cap) large.t = 0;
        const Real relative = gamma<Real>(2) + rate_error / abs(line.dir_axial);
        small.error += relative * abs(small.t);
        large.error += relative * abs(large.t);
        slab_in = forward ? small : large;
        slab_out = forward ? large : small;
        if (f.capped && known.start_face == slab_in.face) certainly_inside = true;
    }

    Crossing<Real> in;
    Crossing<Real> out;
    const Known mantle_known{known.start_face, certainly_inside};
    if (!mantle_span(f, ray, line, mantle_known, slab_in.t, slab_out.t, in, out)) return;
    const bool start_on_mantle = known.start_face == frustum_face::mantle;
    if (!f.capped) {
        for (const Crossing<Real>& c : {in, out}) {
            const bool is_start = start_on_mantle && c.t == 0;
            if (!is_start && c.t >= slab_in.t && c.t <= slab_out.t) report(c);
        }
        return;
    }
    if (start_on_mantle && in.t == 0) certainly_inside = true;
    if (slab_in.t > in.t) in = slab_in;
    if (slab_out.t < out.t) out = slab_out;
    if (in.t > out.t && !certainly_inside) return;
    in.chord = out.t - in.t;
    const auto is_start = [&](const Crossing<Real>& c) {
        return c.face == known.start_face && c.t == 0;
    };
    if (!is_start(in) && in.t > -infinity) report(in);
    if (!is_start(out) && out.t < infinity) report(out);
}

/// The crossing's point, put back onto its face.
template <class Real>
SurfacePoint<Real> surface_point(const FrustumSolid<Real>& f, const Ray<Real>& ray, Real t,
                                 std::uint32_t face) {
    if (face != frustum_face::mantle) {
        const bool small = face == frustum_face::small_cap;
        const Vec3<Real> end = small ? f.small_end : f.large_end;
        Vec3<Real> offset = start_from(ray, end) + t * ray.dir;
        offset -= dot(f.axis, offset) * f.axis;
        const Vec3<Real> normal = small ? -f.axis : f.axis;
        return {end,    offset, gamma<Real>(4) * dot(absolute(f.axis), absolute(offset)),
                normal, normal, Vec2<Real>(0)};
    }
    const FrustumLine<Real> line = frustum_line(f, ray);
    const Real axial = line.start_axial + t * line.dir_axial;
    const Vec3<Real> radial = line.start_perp + t * line.dir_perp;
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
