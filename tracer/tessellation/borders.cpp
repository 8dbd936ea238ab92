#include "tracer/tessellation/borders.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/tessellation/patch_proximity.h"

namespace lancer::splines {
namespace {

/// A key for the curve, the same for both directions.
std::array<double, 12> border_key(const BorderCurve& curve) {
    std::array<double, 12> forwards{};
    std::array<double, 12> backwards{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int axis = static_cast<int>(k);
            forwards[3 * i + k] = curve[i][axis];
            backwards[3 * i + k] = curve[3 - i][axis];
        }
    }
    return std::min(forwards, backwards);
}

double distance_squared(const Vec3d& q, const Vec3d& from, const Vec3d& to) {
    const Vec3d chord = to - from;
    const double squared = length_squared(chord);
    const double s = squared > 0 ? std::clamp(dot(q - from, chord) / squared, 0.0, 1.0) : 0.0;
    return length_squared(q - from - chord * s);
}

/// Whether a part of the curve is within the tolerance of its chord. The distance from a chord is a
/// convex function, so the control points of small parts bound it.
bool curve_holds(const BorderCurve& curve, double low, double high, double tolerance) {
    constexpr int parts = 8;
    BorderCurve whole = curve;
    restrict_to(whole, low, high);
    for (int i = 0; i < parts; ++i) {
        BorderCurve part = whole;
        restrict_to(part, static_cast<double>(i) / parts, static_cast<double>(i + 1) / parts);
        for (const Vec3d& q : part) {
            if (!(distance_squared(q, whole[0], whole[3]) <= tolerance * tolerance)) return false;
        }
    }
    return true;
}

/// Whether curve and chords are proved to be within the tolerance of each other. For the chords,
/// the proof is that of degenerate triangles near a patch without width, the same proof as for the
/// triangles beside them.
bool chords_hold(const BorderCurve& curve, const NearPatch& narrow, int steps) {
    const auto end = [&](int i) {
        return FootPoint::on(narrow.points(), {static_cast<double>(i) / steps, 0});
    };
    for (int i = 0; i < steps; ++i) {
        const FootPoint to = end(i + 1);
        if (!curve_holds(curve, static_cast<double>(i) / steps, static_cast<double>(i + 1) / steps,
                         narrow.tolerance()) ||
            !narrow.holds({end(i), to, to}))
            return false;
    }
    return true;
}

/// The tolerance of the chords, at least the rounding errors of the curve's own points.
double chord_tolerance(const BorderCurve& curve, double tolerance) {
    double farthest = 0;
    for (const Vec3d& q : curve) farthest = std::max(farthest, length(q));
    return std::max(border_share * tolerance,
                    16 * std::numeric_limits<double>::epsilon() * farthest);
}

}  // namespace

std::array<BorderCurve, 4> border_curves(const BezierPatch& p) {
    return {BorderCurve{p[0], p[1], p[2], p[3]}, BorderCurve{p[3], p[7], p[11], p[15]},
            BorderCurve{p[15], p[14], p[13], p[12]}, BorderCurve{p[12], p[8], p[4], p[0]}};
}

double border_tolerance(const BorderCurve& c, std::optional<double> tolerance) {
    return tolerance.value_or(
        hull_diagonal({Patch::Basis::bezier, 1, 4, {c.begin(), c.end()}, {}}) / 2000);
}

int likely_border_steps(const BorderCurve& c, double tolerance) {
    constexpr double most = 1 << 20;
    const double bend =
        std::max(length((c[0] + c[2]) - 2.0 * c[1]), length((c[1] + c[3]) - 2.0 * c[2]));
    // |S''| <= 6 bend, and the error of a chord over a step h is at most h^2 / 8 times |S''|.
    const double steps = std::sqrt(6 * bend / (8 * chord_tolerance(c, tolerance)));
    return steps < most ? std::max(1, static_cast<int>(std::ceil(steps))) : static_cast<int>(most);
}

int border_steps(const BorderCurve& curve, double tolerance) {
    const int enough = likely_border_steps(curve, tolerance);
    if (enough > 1000) return enough;
    // The result has the same bits for both directions of the curve.
    BorderCurve one_way = curve;
    const auto key = [](const Vec3d& p, const Vec3d& q) {
        return std::array{p.x, p.y, p.z, q.x, q.y, q.z};
    };
    if (key(curve[3], curve[2]) < key(curve[0], curve[1])) std::ranges::reverse(one_way);
    Bicubic<double> rows;
    for (std::size_t i = 0; i < 16; ++i) rows[i] = one_way[i % 4];
    const NearPatch narrow(rows, chord_tolerance(curve, tolerance));
    // At a fold of the curve, a chord may be near the curve but far from it at equal parameters. So
    // fewer steps are tried, but not too few: the triangles beside would be hard to prove.
    for (int steps = likely_border_steps(curve, 8 * tolerance); steps < enough;
         steps += 1 + steps / 16) {
        if (chords_hold(one_way, narrow, steps)) return steps;
    }
    return enough;
}

void BorderTolerances::add(const Patch& patch, std::optional<double> tolerance) {
    const BezierNet net = bezier_net(patch);
    for (std::size_t i = 0; i < net.rows; ++i) {
        for (std::size_t j = 0; j < net.columns; ++j) {
            for (const BorderCurve& curve : border_curves(net.patch(i, j))) {
                const double own = border_tolerance(curve, tolerance);
                const auto [at, is_new] = smallest_.emplace(border_key(curve), own);
                if (!is_new) at->second = std::min(at->second, own);
            }
        }
    }
}

std::optional<double> BorderTolerances::at(const BorderCurve& curve) const {
    const auto found = smallest_.find(border_key(curve));
    return found == smallest_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace lancer::splines
