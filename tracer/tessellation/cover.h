// The triangles of one Bezier patch.
#pragma once

#include "tracer/tessellation/triangulation.h"

namespace lancer::splines {

/// Covers a patch by triangles that are proved to be near it: a uniform grid inside, rings of
/// vertices between it and the border where needed, and what that has too many taken away again.
///
/// \param border  steps of equal parameter along each side, counter-clockwise from the corner
///     (0, 0), see border_steps(): what a neighbour needs as well
Triangulation cover(const NearPatch& patch, const std::array<int, 4>& border);

}  // namespace lancer::splines
