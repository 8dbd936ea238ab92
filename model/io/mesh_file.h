// Mesh files: OBJ, PLY (text and binary), STL (text and binary), all in double.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/shapes.h"

namespace lancer::io {

struct LoadedMesh {
    Mesh mesh;
    std::uint64_t degenerate = 0;  ///< triangles dropped because two corners coincide or all three are on one line
};

/// Reads a mesh by the ending of `path`. Faces of more than three corners are split (a convex one as
/// a fan from its first corner, a concave one by ears). Throws FileError whose message names the file and
/// the place in it (line or byte) when it cannot be read, is truncated, is no mesh, has a vertex that
/// is not finite or an index out of range.
LoadedMesh read_mesh(const std::string& path);

/// Adds the face with these corners (indices into `vertices`) to `faces` as triangles, each given by
/// the positions 0..n-1 of its corners in the face, so that normals and uvs can follow. Returns false
/// when the face is degenerate altogether.
bool triangulate(std::span<const Vec3d> vertices, std::span<const std::uint32_t> corners,
                 std::vector<Mesh::Corners>& triangles);

}  // namespace lancer::io
