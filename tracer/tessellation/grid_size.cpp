#include "tracer/tessellation/grid_size.h"

#include <algorithm>
#include <cmath>

#include "tracer/tessellation/certificate.h"

namespace lancer::splines {
namespace {

constexpr int most_steps = 1 << 20;
constexpr int samples = 9;      ///< in each direction, for the estimate
constexpr double finer = 1.03;  ///< factor of the search for a proved grid
constexpr double few = 100;     ///< up to this many cells, every grid is tried

int ceiled(double x) {
    if (!(x > 1)) return 1;
    return x < most_steps ? static_cast<int>(std::ceil(x)) : most_steps;
}

/// Second derivatives along the normal at some points, which cause chord errors.
struct Bends {
    struct Bend {
        double uu, uv, vv;
    };
    std::vector<Bend> at;

    /// Points without a normal are left out if there are others: near them, too, differences along
    /// the surface are no distance.
    explicit Bends(const Bicubic<double>& p) {
        const Curvature curvature(p);
        std::vector<Bend> without_normal;
        for (int i = 0; i < samples; ++i) {
            for (int j = 0; j < samples; ++j) {
                // The outermost points lie near the border, where derivatives are often largest.
                const double u = (i + 0.01) / (samples - 0.98);
                const double v = (j + 0.01) / (samples - 0.98);
                const PatchSample<double> s = sample(p, Place<double>(u), Place<double>(v));
                const Curvature here = curvature.over(u, u, v, v);
                const Vec3d& uu = here.uu.c[0][0];
                const Vec3d& uv = here.uv.c[0][0];
                const Vec3d& vv = here.vv.c[0][0];
                const Vec3d n = cross(s.du, s.dv);
                const double size = length(n);
                if (size > 1e-4 * length(s.du) * length(s.dv)) {
                    at.push_back({dot(n, uu) / size, dot(n, uv) / size, dot(n, vv) / size});
                } else {
                    without_normal.push_back({length(uu), length(uv), length(vv)});
                }
            }
        }
        if (at.empty()) at = std::move(without_normal);
    }

    /// The largest chord error of cells du x dv, each halved by the better diagonal.
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

/// The smallest number of steps in v that is enough together with steps_u, by bisection of the
/// ratio. More than most_steps if there is none.
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

/// Proves a grid, in parts that are as large as possible.
class Proof {
  public:
    /// \param failed  points where other grids failed; tested first, and extended
    Proof(const NearPatch& patch, Grid& grid, std::vector<Vec2d>& failed)
        : patch_(patch), grid_(grid), failed_(failed) {}

    bool holds() {
        grid_.rising.assign(static_cast<std::size_t>(grid_.u) * static_cast<std::size_t>(grid_.v),
                            1);
        for (std::size_t k = failed_.size(); k-- > 0;) {
            if (!cell_holds(std::min(static_cast<int>(failed_[k].x * grid_.u), grid_.u - 1),
                            std::min(static_cast<int>(failed_[k].y * grid_.v), grid_.v - 1)))
                return false;
        }
        return holds(0, grid_.u, 0, grid_.v);
    }

  private:
    bool holds(int i0, int i1, int j0, int j1) {
        const double du = 1.0 / grid_.u;
        const double dv = 1.0 / grid_.v;
        // The larger a part is, the weaker is its proof. Very large parts are not tried.
        if ((i1 - i0) * du <= 0.5 && (j1 - j0) * dv <= 0.5) {
            const Certificate part(patch_.points(), patch_.curvature(), i0 * du, i1 * du, j0 * dv,
                                   j1 * dv, du / 4, dv / 4);
            const bool rising = part.cell_distance(du, dv, true) <= patch_.tolerance();
            if (rising || part.cell_distance(du, dv, false) <= patch_.tolerance()) {
                for (int j = j0; j < j1; ++j) {
                    for (int i = i0; i < i1; ++i)
                        grid_.rising[static_cast<std::size_t>(j) *
                                         static_cast<std::size_t>(grid_.u) +
                                     static_cast<std::size_t>(i)] = rising;
                }
                return true;
            }
        }
        if (i1 - i0 == 1 && j1 - j0 == 1) {
            if (cell_holds(i0, j0)) return true;
            if (failed_.size() == 8) failed_.erase(failed_.begin());
            failed_.emplace_back((i0 + 0.5) / grid_.u, (j0 + 0.5) / grid_.v);
            return false;
        }
        if (i1 - i0 >= j1 - j0) {
            const int middle = (i0 + i1) / 2;
            return holds(i0, middle, j0, j1) && holds(middle, i1, j0, j1);
        }
        const int middle = (j0 + j1) / 2;
        return holds(i0, i1, j0, middle) && holds(i0, i1, middle, j1);
    }

    bool cell_holds(int i, int j) {
        const auto at = [&](int a, int b) {
            return FootPoint::on(patch_.points(), {static_cast<double>(i + a) / grid_.u,
                                                   static_cast<double>(j + b) / grid_.v});
        };
        const std::array corner{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
        const auto halves_hold = [&](std::size_t from) {
            const FootPoint& a = corner[from];
            const FootPoint& c = corner[from + 2];
            return patch_.holds({a, corner[from + 1], c}) &&
                   patch_.holds({a, c, corner[(from + 3) % 4]});
        };
        std::uint8_t& rising =
            grid_.rising[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid_.u) +
                         static_cast<std::size_t>(i)];
        rising = halves_hold(0);
        return rising || halves_hold(1);
    }

    const NearPatch& patch_;
    Grid& grid_;
    std::vector<Vec2d>& failed_;
};

}  // namespace

Grid likely_grid(const Bicubic<double>& p, double tolerance) {
    const Bends bends(p);
    // Steps in u grow by a ratio. The product is flat near its minimum, so this is precise enough.
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

Grid proved_grid(const NearPatch& patch, int least_u, int least_v) {
    const Grid likely = likely_grid(patch.points(), patch.tolerance());
    std::vector<Vec2d> failed;
    Grid grid;
    const auto try_grid = [&](int u, int v) {
        Grid next{u, v, {}};
        if (u < least_u || v < least_v || !Proof(patch, next, failed).holds()) return false;
        grid = std::move(next);
        return true;
    };
    const double cells = static_cast<double>(likely.u) * likely.v;
    if (cells <= few) {
        for (int count = std::max(1, static_cast<int>(cells / 3)); count < 3 * cells; ++count) {
            for (int u = 1; u <= count; ++u) {
                if (count % u == 0 && try_grid(u, count / u)) return grid;
            }
        }
    }
    double more = 0.9;
    while (!try_grid(std::max(least_u, ceiled(more * likely.u)),
                     std::max(least_v, ceiled(more * likely.v))))
        more *= finer;
    while (try_grid(static_cast<int>(grid.u / finer), grid.v) ||
           try_grid(grid.u, static_cast<int>(grid.v / finer))) {
    }
    return grid;
}

}  // namespace lancer::splines
