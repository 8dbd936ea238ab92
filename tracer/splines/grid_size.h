// How finely a patch must be cut.
#pragma once

#include "tracer/splines/bicubic.h"

namespace lancer::splines {

/// Steps of a uniform grid in the parameters.
struct GridSize {
    int u = 1;
    int v = 1;
};

/// The grid with about the fewest cells whose triangles all keep chord_error() <= tolerance (> 0).
/// Derivatives are bounded part by part, not over the whole patch. No step count exceeds 2^20.
GridSize grid_size(const Curvature& curvature, double tolerance);

/// Steps into which a cubic must be cut for a chord error <= tolerance. The same for the reversed
/// curve.
int curve_steps(const Vec3d& p0, const Vec3d& p1, const Vec3d& p2, const Vec3d& p3,
                double tolerance);

}  // namespace lancer::splines
