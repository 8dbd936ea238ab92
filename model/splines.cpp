#include "model/splines.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace lancer {
namespace {

using Four = std::array<Vec2d, 4>;

/// The first three Bézier points of the segment of four B-spline points; the last one is the first
/// of the next segment.
std::array<Vec2d, 3> bspline_segment(const Four& p) {
    return {(p[0] + 4.0 * p[1] + p[2]) / 6.0, (2.0 * p[1] + p[2]) / 3.0, (p[1] + 2.0 * p[2]) / 3.0};
}

/// The same for a Catmull-Rom segment from p[1] to p[2]; its tangents are half the chords between
/// the neighbours of its ends.
std::array<Vec2d, 3> catmull_rom_segment(const Four& p) {
    return {p[1], p[1] + (p[2] - p[0]) / 6.0, p[2] - (p[3] - p[1]) / 6.0};
}

/// `at(i)` is the i-th control point; segment i uses four points from i on.
template <class At>
PlaneCurve convert_windows(Spline spline, std::size_t segments, const At& at) {
    PlaneCurve curve;
    curve.degree = 3;
    curve.points.reserve(3 * segments + 1);
    for (std::size_t i = 0; i <= segments; ++i) {
        // One more segment, of which only the first point is used: the curve's end.
        const Four window{at(i), at(i + 1), at(i + 2), at(i + 3)};
        const auto bezier =
            spline == Spline::bspline ? bspline_segment(window) : catmull_rom_segment(window);
        curve.points.insert(curve.points.end(), bezier.begin(),
                            i < segments ? bezier.end() : bezier.begin() + 1);
    }
    return curve;
}

/// A point of one segment, by de Casteljau.
Vec2d evaluate(std::span<const Vec2d> control, double s) {
    std::array<Vec2d, 4> p{};
    std::copy(control.begin(), control.end(), p.begin());
    for (std::size_t n = control.size() - 1; n > 0; --n) {
        for (std::size_t i = 0; i < n; ++i) p[i] = p[i] * (1.0 - s) + p[i + 1] * s;
    }
    return p[0];
}

}  // namespace

bool is_profile_count(Spline spline, std::size_t count) {
    switch (spline) {
        case Spline::linear:
            return count >= 2;
        case Spline::bezier:
            return count >= 4 && count % 3 == 1;
        case Spline::bspline:
        case Spline::catmull_rom:
            return count >= 4;
    }
    return false;
}

bool is_outline_count(Spline spline, std::size_t count) {
    return count >= 3 && (spline != Spline::bezier || count % 3 == 0);
}

PlaneCurve profile_curve(Spline spline, std::span<const Vec2d> points) {
    assert(is_profile_count(spline, points.size()));
    if (spline == Spline::linear || spline == Spline::bezier) {
        return {spline == Spline::linear ? 1 : 3, false, {points.begin(), points.end()}};
    }
    // The window after the last one reaches past the end; only its first three points matter.
    const auto at = [&](std::size_t i) { return points[std::min(i, points.size() - 1)]; };
    return convert_windows(spline, points.size() - 3, at);
}

PlaneCurve outline_curve(Spline spline, std::span<const Vec2d> points) {
    assert(is_outline_count(spline, points.size()));
    PlaneCurve curve;
    if (spline == Spline::linear || spline == Spline::bezier) {
        curve = {spline == Spline::linear ? 1 : 3, true, {points.begin(), points.end()}};
        curve.points.push_back(points.front());
    } else {
        // The curve starts at or near the first point, so windows start one before it.
        const std::size_t n = points.size();
        const auto at = [&](std::size_t i) { return points[(i + n - 1) % n]; };
        curve = convert_windows(spline, n, at);
        curve.closed = true;
    }
    return curve;
}

bool is_single_point(std::span<const Vec2d> points) {
    return std::ranges::all_of(points, [&](const Vec2d& p) { return p == points.front(); });
}

bool is_single_point(std::span<const Vec3d> points) {
    return std::ranges::all_of(points, [&](const Vec3d& p) { return p == points.front(); });
}

std::optional<CurvePoint> negative_radius(const PlaneCurve& profile) {
    double largest = 0.0;
    for (const Vec2d& p : profile.points) largest = std::max(largest, std::abs(p.x));
    // A change of basis has a few roundings, each within half an ulp of the largest term.
    const double rounding =
        profile.degree == 1 ? 0.0 : 8.0 * std::numeric_limits<double>::epsilon() * largest;

    CurvePoint least;
    const auto look_at = [&](std::size_t segment, double s) {
        const Vec2d p = evaluate(profile.segment(segment), s);
        if (p.x < least.point.x) least = {segment, s, p};
    };
    for (std::size_t i = 0; i < profile.segments(); ++i) {
        const auto c = profile.segment(i);
        if (std::ranges::all_of(c, [](const Vec2d& p) { return p.x >= 0.0; })) continue;
        look_at(i, 0.0);
        look_at(i, 1.0);
        if (profile.degree == 1) continue;
        // The extremes of the cubic are the roots of a(1-s)^2 + 2b s(1-s) + c s^2. The differences
        // are halved so that no intermediate overflows.
        const double a = c[1].x / 2 - c[0].x / 2;
        const double b = c[2].x / 2 - c[1].x / 2;
        const double d = c[3].x / 2 - c[2].x / 2;
        const double scale = std::max({std::abs(a), std::abs(b), std::abs(d)});
        if (scale == 0.0) continue;
        const double discriminant = (b / scale) * (b / scale) - (a / scale) * (d / scale);
        if (discriminant < 0.0) continue;
        // With x = s / (1 - s): d x^2 + 2 b x + a = 0, solved in the form without cancellation.
        const double q = -(b / scale + std::copysign(std::sqrt(discriminant), b));
        for (const auto& [num, den] : {std::pair{q, d / scale}, std::pair{a / scale, q}}) {
            const double sum = num + den;
            if (sum != 0.0 && num / sum > 0.0 && num / sum < 1.0) look_at(i, num / sum);
        }
    }
    if (least.point.x < -rounding) return least;
    return std::nullopt;
}

bool encloses_space(const PlaneCurve& profile) {
    const Vec2d& first = profile.points.front();
    const Vec2d& last = profile.points.back();
    return first == last || (first.x == 0.0 && last.x == 0.0);
}

}  // namespace lancer
