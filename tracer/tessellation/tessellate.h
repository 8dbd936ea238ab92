// Triangles that replace a patch. None is farther from the true surface than the tolerance.
#pragma once

#include <cstdint>
#include <optional>

#include "model/shapes.h"
#include "tracer/tessellation/borders.h"

namespace lancer::splines {

/// The largest number of triangles for one surface; more are a mistake in its tolerance.
inline constexpr std::uint64_t triangle_limit = 50'000'000;

/// Triangulates a patch or a net in its own space. Every triangle is proved to lie within
/// `tolerance` of the true surface, see Certificate. The default tolerance is 1/2000 of the
/// diagonal of the control points' box. Normals are those of the surface at the vertices; uvs range
/// over [0, 1] in the whole net.
///
/// Each Bezier patch gets a uniform grid inside. The vertices along a border depend only on the
/// border curve's four control points and on the tolerance. So two patches with a common border
/// have the same vertices there, bit for bit, whichever way the curve runs in each, and there are
/// no cracks. (Without a tolerance, that of a border curve follows from its own control points,
/// whatever surface it belongs to.)
///
/// \param borders  the tolerances of borders where patches of different tolerances meet; may be
/// null
///
/// Returns nothing if !is_within_limit(), and an empty mesh if all points are equal.
std::optional<Mesh> tessellate(const Patch& patch, std::optional<double> tolerance,
                               const BorderTolerances* borders = nullptr);

/// Whether tessellate() needs at most about triangle_limit triangles. A fast estimate.
bool is_within_limit(const Patch& patch, std::optional<double> tolerance);

}  // namespace lancer::splines
