#include "tracer/splines/grid_size.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tracer/splines/certificate.h"

namespace lancer::splines {
namespace {

constexpr int most_steps = 1 << 20;
constexpr int samples = 9;      ///< each way, for the guess
constexpr double finer = 1.06;  ///< steps of the search for a grid with a proof

int ceiled(double x) {
    if (!(x > 1)) return 1;
    return x < most_steps ? static_cast<int>(std::ceil(x)) : most_steps;
}

/// Second derivatives along the normal at some places: what a chord error comes from.
struct Bends {
    struct Bend {
        double uu, uv, vv;
    };
    std::vector<Bend> at;

    Bends(const Bicubic<double>& p, const Curvature& curvature) {
        for (int i = 0; i < samples; ++i) {
            for (int j = 0; j < samples; ++j) {
                // Near the border: there the derivatives are often largest.
                const double u = (i + 0.01) / (samples - 0.98);
                const double v = (j + 0.01) / (samples - 0.98);
                const PatchSample<double> s = sample(p, Place<double>(u), Place<double>(v));
                const Curvature here = curvature.over(u, u, v, v);
                const Vec3d n = cross(s.du, s.dv);
                const double size = length(n);
                if (!(size > 1e-4 * length(s.du) * length(s.dv))) {
                    // Without a normal no proof tells slides from distance.
                    at.push_back({length(here.uu.c[0][0]), length(here.uv.c[0][0]),
                                  length(here.vv.c[0][0])});
                    continue;
                }
                at.push_back({dot(n, here.uu.c[0][0]) / size, dot(n, here.uv.c[0][0]) / size,
                              dot(n, here.vv.c[0][0]) / size});
            }
        }
    }

    /// The largest chord error of cells du x dv, each halved the better way.
    double error(double du, double dv) const {
        double most = 0;
        for (const Bend& b : at) {
            const double straight = std::max(std::abs(du * du * b.uu), std::abs(dv * dv * b.vv));
            const double sum = du * du * b.uu + dv * dv * b.vv;
            const double diagonal = std::abs(std::abs(sum) - 2 * std::abs(du * dv * b.uv));
            most = std::max(most, std::max(straight, diagonal) / 8);
        }
        return most;
    }
};

/// The smallest dv^-1 that goes with du, by halving the ratio; more than most_steps: none.
double steps_v(const Bends& bends, double steps_u, double tolerance) {
    const auto fits = [&](double v) { return bends.error(1 / steps_u, 1 / v) <= tolerance; };
    double high = 1;
    while (!fits(high)) {
        high *= 2;
        if (high > most_steps) return high;
    }
    for (double low = high / 2; high > 1 && high > 1.01 * low;) {
        const double middle = std::sqrt(low * high);
        (fits(middle) ? high : low) = middle;
    }
    return high;
}

/// Proves a grid, in as large parts as will do.
class Proof {
  public:
    Proof(const Bicubic<double>& p, const Curvature& curvature, double tolerance, Grid& grid)
        : p_(p), curvature_(curvature), tolerance_(tolerance), grid_(grid) {}

    bool holds() {
        grid_.rising.assign(static_cast<std::size_t>(grid_.u) * static_cast<std::size_t>(grid_.v),
                            1);
        return holds(0, grid_.u, 0, grid_.v);
    }

  private:
    bool holds(int i0, int i1, int j0, int j1) {
        const double du = 1.0 / grid_.u;
        const double dv = 1.0 / grid_.v;
        // The proof for a part worsens with its size; of a large one nothing is expected.
        if ((i1 - i0) * du <= 0.5 && (j1 - j0) * dv <= 0.5) {
            const Certificate part(p_, curvature_, i0 * du, i1 * du, j0 * dv, j1 * dv, du / 4,
                                   dv / 4);
            const bool rising = part.cell_distance(du, dv, true) <= tolerance_;
            if (rising || part.cell_distance(du, dv, false) <= tolerance_) {
                for (int j = j0; j < j1; ++j) {
                    for (int i = i0; i < i1; ++i)
                        grid_.rising[static_cast<std::size_t>(j) *
                                         static_cast<std::size_t>(grid_.u) +
                                     static_cast<std::size_t>(i)] = rising;
                }
                return true;
            }
        }
        if (i1 - i0 == 1 && j1 - j0 == 1) return cell_holds(i0, j0);
        if (i1 - i0 >= j1 - j0) {
            const int middle = (i0 + i1) / 2;
            return holds(i0, middle, j0, j1) && holds(middle, i1, j0, j1);
        }
        const int middle = (j0 + j1) / 2;
        return holds(i0, i1, j0, middle) && holds(i0, i1, middle, j1);
    }

    /// A cell for itself, looked at closely where there are few.
    bool cell_holds(int i, int j) {
        const int cells = grid_.u * grid_.v;
        const int halvings = cells <= 400 ? 3 : cells <= 4000 ? 2 : 0;
        const auto at = [&](int a, int b) {
            return Vec2d(static_cast<double>(i + a) / grid_.u,
                         static_cast<double>(j + b) / grid_.v);
        };
        const auto near = [&](const Vec2d& a, const Vec2d& b, const Vec2d& c) {
            return is_near(p_, curvature_, chord_triangle(p_, {a, b, c}), tolerance_, halvings);
        };
        std::uint8_t& rising =
            grid_.rising[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid_.u) +
                         static_cast<std::size_t>(i)];
        rising = near(at(0, 0), at(1, 0), at(1, 1)) && near(at(0, 0), at(1, 1), at(0, 1));
        return rising || (near(at(0, 0), at(1, 0), at(0, 1)) && near(at(1, 0), at(1, 1), at(0, 1)));
    }

    const Bicubic<double>& p_;
    const Curvature& curvature_;
    double tolerance_;
    Grid& grid_;
};

}  // namespace

Grid likely_grid(const Bicubic<double>& p, double tolerance) {
    const Bends bends(p, Curvature(p));
    // Steps in u in ratios; the product is flat near its least, so this is near enough.
    double best = 0;
    Grid grid{most_steps, most_steps, {}};
    for (double u = 1; u <= most_steps; u = std::max(u + 1, u * 1.15)) {
        const double v = steps_v(bends, u, tolerance);
        if (v <= most_steps && (best == 0 || u * v < best)) {
            best = u * v;
            grid = {ceiled(u), ceiled(v), {}};
        }
        if (v == 1 || (best > 0 && u > best)) break;
    }
    return grid;
}

namespace {

/// With these steps at least, and a proof.
Grid grid_from(const Bicubic<double>& p, const Curvature& curvature, double tolerance, double u,
               double v) {
    for (;; u = std::max(u * finer, u + 0.5), v = std::max(v * finer, v + 0.5)) {
        Grid grid{std::max(2, ceiled(u)), std::max(2, ceiled(v)), {}};
        if (Proof(p, curvature, tolerance, grid).holds()) return grid;
    }
}

}  // namespace

Grid finer_grid(const Bicubic<double>& p, const Curvature& curvature, double tolerance,
                const Grid& grid) {
    return grid_from(p, curvature, tolerance, grid.u * 1.25, grid.v * 1.25);
}

Grid proved_grid(const Bicubic<double>& p, const Curvature& curvature, double tolerance) {
    const Grid likely = likely_grid(p, tolerance);
    Grid grid = grid_from(p, curvature, tolerance, likely.u, likely.v);
    // A coarse grid may do with less than its samples said.
    const auto try_less = [&](int u, int v) {
        Grid less{u, v, {}};
        if (u < 2 || v < 2 || !Proof(p, curvature, tolerance, less).holds()) return false;
        grid = std::move(less);
        return true;
    };
    while (static_cast<std::int64_t>(grid.u) * grid.v <= 1000 &&
           (try_less(grid.u - 1, grid.v) || try_less(grid.u, grid.v - 1))) {
    }
    return grid;
}

namespace {

/// Whether every one of `steps` chords is within the tolerance of its piece of the cubic: at most
/// 3/4 of the inner control points' distance from the chord's line, as the weights 3 s (1 - s)^2
/// and 3 s^2 (1 - s) show. Over every point of the chord there is a point of the curve.
bool chords_hold(const std::array<Vec3d, 4>& curve, int steps, double tolerance) {
    for (int i = 0; i < steps; ++i) {
        std::array<Vec3d, 4> piece = curve;
        restrict_to(piece, static_cast<double>(i) / steps, static_cast<double>(i + 1) / steps);
        const Vec3d chord = piece[3] - piece[0];
        const double size = length(chord);
        for (const std::size_t k : {1u, 2u}) {
            const Vec3d d = piece[k] - piece[0];
            const double away = size > 0 ? length(cross(d, chord)) / size : length(d);
            if (!(0.75 * away <= tolerance)) return false;
        }
    }
    return true;
}

}  // namespace

int likely_curve_steps(const Vec3d& p0, const Vec3d& p1, const Vec3d& p2, const Vec3d& p3,
                       double tolerance) {
    const double a = length((p0 + p2) - 2.0 * p1);
    const double b = length((p1 + p3) - 2.0 * p2);
    // |S''| <= 6 max, and a chord over a step h errs by at most h^2 / 8 of it.
    return ceiled(std::sqrt(6 * std::max(a, b) / (8 * tolerance)));
}

int curve_steps(const Vec3d& p0, const Vec3d& p1, const Vec3d& p2, const Vec3d& p3,
                double tolerance) {
    const int enough = likely_curve_steps(p0, p1, p2, p3, tolerance);
    if (enough > 1000) return enough;
    std::array<Vec3d, 4> curve{p0, p1, p2, p3};
    // The same bits whichever way the curve runs.
    const auto key = [](const Vec3d& p, const Vec3d& q) {
        return std::array{p.x, p.y, p.z, q.x, q.y, q.z};
    };
    if (key(p3, p2) < key(p0, p1)) std::ranges::reverse(curve);
    // Points of a chord may be far from the curve's at equal parameters, along it. But not too far:
    // the triangles beside it would be hard to fit.
    int steps = likely_curve_steps(p0, p1, p2, p3, tolerance * 4 / 3);
    for (; steps < enough; steps += 1 + steps / 16) {
        if (chords_hold(curve, steps, tolerance)) return steps;
    }
    return enough;
}

}  // namespace lancer::splines
