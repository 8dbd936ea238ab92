// The size of the grid into which a patch must be cut.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/tessellation/patch_proximity.h"

namespace lancer::splines {

/// A uniform grid in the parameters: numbers of steps, and how each cell is halved.
struct Grid {
    int u = 1;
    int v = 1;
    std::vector<std::uint8_t> rising;  ///< u * v, row by row; 1: by the diagonal along (du, dv)
};

/// An estimate of the grid that is needed, from samples of the second derivatives and without
/// proof. Neither number of steps exceeds 2^20.
Grid likely_grid(const Bicubic<double>& p, double tolerance);

/// A grid of about the fewest cells for which all triangles are proved to be near the patch. It has
/// at least least_u x least_v steps.
Grid proved_grid(const NearPatch& patch, int least_u = 1, int least_v = 1);

}  // namespace lancer::splines
