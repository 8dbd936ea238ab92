// How finely a patch must be cut.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/tessellation/patch_proximity.h"

namespace lancer::splines {

/// A uniform grid in the parameters: steps, and how each cell is halved.
struct Grid {
    int u = 1;
    int v = 1;
    std::vector<std::uint8_t> rising;  ///< u * v, row by row; 1: by the diagonal along (du, dv)
};

/// Steps that a grid will have, about: from samples of the second derivatives, without proof.
/// No count exceeds 2^20.
Grid likely_grid(const Bicubic<double>& p, double tolerance);

/// A grid of about the fewest cells whose triangles are all proved to be near the patch, with at
/// least so many steps.
Grid proved_grid(const NearPatch& patch, int least_u = 1, int least_v = 1);

}  // namespace lancer::splines
