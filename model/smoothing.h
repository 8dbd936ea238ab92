// Normals for meshes that have none: smooth where faces meet at a small angle, sharp elsewhere.
#pragma once

#include <cstddef>

#include "model/shapes.h"

namespace lancer {

/// A copy of the mesh with a normal for each corner: the mean, weighted by area, of the faces round
/// its vertex that are reached from its face across edges of at most `degrees` between the faces'
/// normals. An edge that does not belong to exactly two faces is sharp. Vertices are told by index,
/// so corners that do not share one are not smoothed together. About n log n in the faces round one
/// vertex, linear in the mesh.
Mesh with_sharp_edges(const Mesh& mesh, double degrees);

/// How many edges of exactly two faces have more than `degrees` between the faces' normals.
std::size_t count_sharp_edges(const Mesh& mesh, double degrees);

}  // namespace lancer
