// Meshes in pieces, where POV-Ray computes badly with the whole.
#pragma once

#include <vector>

#include "model/affine.h"
#include "model/shapes.h"

namespace lancer::reference::pov {

/// Some faces of a mesh, perhaps turned.
struct MeshPiece {
    Mesh mesh;
    Affine<double> back{};  ///< turns it back to its place; exact
};

/// A normal whose length is twice the area of the face.
Vec3d face_normal(const Mesh& mesh, const Mesh::Corners& face);

/// For a mesh without normals: the mean normal of the faces around each vertex, weighted by area,
/// not unit.
std::vector<Vec3d> vertex_normals(const Mesh& mesh);

/// Sorts the faces into cubes whose size is a few edges.
std::vector<MeshPiece> pieces_by_place(const Mesh& mesh);

/// Whether the z axis lies nearly in the plane of some face that leans. POV-Ray mixes the colours
/// of such a face wrongly: it computes the shares from x and y alone, unless a determinant is below
/// an absolute constant, and there that determinant is rounding errors of single precision.
bool has_upright_face(const Mesh& mesh);

/// Sorts the faces by the axis nearest to their normal, and turns each piece so that this is z.
std::vector<MeshPiece> pieces_by_axis(const Mesh& mesh);

}  // namespace lancer::reference::pov
