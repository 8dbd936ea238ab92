// The crossings of a ray with the true surface of revolution of a plane curve about the y axis.
//
// In the half-plane (radius, y) the surface is the curve (r(s), y(s)). At parameter s the ray is
// taken where it has the height y(s). Let L be the horizontal speed of the ray, q the position of
// its start along its horizontal direction, measured from the axis, and c its distance from the
// axis as seen from above. Eliminating t, a crossing is a root of
//     F(s) = A(s)^2 + (dy c)^2 - (dy r(s))^2,    A(s) = L (y(s) - oy) + dy q,
// which has degree 6 for cubic segments (compare van Wijk, "Ray tracing objects defined by sweeping
// planar cubic splines", ACM TOG 3 (1984)). F is never expanded and then halved: A and r are halved
// as cubics, and the coefficients of F are computed anew from the halves. So precision is kept for
// nearly horizontal rays, for which F is nearly a square.
#pragma once

#include <boost/container/small_vector.hpp>
#include <optional>

#include "tracer/splines/curve.h"
#include "tracer/splines/roots.h"

namespace lancer::splines {

/// A profile (radius, y) prepared for rays.
template <class Real>
struct Revolution {
    Curve<Real> curve;
    bool encloses = false;  ///< the profile is closed, or ends on the axis: a body
    Real outward = 1;       ///< sign for which (y', -r') times it points outwards
};

template <class Real>
Revolution<Real> make_revolution(const PlaneCurve& profile) {
    Revolution<Real> surface{make_curve<Real>(profile), encloses_space(profile), 1};
    if (surface.encloses && signed_area(surface.curve) < 0) surface.outward = -1;
    return surface;
}

template <class Real>
using CurveCrossings = boost::container::small_vector<CurveCrossing<Real>, 8>;

/// F over one segment or a part of it.
template <class Real, std::size_t N>
struct RevolutionPiece {
    Bernstein<Real, N> a;  ///< A
    Bernstein<Real, N> b;  ///< dy r
    Real cc;               ///< (dy c)^2
    Bernstein<Real, 2 * N> f{};
    Real largest = 0;  ///< the largest of the squares of which F is a sum

    RevolutionPiece(const Bernstein<Real, N>& a_, const Bernstein<Real, N>& b_, Real cc_)
        : a(a_), b(b_), cc(cc_) {
        const auto aa = square(a);
        const auto bb = square(b);
        for (std::size_t i = 0; i < f.size(); ++i) f[i] = (aa[i] - bb[i]) + cc;
        largest = cc;
        for (std::size_t i = 0; i <= N; ++i) {
            largest = std::max(largest, std::max(a[i] * a[i], b[i] * b[i]));
        }
    }
    const Bernstein<Real, 2 * N>& coefficients() const { return f; }
    /// Bound on the rounding error of f: two products, a weighted mean and two sums.
    Real noise() const { return 3 * gamma<Real>(6) * largest; }
    std::pair<RevolutionPiece, RevolutionPiece> split() const {
        const auto [a0, a1] = halves(a);
        const auto [b0, b1] = halves(b);
        return {{a0, b0, cc}, {a1, b1, cc}};
    }
    ValueAndSlope<Real> at(Real s) const {
        const auto [va, sa] = evaluate(a, s);
        const auto [vb, sb] = evaluate(b, s);
        return {(va * va - vb * vb) + cc, 2 * (va * sa - vb * sb)};
    }
};

/// A ray in the curve's scale. Its start slides along the ray to near the surface.
template <class Real>
struct RevolutionLine {
    Vec3<Real> origin;
    Vec3<Real> dir;
    Real slide;       ///< the ray's parameter at `origin`
    Real horizontal;  ///< L: length of (dir.x, dir.z)
    Real along;       ///< q: position of the origin along the horizontal direction, from the axis
    Real beside;      ///< c: signed distance of the line from the axis, seen from above
    Real place;       ///< bound on the line's displacement by rounding
};

template <class Real>
RevolutionLine<Real> revolution_line(const Revolution<Real>& surface, const Vec3<Real>& origin,
                                     const Vec3<Real>& dir, Real origin_error) {
    using std::abs;
    using std::sqrt;
    RevolutionLine<Real> line{origin, dir, 0, 0, 0, 0, 0};
    const Vec3<Real> center(0, (surface.curve.min.y + surface.curve.max.y) / 2, 0);
    const Vec3<Real> away = origin - center;
    const Real far = reach(away);
    if (far > 4) {
        line.slide = -dot(away, dir) / dot(dir, dir);
        line.origin = origin + line.slide * dir;
    }
    line.place = origin_error + gamma<Real>(4) * (reach(origin) + far + 8);
    // Directions have lengths near 1. If the square of the horizontal part underflows, that part
    // does not move the line.
    const Real squared = dir.x * dir.x + dir.z * dir.z;
    line.horizontal = is_sound_square(squared) ? sqrt(squared) : Real(0);
    if (line.horizontal == 0) line.dir.x = line.dir.z = 0;
    const Real hx = line.horizontal > 0 ? dir.x / line.horizontal : Real(1);
    const Real hz = line.horizontal > 0 ? dir.z / line.horizontal : Real(0);
    line.along = line.origin.x * hx + line.origin.z * hz;
    line.beside = line.origin.x * hz - line.origin.z * hx;
    return line;
}

/// The crossing of the line with the surface at the root's parameter of a segment.
///
/// \param side  sign of the position along the line, from its point nearest to the axis; 0 if the
///              height decides it
template <class Real>
CurveCrossing<Real> revolution_crossing(const Revolution<Real>& surface,
                                        const RevolutionLine<Real>& line, std::uint32_t segment,
                                        const Root<Real>& root, Real side) {
    using std::abs;
    using std::sqrt;
    const CurveSample<Real> at = sample(surface.curve, segment, root.s);
    const Real r = at.point.x;
    const Real c = abs(line.beside);
    const Real chord = r > c ? sqrt((r - c) * (r + c)) : Real(0);
    const Real rise = at.point.y - line.origin.y;

    CurveCrossing<Real> hit{0, 0, segment, root.s, false};
    Real way = 0;  // position along the horizontal direction, from the point nearest to the axis
    if (side == 0) {
        way = line.horizontal * rise / line.dir.y + line.along;
        side = way < 0 ? Real(-1) : Real(1);
        hit.entering = root.rising == (line.dir.y < 0);
    } else {
        way = side * chord;
        hit.entering = root.rising == (side < 0);
    }
    // t follows from the height or from the radius, whichever changes faster along the ray.
    if (line.dir.y != 0 && abs(line.dir.y) * r >= line.horizontal * chord) {
        hit.t = rise / line.dir.y;
    } else {
        way = side * chord;
        hit.t = (way - line.along) / line.horizontal;
    }

    // A displacement of the line by `place` moves the crossing by place / cosine; near a tangent by
    // about the half chord that it adds.
    const Vec2<Real> tangent = direction(surface.curve, segment, root.s);
    const Real normal = sqrt(tangent.x * tangent.x + tangent.y * tangent.y);
    const Real outwards = r > 0 ? line.horizontal * way / r : line.horizontal;
    const Real speed =
        sqrt(line.dir.x * line.dir.x + line.dir.y * line.dir.y + line.dir.z * line.dir.z);
    const Real approach =
        normal > 0 ? abs(outwards * tangent.y - line.dir.y * tangent.x) / normal : Real(0);
    const Real widest = sqrt(line.place * 4 + line.place * line.place) / speed;
    hit.error = approach * widest > line.place ? line.place / approach : widest;
    hit.t += line.slide;
    hit.error += gamma<Real>(4) * (abs(hit.t) + abs(line.slide));
    return hit;
}

/// Adds the crossings of the line with one segment.
template <class Real, std::size_t N>
void segment_crossings(const Revolution<Real>& surface, const RevolutionLine<Real>& line,
                       bool level, std::uint32_t segment, CurveCrossings<Real>& found) {
    using std::abs;
    const Vec2<Real>* p = surface.curve.segment(segment);
    Bernstein<Real, N> a;
    Bernstein<Real, N> b;
    for (std::size_t i = 0; i <= N; ++i) {
        a[i] = line.horizontal * (p[i].y - line.origin.y);
        if (!level) a[i] += line.dir.y * line.along;
        b[i] = line.dir.y * p[i].x;
    }
    if (level) {
        // Each point of the curve at the ray's height gives two crossings, or none.
        sign_change_roots<Real>(Polynomial<Real, N>{a}, [&](const Root<Real>& root) {
            if (!(sample(surface.curve, segment, root.s).point.x > abs(line.beside))) return;
            found.push_back(revolution_crossing(surface, line, segment, root, Real(-1)));
            found.push_back(revolution_crossing(surface, line, segment, root, Real(1)));
        });
        return;
    }
    const Real c = line.dir.y * line.beside;
    const RevolutionPiece<Real, N> piece(a, b, c * c);
    sign_change_roots<Real>(piece, [&](const Root<Real>& root) {
        found.push_back(revolution_crossing(surface, line, segment, root, Real(0)));
    });
}

/// All crossings of a line with the surface, in order along the line. `origin` and `dir` are in the
/// shape's own space; `origin_error` bounds the start's displacement; `only` restricts the search
/// to one segment. For a body the number of crossings is even, and entries and exits alternate.
template <class Real>
CurveCrossings<Real> crossings(const Revolution<Real>& surface, const Vec3<Real>& origin,
                               const Vec3<Real>& dir, Real origin_error,
                               std::optional<std::uint32_t> only = {}) {
    using std::abs;
    const Curve<Real>& curve = surface.curve;
    const int unit = direction_exponent(dir);
    RevolutionLine<Real> line =
        revolution_line(surface, scaled(origin, -curve.exponent), scaled(dir, -unit),
                        ldexp(origin_error, -curve.exponent));
    CurveCrossings<Real> found;
    if (abs(line.beside) > curve.max.x) return found;

    // A ray that climbs across the whole surface by no more than some rounding errors of a height
    // counts as level. Otherwise its two crossings at each point of its height could not be told
    // apart.
    const Real tallest =
        std::max(abs(curve.min.y - line.origin.y), abs(curve.max.y - line.origin.y));
    const Real indistinct = 64 * unit_roundoff<Real> * tallest;
    const bool level =
        abs(line.dir.y) * (curve.max.x + abs(line.along)) <= line.horizontal * indistinct;
    if (level) line.place += indistinct;
    if (level) line.dir.y = 0;

    // The heights at which the line is within the largest radius. Segments beyond them are skipped.
    const Real middle =
        line.origin.y -
        (line.horizontal > 0 ? line.dir.y * (line.along / line.horizontal) : Real(0));
    const Real span = line.horizontal > 0 ? abs(line.dir.y) * (curve.max.x / line.horizontal)
                                          : std::numeric_limits<Real>::infinity();
    const Real margin = line.place + gamma<Real>(8) * (abs(middle) + span);
    const Real low = middle - span - margin;
    const Real high = middle + span + margin;

    const std::uint32_t first = only.value_or(0);
    const std::uint32_t last = only ? *only + 1 : curve.segments();
    for (std::uint32_t i = first; i < last; ++i) {
        const Vec2<Real>* p = curve.segment(i);
        bool above = true;
        bool below = true;
        for (std::size_t k = 0; k <= curve.degree; ++k) {
            above = above && p[k].y > high;
            below = below && p[k].y < low;
        }
        if (above || below) continue;
        if (curve.degree == 1) {
            segment_crossings<Real, 1>(surface, line, level, i, found);
        } else {
            segment_crossings<Real, 3>(surface, line, level, i, found);
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& x, const auto& y) {
        if (x.t != y.t) return x.t < y.t;
        return x.segment != y.segment ? x.segment < y.segment : x.s < y.s;
    });
    for (std::size_t i = 0; i < found.size(); ++i) {
        found[i].t = ldexp(found[i].t, curve.exponent - unit);
        found[i].error = ldexp(found[i].error, curve.exponent - unit);
        if (surface.encloses && !only) found[i].entering = i % 2 == 0;
    }
    return found;
}

/// Whether a point is inside a surface that encloses space, by the parity of the crossings of the
/// profile beyond the point, straight away from the axis.
template <class Real>
bool contains(const Revolution<Real>& surface, const Vec3<Real>& point) {
    using std::sqrt;
    const Curve<Real>& curve = surface.curve;
    const Vec3<Real> p = scaled(point, -curve.exponent);
    if (!(p.y >= curve.min.y && p.y <= curve.max.y)) return false;
    const Real radius = sqrt(p.x * p.x + p.z * p.z);
    bool inside = false;
    for (std::uint32_t i = 0; i < curve.segments(); ++i) {
        const Vec2<Real>* c = curve.segment(i);
        const auto count = [&](const Root<Real>& root) {
            if (sample(curve, i, root.s).point.x > radius) inside = !inside;
        };
        if (curve.degree == 1) {
            sign_change_roots<Real>(Polynomial<Real, 1>{{c[0].y - p.y, c[1].y - p.y}}, count);
        } else {
            sign_change_roots<Real>(
                Polynomial<Real, 3>{{c[0].y - p.y, c[1].y - p.y, c[2].y - p.y, c[3].y - p.y}},
                count);
        }
    }
    return inside;
}

}  // namespace lancer::splines
