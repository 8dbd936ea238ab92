// Triangles that stand in for a patch, with a promise: none is farther from the true surface than
// the tolerance.
#pragma once

#include <cstdint>
#include <optional>

#include "model/shapes.h"
#include "tracer/tessellation/borders.h"

namespace lancer::splines {

/// More than this many triangles for one surface is a mistake in its tolerance.
inline constexpr std::uint64_t triangle_limit = 50'000'000;

/// Triangulates a patch or a net in its own space: every triangle lies within `tolerance` of the
/// true surface, which is proved, see Certificate. Without a tolerance it is 1/2000 of the diagonal
/// of the control points' box. Normals are the surface's own at the vertices; uvs run over the
/// whole net, 0..1.
///
/// Each Bezier patch gets a uniform grid inside; along its border the vertices are decided by the
/// border curve alone, its four control points and the tolerance, so that two patches with a common
/// border have the same vertices there, bit for bit, whichever way each one runs: no cracks.
/// (Without a tolerance, a border curve is measured against its own control points, whatever
/// surface it belongs to.)
///
/// \param borders  where patches of different tolerances meet: theirs; may be null
///
/// Nothing when it is not is_within_limit(). An empty mesh when all points are equal.
std::optional<Mesh> tessellate(const Patch& patch, std::optional<double> tolerance,
                               const BorderTolerances* borders = nullptr);

/// Whether tessellate() needs at most about triangle_limit triangles. Quick.
bool is_within_limit(const Patch& patch, std::optional<double> tolerance);

}  // namespace lancer::splines
