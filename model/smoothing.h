// Computes normals for meshes that have none: smooth where faces meet at a small angle, sharp
// elsewhere.
#pragma once

#include <cstddef>

#include "model/shapes.h"

namespace lancer {

/// A copy of the mesh with a normal for each corner: the mean normal, weighted by area, of faces
/// around its vertex. It includes the faces that can be reached from the corner's face across edges
/// with at most `degrees` between the normals of their faces. An edge that does not belong to
/// exactly two faces is sharp. Vertices are identified by index, so corners that do not share one
/// are not smoothed together. Takes about n log n time in the faces around one vertex, linear time
/// in the mesh.
Mesh with_sharp_edges(const Mesh& mesh, double degrees);

/// The number of edges of exactly two faces with more than `degrees` between the normals of these
/// faces.
std::size_t count_sharp_edges(const Mesh& mesh, double degrees);

}  // namespace lancer
