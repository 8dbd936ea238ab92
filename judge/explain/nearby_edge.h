// Can an edge through a pixel's centre explain the pixel's difference?
#pragma once

#include <optional>

#include "judge/explain/probe_function.h"

namespace lancer::judge {

/// What changes at an edge, judged by samples very close to it on both sides.
enum class EdgeKind {
    silhouette,  ///< another object, a jump in depth or a crease
    shadow,      ///< the same surface with other lights
    texture,     ///< the same surface and lights: the surface's own colour
    secondary,   ///< one of these, seen in a mirror or through glass
};

/// An edge of our own picture beside a pixel's centre, with the other picture's value behind it.
struct NearbyEdge {
    EdgeKind kind = EdgeKind::silhouette;
    double dx = 0;  ///< from the centre to the edge, pixels, y down
    double dy = 0;
    double jump = 0;  ///< height of the step: largest component
};

/// Looks within `radius` pixels of (x, y) for a discontinuity of our picture behind which it takes
/// the value `theirs`, to within `tolerance`. A value that is reached by a smooth change, however
/// steep, does not count: the step must remain when looked at from 10^-12 pixel. Of several the
/// nearest is returned.
std::optional<NearbyEdge> find_nearby_edge(const ProbeFunction& probe, double x, double y,
                                           const Color& theirs, double radius, double tolerance);

/// The distance from (x, y), in pixels, at which our picture takes the value `theirs` to within
/// `tolerance`, by any kind of change; nothing when it does not within `radius`.
std::optional<double> reached_at(const ProbeFunction& probe, double x, double y,
                                 const Color& theirs, double radius, double tolerance);

}  // namespace lancer::judge
