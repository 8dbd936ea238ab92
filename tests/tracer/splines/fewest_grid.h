// The least number of triangles of a uniform grid that keeps a tolerance at sample points.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "model/patch_net.h"
#include "tests/tracer/splines/mesh_distance.h"

namespace lancer::splines {

/// Uniform grids of m x n cells over one Bézier patch; each cell is split along the better
/// diagonal, and the distance of sample points from the patch is tested. This is no proof, and
/// borders need not match those of neighbours: so no uniform grid with a guarantee has fewer
/// triangles.
class UniformGrids {
  public:
    UniformGrids(const BezierPatch& patch, double tolerance) : p_(patch), tolerance_(tolerance) {}

    /// Triangles of the smallest grid within the tolerance; `most` if there is none below.
    std::size_t fewest(std::size_t most) {
        for (int cells = 1; cells <= all_tried; ++cells) {
            if (2 * static_cast<std::size_t>(cells) >= most) return most;
            for (int m = 1; m <= cells; ++m) {
                if (cells % m == 0 && holds(m, cells / m))
                    return 2 * static_cast<std::size_t>(cells);
            }
        }
        // For every m in steps of 1/25 the smallest n, by halving.
        int best = static_cast<int>(most / 2);
        for (int m = 1; m < best; m = std::max(m + 1, m + m / 25)) {
            int enough = (best - 1) / m;
            if (!holds(m, enough)) continue;
            for (int less = 0; enough - less > 1;) {
                const int n = (less + enough) / 2;
                (holds(m, n) ? enough : less) = n;
            }
            best = m * enough;
        }
        return 2 * static_cast<std::size_t>(best);
    }

  private:
    static constexpr int all_tried = 60;      ///< cells up to which every grid is tried
    static constexpr int cells_tried = 4000;  ///< of a grid; further ones are taken on trust
    static constexpr int samples = 4;         ///< steps along a triangle's side

    struct Corner {
        Vec2d at;
        Vec3d point;
    };

    bool holds(int m, int n) {
        // First where other grids failed.
        for (const Vec2d& at : failed_) {
            if (!cell_holds(m, n, static_cast<int>(at.x * m), static_cast<int>(at.y * n)))
                return false;
        }
        const int stride = std::max(1, m * n / cells_tried) | 1;
        for (int k = 0; k < m * n; k += stride) {
            if (cell_holds(m, n, k % m, k / m)) continue;
            if (failed_.size() == 12) failed_.pop_back();
            failed_.insert(failed_.begin(), {(k % m + 0.5) / m, (k / m + 0.5) / n});
            return false;
        }
        return true;
    }

    bool cell_holds(int m, int n, int i, int j) const {
        const auto corner = [&](int a, int b) {
            const Vec2d at(static_cast<double>(i + a) / m, static_cast<double>(j + b) / n);
            return Corner{at, sample(p_, Place<double>(at.x), Place<double>(at.y)).point};
        };
        const std::array c{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
        return (triangle_holds({c[0], c[1], c[2]}) && triangle_holds({c[0], c[2], c[3]})) ||
               (triangle_holds({c[1], c[2], c[3]}) && triangle_holds({c[1], c[3], c[0]}));
    }

    bool triangle_holds(const std::array<Corner, 3>& t) const {
        for (int i = 0; i <= samples; ++i) {
            for (int j = 0; i + j <= samples; ++j) {
                const std::array w{static_cast<double>(i) / samples,
                                   static_cast<double>(j) / samples,
                                   static_cast<double>(samples - i - j) / samples};
                Vec3d q(0);
                Vec2d at(0);
                for (std::size_t k = 0; k < 3; ++k) {
                    q += w[k] * t[k].point;
                    at += w[k] * t[k].at;
                }
                if (!(distance_near(p_, q, at, tolerance_) <= tolerance_)) return false;
            }
        }
        return true;
    }

    Bicubic<double> p_;
    double tolerance_;
    std::vector<Vec2d> failed_;
};

}  // namespace lancer::splines
