// The plane curves of lathe and prism in one form: linear or cubic Bézier segments with shared
// joints. Also checks whether a curve can be drawn.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "model/math.h"
#include "model/shapes.h"

namespace lancer {

/// A chain of Bézier segments. A joint is stored once, so that both neighbours have the same bits.
struct PlaneCurve {
    int degree = 1;             ///< of every segment: 1 or 3
    bool closed = false;        ///< an outline: the last point equals the first, bit for bit
    std::vector<Vec2d> points;  ///< degree * segments + 1 control points

    std::size_t segments() const {
        return points.empty() ? 0 : (points.size() - 1) / static_cast<std::size_t>(degree);
    }
    /// The degree + 1 control points of a segment.
    std::span<const Vec2d> segment(std::size_t index) const {
        const auto step = static_cast<std::size_t>(degree);
        return std::span(points).subspan(index * step, step + 1);
    }
};

/// Whether `count` points make a profile: linear 2 or more, bezier 3n + 1, bspline and catmull_rom
/// 4 or more (their first and last points only guide the curve).
bool is_profile_count(Spline spline, std::size_t count);

/// Whether `count` points, without a repetition of the first, make an outline: bezier 3n, others 3
/// or more.
bool is_outline_count(Spline spline, std::size_t count);

/// The curve of an open profile. is_profile_count() must accept the number of `points`. Uniform
/// B-spline and Catmull-Rom segments become Bézier segments by a change of basis (Farin, Curves and
/// Surfaces for CAGD, 5th ed., sections 8.1 and 8.5), exact up to rounding.
PlaneCurve profile_curve(Spline spline, std::span<const Vec2d> points);

/// The closed curve of a periodic outline. See is_outline_count().
PlaneCurve outline_curve(Spline spline, std::span<const Vec2d> points);

/// Whether all points are equal: then there is nothing to draw.
bool is_single_point(std::span<const Vec2d> points);
bool is_single_point(std::span<const Vec3d> points);

/// A point on a curve.
struct CurvePoint {
    std::size_t segment = 0;
    double parameter = 0;  ///< 0..1 within the segment
    Vec2d point{0, 0};
};

/// The point with the least x (radius) if that is negative by more than the rounding of the
/// conversion.
std::optional<CurvePoint> negative_radius(const PlaneCurve& profile);

/// Whether a lathe with this profile is a body: the curve's two ends coincide, or both lie on the
/// axis.
bool encloses_space(const PlaneCurve& profile);

/// A point where two parts of the curve cross, if there is one. Curves that only touch, or that run
/// along each other, do not cross.
std::optional<Vec2d> self_crossing(const PlaneCurve& outline);

}  // namespace lancer
