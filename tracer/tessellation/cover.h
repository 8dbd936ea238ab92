// The triangles of one Bezier patch.
#pragma once

#include "tracer/tessellation/triangulation.h"

namespace lancer::splines {

/// Covers a patch by triangles that are proved to be near it: a uniform grid inside, and rings of
/// vertices between the grid and the border where needed. Unnecessary vertices are then removed.
///
/// \param border  number of equal parameter steps along each side, counter-clockwise from the
/// corner
///     (0, 0), see border_steps(); the patch on the other side of a border must have the same
Triangulation cover(const NearPatch& patch, const std::array<int, 4>& border);

}  // namespace lancer::splines
