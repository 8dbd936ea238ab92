// Mesh files: OBJ, PLY (text and binary), STL (text and binary), all in double.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/shapes.h"

namespace lancer::io {

/// A statement that names files of materials (`mtllib`), and where it stands.
struct LibraryStatement {
    std::string names;  ///< all that stands behind the word
    std::uint32_t line = 0;
};

struct LoadedMesh {
    Mesh mesh;
    /// For each face of `mesh` its material, an index into `materials`; empty where all have the
    /// same one, or none.
    std::vector<std::uint32_t> face_materials;
    /// Names of the materials that faces have, "" for faces that name none; empty where none does.
    std::vector<std::string> materials;
    std::vector<LibraryStatement> libraries;
    /// Faces dropped because corners coincide or all are on one line, so that no triangle is left.
    std::uint64_t degenerate = 0;
    /// What was left out or put right, one sentence each, with the file and the place in it.
    std::vector<std::string> warnings;
};

/// Reads a mesh by the ending of `path`. Faces of more than three corners are split (a convex one
/// as a fan from its first corner, a concave one by ears). Throws FileError whose message names the
/// file and the place in it (line, byte or face) when it cannot be read, is truncated, is no mesh,
/// has a vertex that is not finite or an index out of range.
LoadedMesh read_mesh(const std::string& path);

/// The same for the bytes of a file that would be called `name`.
LoadedMesh read_mesh(std::string_view bytes, const std::string& name);

/// Adds the face with these corners (indices into `vertices`) to `triangles`, each given by the
/// positions 0..n-1 of its corners in the face, so that normals and uvs can follow. Triangles
/// without area are left out; returns false when there is no other. A face need not be planar.
/// Throws FileError for a concave one of more than 10000 corners.
bool triangulate(std::span<const Vec3d> vertices, std::span<const std::uint32_t> corners,
                 std::vector<Mesh::Corners>& triangles);

}  // namespace lancer::io
