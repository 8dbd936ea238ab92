// Triangulations of a patch's parameter square, and the removal of unnecessary vertices.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/tessellation/patch_proximity.h"

namespace lancer::splines {

using Face = std::array<std::uint32_t, 3>;

/// A triangulation of the parameter square, without overlap. Faces are counter-clockwise in (u, v).
struct Triangulation {
    std::vector<FootPoint> vertices;
    std::vector<Face> faces;
};

/// Triangulates a counter-clockwise polygon of these vertices, without additional vertices, so that
/// all triangles are proved to be near the patch: G. Klincsek, "Minimal triangulations of polygonal
/// domains", Annals of Discrete Mathematics 9 (1980), with "all proved" in place of "minimal".
/// Returns false, and adds no faces, if there is no such triangulation.
bool triangulate_polygon(const NearPatch& patch, const std::vector<FootPoint>& vertices,
                         const std::vector<std::uint32_t>& polygon, std::vector<Face>& faces);

/// Removes vertices as long as the hole that one leaves can be triangulated by triangles proved to
/// be near the patch: W. Schroeder, J. Zarge, W. Lorensen, "Decimation of triangle meshes",
/// SIGGRAPH 1992. Vertices before `first` are kept; all others lie inside the square.
void remove_vertices(const NearPatch& patch, Triangulation& mesh, std::size_t first);

}  // namespace lancer::splines
