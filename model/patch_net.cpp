#include "model/patch_net.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lancer {
namespace {

/// Converts a row of n B-spline points to 3 (n - 3) + 1 Bézier points. Farin, section 8.1.
std::vector<Vec3d> row_to_bezier(const std::vector<Vec3d>& p) {
    std::vector<Vec3d> b;
    b.reserve(3 * (p.size() - 3) + 1);
    for (std::size_t i = 0; i + 3 < p.size(); ++i) {
        b.push_back((p[i] + 4.0 * p[i + 1] + p[i + 2]) / 6.0);
        b.push_back((2.0 * p[i + 1] + p[i + 2]) / 3.0);
        b.push_back((p[i + 1] + 2.0 * p[i + 2]) / 3.0);
    }
    const std::size_t n = p.size();
    b.push_back((p[n - 3] + 4.0 * p[n - 2] + p[n - 1]) / 6.0);
    return b;
}

}  // namespace

BezierPatch BezierNet::patch(std::size_t row, std::size_t column) const {
    const std::size_t width = 3 * columns + 1;
    BezierPatch p;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            p[4 * i + j] = points[(3 * row + i) * width + 3 * column + j];
        }
    }
    return p;
}

bool is_patch_size(Patch::Basis basis, std::size_t rows, std::size_t columns) {
    if (basis == Patch::Basis::bezier) return rows == 4 && columns == 4;
    return rows >= 4 && columns >= 4;
}

BezierNet bezier_net(const Patch& patch) {
    assert(is_patch_size(patch.basis, patch.rows, patch.columns));
    if (patch.basis == Patch::Basis::bezier) return {1, 1, patch.control};

    BezierNet net{patch.rows - 3, patch.columns - 3, {}};
    const std::size_t width = 3 * net.columns + 1;
    const std::size_t height = 3 * net.rows + 1;
    std::vector<std::vector<Vec3d>> rows;  // of Bezier points, one per row of the net
    for (std::size_t i = 0; i < patch.rows; ++i) {
        const auto begin = patch.control.begin() + static_cast<std::ptrdiff_t>(i * patch.columns);
        rows.push_back(row_to_bezier({begin, begin + patch.columns}));
    }
    net.points.resize(width * height);
    std::vector<Vec3d> column(patch.rows);
    for (std::size_t j = 0; j < width; ++j) {
        for (std::size_t i = 0; i < patch.rows; ++i) column[i] = rows[i][j];
        const auto bezier = row_to_bezier(column);
        for (std::size_t i = 0; i < height; ++i) net.points[i * width + j] = bezier[i];
    }
    return net;
}

double hull_diagonal(const Patch& patch) {
    Vec3d low = patch.control.front();
    Vec3d high = low;
    for (const Vec3d& p : patch.control) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    return std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
}

}  // namespace lancer
