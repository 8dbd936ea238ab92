// A line and a cylinder or cone: where it is inside of the side prolonged, and how far off the
// crossings may be.
#pragma once

#include "tracer/rays/crossing.h"
#include "tracer/rays/faces.h"
#include "tracer/rays/ray.h"
#include "tracer/shapes/traits.h"

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
    bool tilted = true;     ///< false: the axis is one of the coordinate axes
    Real filter_error = 0;  ///< of `small_end` in a plain difference
    Real transform_error =
        0;  ///< bound on how far rounding moved it when a transform put it into the world

    static constexpr SolidTraits traits{.convex = true, .face_by_face = false};
    /// The largest measure in its own space; infinite where none can be too small.
    Real size() const {
        const Real large = radius + slope * height;
        return height < large ? height : large;
    }
};

template <class Real>
struct FrustumLine {
    Vec3<Real> start;       ///< relative to the smaller end
    Vec3<Real> start_perp;  ///< its part perpendicular to the axis
    Vec3<Real> dir_perp;
    Real start_axial;
    Real dir_axial;
};

template <class Real>
void set_start(FrustumLine<Real>& line, const FrustumSolid<Real>& f, const Vec3<Real>& start) {
    line.start = start;
    line.start_axial = dot(f.axis, start);
    line.start_perp = start - line.start_axial * f.axis;
}

/// \param start  of the ray, relative to the smaller end
template <class Real>
FrustumLine<Real> frustum_line(const FrustumSolid<Real>& f, const Ray<Real>& ray,
                               const Vec3<Real>& start) {
    FrustumLine<Real> line;
    set_start(line, f, start);
    line.dir_axial = dot(f.axis, ray.dir);
    line.dir_perp = ray.dir - line.dir_axial * f.axis;
    return line;
}

/// Whether plain differences of places tell all that the query wants to know, for a line that is
/// not known to be inside. See is_settled() of the ball.
///
/// The line stays outside of the side for certain where the textbook discriminant is negative by
/// more than its own rounding and that of what follows here. Every term is a product of two of
/// |start| + R and of |dir| + K, each taken out of a whole by some 8 roundings; the plain
/// difference that `line` was formed from is off by u of the places' sizes.
///
/// Where it is 4096 times as large as that noise, and the line not nearly as steep as the side,
/// the roots by plain numbers and side_bound() are off by less than half the chord / 1000: with S
/// the size of start and radius and k <= 16 by how much qa is less than its terms, the line is
/// displaced by at most (40 + 16 k) u S, and half the chord is more than 1448 sqrt(u) k S / |dir|.
/// The side counts between the caps, which is told from where along the axis the roots lie.
template <class Real, class Last>
bool is_settled(const FrustumSolid<Real>& f, const Ray<Real>& ray, const FrustumLine<Real>& line,
                const IntersectionHints& hints, const RayInterval<Real, Last>& interval) {
    using std::abs;
    using std::sqrt;
    const Real rate = f.slope * line.dir_axial;
    const Real radius = f.radius + f.slope * line.start_axial;
    const Real qa = dot(line.dir_perp, line.dir_perp) - rate * rate;
    const Real qb = dot(line.start_perp, line.dir_perp) - radius * rate;
    const Real qc = dot(line.start_perp, line.start_perp) - radius * radius;
    const Real steep = (1 + f.slope * f.slope) * ray.dir_squared;
    const Real size = size_of_place(ray.filter_error + f.filter_error);
    const Real squares = size * size + f.radius * f.radius;
    const Real noise = gamma<Real>(512) * (steep * (1 + f.slope * f.slope)) * squares;
    const Real discriminant = qb * qb - qa * qc;
    if (discriminant < -noise) return qa > gamma<Real>(64) * steep;
    if (!(discriminant > 4096 * noise && 16 * qa > steep)) return false;

    const Real inv = 1 / qa;
    const Real half = sqrt(discriminant) * inv;
    const Real middle = -qb * inv;
    const Real slack = half / 64;
    const Real in = middle - half;
    const Real out = middle + half;
    if (in - slack > interval.last() || out + slack < interval.first) return true;
    const Real in_axial = line.start_axial + in * line.dir_axial;
    const Real out_axial = line.start_axial + out * line.dir_axial;
    const Real margin =
        abs(line.dir_axial) * slack + gamma<Real>(512) * (size + f.radius + f.height);
    const Real most = f.height + margin;
    if ((in_axial < -margin && out_axial < -margin) || (in_axial > most && out_axial > most))
        return true;
    const auto at = [&](Real t, Real axial) {
        return axial > margin && axial < f.height - margin &&
               interval.accepts_estimate(t - slack, t + slack);
    };
    return interval.may_accept_estimates && ((hints.asks_about(true) && at(in, in_axial)) ||
                                             (hints.asks_about(false) && at(out, out_axial)));
}

/// The line inside the side prolonged to infinity, on the nappe of the solid: from `in` to `out`.
template <class Real>
struct SideSpan {
    static constexpr Real infinity = std::numeric_limits<Real>::infinity();
    Real in = -infinity;
    Real out = infinity;

    // What bound() needs.
    Real slide = 0;
    Real qa = 0;
    Real discriminant = 0;
    Real root = 0;            ///< of the discriminant
    Real divided = infinity;  ///< the root that was divided by qa and so inherits its rounding
    Real rate = 0;
};

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
bool side_span(const FrustumSolid<Real>& f, const FrustumLine<Real>& line,
               const IntersectionHints& hints, Real slab_in, Real slab_out, SideSpan<Real>& span) {
    using std::abs;
    using std::copysign;
    using std::sqrt;
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const Real dd = dot(line.dir_perp, line.dir_perp);
    const Real rate = f.slope * line.dir_axial;
    const Real qa = dd - rate * rate;
    const bool on_side = hints.start_face == frustum_face::side;

    Real slide = 0;
    if (!on_side) {
        if (dd > 0) slide = -dot(line.start_perp, line.dir_perp) / dd;
        if (!(slide > slab_in)) slide = slab_in;
        if (!(slide < slab_out)) slide = slab_out;
        if (!(abs(slide) < infinity)) slide = 0;
    }
    const Vec3<Real> o = line.start_perp + slide * line.dir_perp;
    const Real radius = f.radius + f.slope * (line.start_axial + slide * line.dir_axial);
    const Real qb = dot(o, line.dir_perp) - radius * rate;

    span.slide = slide;
    span.qa = qa;
    span.rate = rate;
    Real low = 0;
    Real high = 0;
    if (on_side) {
        const Real other = qa != 0 ? -2 * qb / qa : infinity;
        low = other < 0 ? other : 0;
        high = other < 0 ? 0 : other;
        span.divided = other;
    } else {
        const Real qc = dot(o, o) - radius * radius;
        const Vec3<Real> v = radius * line.dir_perp - rate * o;
        const Real moment = dot(f.axis, cross(o, line.dir_perp));
        span.discriminant = dot(v, v) - moment * moment;
        if (span.discriminant < 0) {
            // A line steeper than the side meets it always.
            if (qa > 0 && !hints.inside) return false;
            span.discriminant = 0;
        }
        span.root = sqrt(span.discriminant);
        const Real q = -(qb + copysign(span.root, qb));
        if (q == 0) {
            if (qa == 0 && qc > 0 && !hints.inside) return false;
            low = high = qa == 0 && qc <= 0 ? infinity : Real(0);
            if (qa == 0) low = -high;
        } else {
            const Real r0 = qa != 0 ? q / qa : copysign(infinity, q);
            const Real r1 = qc / q;
            span.divided = r0;
            low = r0 < r1 ? r0 : r1;
            high = r0 < r1 ? r1 : r0;
        }
        span.divided += slide;
        low += slide;
        high += slide;
    }
    if (qa > 0) {
        span.in = low;
        span.out = high;
    } else if (qa < 0) {
        // Inside beyond the roots; the nappe of the solid is where the radius grows.
        if (rate > 0)
            span.in = high;
        else
            span.out = low;
    } else if (dd > 0) {
        // Parallel to the side: one finite root.
        if (qb < 0)
            span.in = abs(low) < infinity ? low : high;
        else
            span.out = abs(low) < infinity ? low : high;
    } else if (length(o) > radius && !hints.inside && !on_side) {
        // Parallel to the axis of a cylinder: inside everywhere or nowhere.
        return false;
    }
    return true;
}

/// Bounds the error of a crossing of the side at t.
///
/// The line is displaced by `place` across the axis at most: the part along an axis is taken out
/// twice, of the start and of the direction, and each leaves some 8 roundings of the whole, those
/// of the direction grow with t; where the axis is a coordinate axis it is taken out exactly, and
/// only the last difference is rounded. The radius is rounded at the size of its terms. That
/// changes qa t^2 + 2 qb t + qc by up to w at the root, hence the discriminant by |qa| w; a root by
/// w over twice the derivative, or near a tangent by the half chord that it adds. From a start on
/// the side the other root is -2 qb / qa, and what is left of the direction turns the line about
/// the start: qb changes by that times R.
template <class Real>
Real side_bound(const FrustumSolid<Real>& f, const Ray<Real>& ray, const FrustumLine<Real>& line,
                const SideSpan<Real>& span, bool on_side, Real t) {
    using std::abs;
    using std::sqrt;
    Real place = ray.origin_error + f.transform_error +
                 gamma<Real>(4) * (length(line.start_perp) + f.radius);
    const Real left_of_dir = f.tilted ? gamma<Real>(8) * sqrt(ray.dir_squared) : Real(0);
    if (f.tilted) place += gamma<Real>(8) * length(line.start) + left_of_dir * abs(t);
    if (f.slope != 0)
        place +=
            gamma<Real>(6) * f.slope * (abs(line.start_axial) + abs(span.slide * line.dir_axial));
    const Real size =
        abs(f.radius + f.slope * (line.start_axial + t * line.dir_axial)) * (1 + f.slope);
    const Real w = place * (2 * size + place);
    const Real steep = abs(span.qa);
    const Real terms = length(line.dir_perp) + abs(span.rate);
    Real along = 0;
    if (on_side)
        along = 2 * (place * terms + left_of_dir * (size + terms * abs(t))) / steep;
    else
        along = span.discriminant > 4 * steep * w ? Real(0.54) * w / span.root : sqrt(w / steep);
    if (t == span.divided) along += gamma<Real>(4) * (terms * terms / steep) * abs(t - span.slide);
    return along + gamma<Real>(6) * (abs(t) + abs(span.slide));
}

/// Bounds the error of a crossing of a cap's plane at t. The direction along the axis is rounded at
/// the size of its terms.
template <class Real>
Real cap_bound(const FrustumSolid<Real>& f, const Ray<Real>& ray, const FrustumLine<Real>& line,
               const Vec3<Real>& from_end, Real t) {
    using std::abs;
    const Vec3<Real> steep = absolute(f.axis);
    const Real height =
        ray.origin_error + f.transform_error + gamma<Real>(4) * dot(steep, absolute(from_end));
    const Real rate = gamma<Real>(3) * dot(steep, absolute(ray.dir));
    return (height + rate * abs(t)) / abs(line.dir_axial) + gamma<Real>(3) * abs(t);
}

}  // namespace lancer
