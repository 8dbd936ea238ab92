#include "tracer/splines/grid_size.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace lancer::splines {
namespace {

constexpr int most_steps = 1 << 20;
constexpr int parts = 4;  ///< each way, in which derivatives are bounded apart

int ceiled(double x) {
    if (!(x > 1)) return 1;
    return x < most_steps ? static_cast<int>(std::ceil(x)) : most_steps;
}

/// Bounds over parts x parts rectangles that overlap so far that any cell of an eighth of the patch
/// lies within one of them; and, for wider cells, over whole rows and columns.
struct BoundTable {
    /// [a][b]: a = parts for "all of u", b alike for v.
    std::array<std::array<SecondDerivatives, parts + 1>, parts + 1> at;

    explicit BoundTable(const Curvature& curvature) {
        const auto range = [](std::size_t k) {
            if (k == parts) return std::array{0.0, 1.0};
            const double low = static_cast<double>(k) / parts - 0.0625;
            return std::array{std::max(0.0, low), std::min(1.0, low + 1.0 / parts + 0.125)};
        };
        for (std::size_t a = 0; a <= parts; ++a) {
            for (std::size_t b = 0; b <= parts; ++b) {
                at[a][b] = curvature.over(range(a)[0], range(a)[1], range(b)[0], range(b)[1]);
            }
        }
    }
};

/// The widest dv that goes with du; 0 if none does.
double widest_step(const SecondDerivatives& d, double du, double tolerance) {
    const double left = 8 * tolerance - du * du * d.uu;
    if (left <= 0) return 0;
    // vv dv^2 + 2 (du uv) dv - left = 0, without cancellation.
    const double half = du * d.uv;
    const double root = half + std::sqrt(half * half + d.vv * left);
    return root > 0 ? left / root : 1;
}

/// The fewest steps in v that go with `steps_u`, more than most_steps when none does.
double steps_v(const BoundTable& table, int steps_u, double tolerance) {
    const double du = 1.0 / steps_u;
    const bool narrow_u = steps_u >= 8;
    const auto fewest = [&](bool narrow_v) {
        double widest = 1;
        for (std::size_t a = narrow_u ? 0 : parts; a <= (narrow_u ? parts - 1 : parts); ++a) {
            for (std::size_t b = narrow_v ? 0 : parts; b <= (narrow_v ? parts - 1 : parts); ++b) {
                widest = std::min(widest, widest_step(table.at[a][b], du, tolerance));
            }
        }
        return widest > 0 ? std::max(1.0, std::ceil(1 / widest)) : 2.0 * most_steps;
    };
    return std::min(fewest(false), std::max(8.0, fewest(true)));
}

/// Whether every cell of the grid keeps its promise, each with the bounds of its own place.
bool holds(const Curvature& curvature, int nu, int nv, double tolerance) {
    for (int i = 0; i < nu; ++i) {
        for (int j = 0; j < nv; ++j) {
            const auto d =
                curvature.over(static_cast<double>(i) / nu, static_cast<double>(i + 1) / nu,
                               static_cast<double>(j) / nv, static_cast<double>(j + 1) / nv);
            if (!(chord_error(d, 1.0 / nu, 1.0 / nv) <= tolerance)) return false;
        }
    }
    return true;
}

}  // namespace

GridSize grid_size(const Curvature& curvature, double tolerance) {
    const BoundTable table(curvature);
    // Steps in u in ratios of about 1.1; the product is flat near its least, so this is near
    // enough.
    double best = 0;
    GridSize size{most_steps, most_steps};
    for (int u = 1; u < most_steps; u += std::max(1, u / 10)) {
        const double v = steps_v(table, u, tolerance);
        if (v <= most_steps && (best == 0 || u * v < best)) {
            best = u * v;
            size = {u, static_cast<int>(v)};
        }
        if (v == 1) break;
    }
    // A coarse grid is looked at cell by cell: whole cells are saved.
    for (bool smaller = true; smaller && static_cast<std::int64_t>(size.u) * size.v <= 64;) {
        smaller = false;
        if (size.u > 1 && holds(curvature, size.u - 1, size.v, tolerance)) {
            --size.u;
            smaller = true;
        } else if (size.v > 1 && holds(curvature, size.u, size.v - 1, tolerance)) {
            --size.v;
            smaller = true;
        }
    }
    return size;
}

int curve_steps(const Vec3d& p0, const Vec3d& p1, const Vec3d& p2, const Vec3d& p3,
                double tolerance) {
    const double a = length((p0 + p2) - 2.0 * p1);
    const double b = length((p1 + p3) - 2.0 * p2);
    // |S''| <= 6 max, and a chord over a step h errs by at most h^2 / 8 of it.
    return ceiled(std::sqrt(6 * std::max(a, b) / (8 * tolerance)));
}

}  // namespace lancer::splines
