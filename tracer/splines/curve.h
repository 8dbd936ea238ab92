// A plane curve prepared for rays: in the tracer's number type, and scaled to a size near 1. So
// products of four lengths neither overflow nor underflow, whatever the units of the scene are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/splines.h"
#include "tracer/splines/bernstein.h"

namespace lancer::splines {

/// A chain of Bezier segments of degree 1 or 3; see PlaneCurve. Coordinates are those of the
/// shape's own space times 2^-exponent.
template <class Real>
struct Curve {
    std::size_t degree = 1;
    std::vector<Vec2<Real>> points;
    int exponent = 0;
    Vec2<Real> min;  ///< bounds of the control points
    Vec2<Real> max;

    std::uint32_t segments() const {
        return static_cast<std::uint32_t>((points.size() - 1) / degree);
    }
    const Vec2<Real>* segment(std::uint32_t index) const { return &points[index * degree]; }
};

/// \param extent  >= 0, a length that must not exceed about 1 after scaling either: a prism's
/// height
template <class Real>
Curve<Real> make_curve(const PlaneCurve& plane, double extent = 0) {
    double size = extent;
    for (const Vec2d& p : plane.points) size = std::max({size, std::abs(p.x), std::abs(p.y)});
    Curve<Real> curve;
    curve.degree = static_cast<std::size_t>(plane.degree);
    curve.exponent = size > 0 ? ilogb(size) : 0;
    curve.points.reserve(plane.points.size());
    for (const Vec2d& p : plane.points) {
        curve.points.emplace_back(static_cast<Real>(ldexp(p.x, -curve.exponent)),
                                  static_cast<Real>(ldexp(p.y, -curve.exponent)));
    }
    curve.min = curve.max = curve.points.front();
    for (const Vec2<Real>& p : curve.points) {
        curve.min = {std::min(curve.min.x, p.x), std::min(curve.min.y, p.y)};
        curve.max = {std::max(curve.max.x, p.x), std::max(curve.max.y, p.y)};
    }
    return curve;
}

/// A point of one segment, and the derivative there.
template <class Real>
struct CurveSample {
    Vec2<Real> point;
    Vec2<Real> tangent;
};

template <class Real>
CurveSample<Real> sample(const Curve<Real>& curve, std::uint32_t segment, Real s) {
    const Vec2<Real>* p = curve.segment(segment);
    if (curve.degree == 1) {
        const auto [point, tangent] = evaluate(std::array{p[0], p[1]}, s);
        return {point, tangent};
    }
    const auto [point, tangent] = evaluate(std::array{p[0], p[1], p[2], p[3]}, s);
    return {point, tangent};
}

/// The direction of the curve. It is 0 only if the segment is a single point. Where the derivative
/// vanishes (coincident control points, a cusp), it is that of a nearby point inside the segment.
template <class Real>
Vec2<Real> direction(const Curve<Real>& curve, std::uint32_t segment, Real s) {
    Vec2<Real> tangent = sample(curve, segment, s).tangent;
    for (Real step = Real(1) / 4096; tangent == Vec2<Real>(0) && step < 1; step *= 8) {
        tangent = sample(curve, segment, s < Real(0.5) ? s + step : s - step).tangent;
    }
    return tangent;
}

/// Twice the area that the curve encloses with the axis x = 0, positive if it runs
/// counter-clockwise: the integral of x dy - y dx over a closed curve, or over one that starts and
/// ends on the axis.
template <class Real>
Real signed_area(const Curve<Real>& curve) {
    const auto wedge = [](const Vec2<Real>& a, const Vec2<Real>& b) {
        return a.x * b.y - a.y * b.x;
    };
    Real area = 0;
    for (std::uint32_t i = 0; i < curve.segments(); ++i) {
        const Vec2<Real>* p = curve.segment(i);
        if (curve.degree == 1) {
            area += wedge(p[0], p[1]);
        } else {  // integrals of products of Bernstein polynomials, collected by pairs of points
            area += (6 * wedge(p[0], p[1]) + 3 * wedge(p[0], p[2]) + wedge(p[0], p[3]) +
                     3 * wedge(p[1], p[2]) + 3 * wedge(p[1], p[3]) + 6 * wedge(p[2], p[3])) /
                    10;
        }
    }
    return area;
}

/// One crossing of a line with a surface made from a curve.
template <class Real>
struct CurveCrossing {
    Real t;
    Real error;  ///< bound on the error of t
    std::uint32_t segment;
    Real s;         ///< parameter within the segment
    bool entering;  ///< for bodies it follows from the order along the line, so that it alternates
                    ///< in
    ///< spite of rounding
};

/// What is known about the start of a line.
struct KnownStart {
    static constexpr std::uint32_t nowhere = 0xFFFFFFFF;
    std::uint32_t face = nowhere;  ///< it starts on this face; the crossing there is not reported
    bool inside = false;           ///< it continues inside the body
};

/// Finds the crossing at which the line starts: of the right kind (entry or exit), the one nearest
/// to 0, if it is within 4 of its error bounds. Returns its index, or the number of crossings.
template <class Crossings>
std::size_t start_crossing(const Crossings& found, bool body, bool inside) {
    using std::abs;
    std::size_t best = found.size();
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (body && found[i].entering != inside) continue;
        if (abs(found[i].t) > 4 * found[i].error) continue;
        if (best == found.size() || abs(found[i].t) < abs(found[best].t)) best = i;
    }
    return best;
}

/// The curve parameter of the crossing nearest to t; `otherwise` if there is none.
template <class Crossings, class Real>
Real nearest(const Crossings& found, Real t, Real otherwise) {
    using std::abs;
    Real s = otherwise;
    Real least = std::numeric_limits<Real>::infinity();
    for (const auto& c : found) {
        if (abs(c.t - t) < least) {
            least = abs(c.t - t);
            s = c.s;
        }
    }
    return s;
}

/// The largest absolute value of the components.
template <class Real>
Real reach(const Vec3<Real>& v) {
    return max_component(absolute(v));
}

/// e such that 2^-e times the direction has a largest component near 1.
template <class Real>
int direction_exponent(const Vec3<Real>& dir) {
    return ilogb(reach(dir));
}

template <class Real>
Vec3<Real> scaled(const Vec3<Real>& v, int exponent) {
    return {ldexp(v.x, exponent), ldexp(v.y, exponent), ldexp(v.z, exponent)};
}

}  // namespace lancer::splines
