// Triangles over a patch's parameter square, and how few of them will do.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/tessellation/patch_proximity.h"

namespace lancer::splines {

using Face = std::array<std::uint32_t, 3>;

/// Fills the parameter square without overlap; faces counter-clockwise in (u, v).
struct Triangulation {
    std::vector<FootPoint> vertices;
    std::vector<Face> faces;
};

/// Triangulates a polygon of these vertices, counter-clockwise, without further ones and within the
/// promise: G. Klincsek, "Minimal triangulations of polygonal domains", Annals of Discrete
/// Mathematics 9 (1980), with "all proved" in place of "least". False, and no new faces, where
/// there is no way.
bool triangulate_polygon(const NearPatch& patch, const std::vector<FootPoint>& vertices,
                         const std::vector<std::uint32_t>& polygon, std::vector<Face>& faces);

/// Takes away vertices while the hole that one leaves can be triangulated within the promise: W.
/// Schroeder, J. Zarge, W. Lorensen, "Decimation of triangle meshes", SIGGRAPH 1992. Vertices
/// before `first` stay; those after it lie inside the square.
void remove_vertices(const NearPatch& patch, Triangulation& mesh, std::size_t first);

}  // namespace lancer::splines
