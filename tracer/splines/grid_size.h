// How finely a patch must be cut.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/splines/bicubic.h"

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

/// A grid of about the fewest cells whose triangles are all proved to be within the tolerance (> 0)
/// of the surface, see Certificate. At least 2 x 2. Triangles at the patch's border are left to the
/// caller.
Grid proved_grid(const Bicubic<double>& p, const Curvature& curvature, double tolerance);

/// One with a quarter more steps each way, at least.
Grid finer_grid(const Bicubic<double>& p, const Curvature& curvature, double tolerance,
                const Grid& grid);

/// Steps into which a cubic must be cut for its chords to be within the tolerance of it. The same
/// for the reversed curve.
int curve_steps(const Vec3d& p0, const Vec3d& p1, const Vec3d& p2, const Vec3d& p3,
                double tolerance);

/// At least as many, quickly.
int likely_curve_steps(const Vec3d& p0, const Vec3d& p1, const Vec3d& p2, const Vec3d& p3,
                       double tolerance);

}  // namespace lancer::splines
