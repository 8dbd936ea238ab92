// Converts a patch of the scene to bicubic Bézier patches: one patch, or a uniform B-spline net of
// any size.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "model/math.h"
#include "model/shapes.h"

namespace lancer {

/// 16 control points, row by row: u runs along a row, v from row to row.
using BezierPatch = std::array<Vec3d, 16>;

/// A grid of Bézier patches. Neighbours share the control points of their common border, bit for
/// bit.
struct BezierNet {
    std::size_t rows = 1;  ///< patches
    std::size_t columns = 1;
    std::vector<Vec3d> points;  ///< (3 rows + 1) x (3 columns + 1), row by row

    BezierPatch patch(std::size_t row, std::size_t column) const;
};

/// Whether `rows` x `columns` control points make a patch: 4 x 4, or for B-splines at least 4 each
/// way.
bool is_patch_size(Patch::Basis basis, std::size_t rows, std::size_t columns);

/// Exact up to rounding: B-splines are converted by a change of basis along the rows, then along
/// the columns.
BezierNet bezier_net(const Patch& patch);

/// Length of the diagonal of the control points' bounding box.
double hull_diagonal(const Patch& patch);

}  // namespace lancer
