// The crossings of a ray with the true surface of a plane outline (x, z) that is extruded along y.
//
// Seen from above, the ray is a line. The outline's signed distance from it is a polynomial of the
// outline's own degree. The crossings with the infinite cylinder over the outline come in pairs.
// The solid contains the parts of these intervals between the two caps, so caps and sides meet
// without a gap.
#pragma once

#include <boost/container/small_vector.hpp>
#include <limits>

#include "tracer/splines/curve.h"
#include "tracer/splines/roots.h"

namespace lancer::splines {

/// An outline (x, z) prepared for rays.
template <class Real>
struct Extrusion {
    Curve<Real> curve;
    Real bottom = 0;  ///< heights in the curve's scale
    Real top = 1;
    bool capped = true;
    Real outward = 1;  ///< sign for which (z', -x') times it points outwards

    std::uint32_t bottom_face() const { return curve.segments(); }
    std::uint32_t top_face() const { return curve.segments() + 1; }
};

template <class Real>
Extrusion<Real> make_extrusion(const PlaneCurve& outline, double bottom, double top, bool capped) {
    Extrusion<Real> surface;
    surface.curve = make_curve<Real>(outline, std::max(std::abs(bottom), std::abs(top)));
    surface.bottom = static_cast<Real>(ldexp(bottom, -surface.curve.exponent));
    surface.top = static_cast<Real>(ldexp(top, -surface.curve.exponent));
    surface.capped = capped;
    if (signed_area(surface.curve) < 0) surface.outward = -1;
    return surface;
}

/// A crossing with a side (segment < segments()) or a cap.
template <class Real>
using ExtrusionCrossings = boost::container::small_vector<CurveCrossing<Real>, 8>;

/// Calls found(segment, root) wherever the outline crosses the line through (x, z) with the
/// direction (dx, dz), seen from above.
template <class Real, class Found>
void outline_roots(const Curve<Real>& curve, Real x, Real z, Real dx, Real dz, Found&& found) {
    const auto beside = [&](const Vec2<Real>& p) { return dx * (p.y - z) - dz * (p.x - x); };
    for (std::uint32_t i = 0; i < curve.segments(); ++i) {
        const Vec2<Real>* p = curve.segment(i);
        const auto report = [&](const Root<Real>& root) { found(i, root); };
        if (curve.degree == 1) {
            sign_change_roots<Real>(Polynomial<Real, 1>{{beside(p[0]), beside(p[1])}}, report);
        } else {
            sign_change_roots<Real>(
                Polynomial<Real, 3>{{beside(p[0]), beside(p[1]), beside(p[2]), beside(p[3])}},
                report);
        }
    }
}

/// Whether (x, z) is inside the outline, by the parity of the crossings in one direction.
template <class Real>
bool outline_contains(const Curve<Real>& curve, Real x, Real z) {
    bool inside = false;
    outline_roots(curve, x, z, Real(1), Real(0), [&](std::uint32_t i, const Root<Real>& root) {
        if (sample(curve, i, root.s).point.x > x) inside = !inside;
    });
    return inside;
}

/// A line in the curve's scale. Its start slides along the line to near the surface.
template <class Real>
struct ExtrusionLine {
    Vec3<Real> origin;
    Vec3<Real> dir;
    int unit;         ///< `dir` is the given direction times 2^-unit
    Real slide;       ///< the line's parameter at `origin`
    Real horizontal;  ///< length of (dir.x, dir.z)
    Real place;       ///< bound on the line's displacement by rounding
};

template <class Real>
ExtrusionLine<Real> extrusion_line(const Extrusion<Real>& surface, const Vec3<Real>& origin,
                                   const Vec3<Real>& dir, Real origin_error) {
    using std::sqrt;
    const Curve<Real>& curve = surface.curve;
    const int unit = direction_exponent(dir);
    ExtrusionLine<Real> line{scaled(origin, -curve.exponent), scaled(dir, -unit), unit, 0, 0, 0};
    const Vec3<Real> center((curve.min.x + curve.max.x) / 2, (surface.bottom + surface.top) / 2,
                            (curve.min.y + curve.max.y) / 2);
    const Vec3<Real> away = line.origin - center;
    const Real far = reach(away);
    line.place =
        ldexp(origin_error, -curve.exponent) + gamma<Real>(4) * (reach(line.origin) + far + 8);
    if (far > 4) {
        line.slide = -dot(away, line.dir) / dot(line.dir, line.dir);
        line.origin += line.slide * line.dir;
    }
    line.horizontal = sqrt(line.dir.x * line.dir.x + line.dir.z * line.dir.z);
    return line;
}

/// The crossings of a non-vertical line with the infinite cylinder over the outline, in order along
/// the line. t is the parameter of the scaled line.
template <class Real>
ExtrusionCrossings<Real> endless_crossings(const Extrusion<Real>& surface,
                                           const ExtrusionLine<Real>& line) {
    using std::abs;
    using std::sqrt;
    const Curve<Real>& curve = surface.curve;
    const Real hx = line.dir.x / line.horizontal;
    const Real hz = line.dir.z / line.horizontal;
    const Real speed = sqrt(dot(line.dir, line.dir));
    const Real widest = sqrt(line.place * 4 + line.place * line.place) / speed;
    ExtrusionCrossings<Real> sides;
    const auto add = [&](std::uint32_t segment, const Root<Real>& root) {
        const Vec2<Real> on = sample(curve, segment, root.s).point;
        const Real way = hx * (on.x - line.origin.x) + hz * (on.y - line.origin.z);
        const Vec2<Real> tangent = direction(curve, segment, root.s);
        const Real normal = sqrt(tangent.x * tangent.x + tangent.y * tangent.y);
        const Real approach =
            normal > 0 ? line.horizontal * abs(hx * tangent.y - hz * tangent.x) / normal : Real(0);
        CurveCrossing<Real> hit{way / line.horizontal + line.slide, 0, segment, root.s, false};
        hit.error = approach * widest > line.place ? line.place / approach : widest;
        hit.error += gamma<Real>(4) * (abs(hit.t) + abs(line.slide));
        sides.push_back(hit);
    };
    outline_roots(curve, line.origin.x, line.origin.z, hx, hz, add);
    std::sort(sides.begin(), sides.end(), [](const auto& x, const auto& y) {
        if (x.t != y.t) return x.t < y.t;
        return x.segment != y.segment ? x.segment < y.segment : x.s < y.s;
    });
    for (std::size_t i = 0; i < sides.size(); ++i) sides[i].entering = i % 2 == 0;
    return sides;
}

/// The crossings of a line with one side, of infinite height.
template <class Real>
ExtrusionCrossings<Real> side_crossings(const Extrusion<Real>& surface, const Vec3<Real>& origin,
                                        const Vec3<Real>& dir, Real origin_error,
                                        std::uint32_t segment) {
    const ExtrusionLine<Real> line = extrusion_line(surface, origin, dir, origin_error);
    ExtrusionCrossings<Real> found;
    if (!(line.horizontal > 0)) return found;
    for (CurveCrossing<Real> c : endless_crossings(surface, line)) {
        if (c.segment != segment) continue;
        c.t = ldexp(c.t, surface.curve.exponent - line.unit);
        found.push_back(c);
    }
    return found;
}

/// All crossings of a line with the surface, in order along the line. `origin` and `dir` are in the
/// shape's own space.
template <class Real>
ExtrusionCrossings<Real> crossings(const Extrusion<Real>& surface, const Vec3<Real>& origin,
                                   const Vec3<Real>& dir, Real origin_error,
                                   const KnownStart& start = {}) {
    using std::abs;
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const Curve<Real>& curve = surface.curve;
    const ExtrusionLine<Real> line = extrusion_line(surface, origin, dir, origin_error);
    ExtrusionCrossings<Real> found;
    const bool vertical = !(line.horizontal > 0);
    if (vertical && !outline_contains(curve, line.origin.x, line.origin.z)) return found;
    auto sides = vertical ? ExtrusionCrossings<Real>{} : endless_crossings(surface, line);
    std::size_t start_side = sides.size();
    if (start.face < curve.segments()) {
        start_side = start_crossing(sides, surface.capped, start.inside);
        if (start_side < sides.size()) sides[start_side].t = 0;
    }

    // The slab between the caps.
    CurveCrossing<Real> slab_in{-infinity, 0, surface.bottom_face(), 0, true};
    CurveCrossing<Real> slab_out{infinity, 0, surface.top_face(), 0, false};
    if (line.dir.y == 0) {
        if (line.origin.y < surface.bottom || line.origin.y > surface.top) return found;
    } else {
        const auto cap = [&](Real height, std::uint32_t face, bool entering) {
            CurveCrossing<Real> c{(height - line.origin.y) / line.dir.y + line.slide, 0, face, 0,
                                  entering};
            if (start.face == face) c.t = 0;
            c.error = line.place / abs(line.dir.y) + gamma<Real>(4) * (abs(c.t) + abs(line.slide));
            return c;
        };
        const bool up = line.dir.y > 0;
        slab_in = up ? cap(surface.bottom, surface.bottom_face(), true)
                     : cap(surface.top, surface.top_face(), true);
        slab_out = up ? cap(surface.top, surface.top_face(), false)
                      : cap(surface.bottom, surface.bottom_face(), false);
    }

    const auto report = [&](CurveCrossing<Real> c) {
        if (start.face == c.segment && c.t == 0) return;
        c.t = ldexp(c.t, curve.exponent - line.unit);
        c.error = ldexp(c.error, curve.exponent - line.unit);
        found.push_back(c);
    };
    if (!surface.capped) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            if (i != start_side && sides[i].t >= slab_in.t && sides[i].t <= slab_out.t) {
                report(sides[i]);
            }
        }
        return found;
    }
    if (vertical) {
        report(slab_in);
        report(slab_out);
        return found;
    }
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
        const bool begins_at_start = i == start_side;
        const bool ends_at_start = i + 1 == start_side;
        const CurveCrossing<Real>& in = slab_in.t > sides[i].t ? slab_in : sides[i];
        const CurveCrossing<Real>& out = slab_out.t < sides[i + 1].t ? slab_out : sides[i + 1];
        if (!(in.t <= out.t)) continue;
        if (!(begins_at_start && &in == &sides[i])) report(in);
        if (!(ends_at_start && &out == &sides[i + 1])) report(out);
    }
    return found;
}

/// Whether a point is inside the capped solid.
template <class Real>
bool contains(const Extrusion<Real>& surface, const Vec3<Real>& point) {
    const Vec3<Real> p = scaled(point, -surface.curve.exponent);
    return p.y > surface.bottom && p.y < surface.top && outline_contains(surface.curve, p.x, p.z);
}

}  // namespace lancer::splines
