// Mesh files: OBJ, PLY (text and binary), STL (text and binary), all in double.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/shapes.h"

namespace lancer::io {

/// A statement that names material files (`mtllib`), and its place.
struct LibraryStatement {
    std::string names;  ///< all that follows the word
    std::uint32_t line = 0;
};

struct LoadedMesh {
    Mesh mesh;
    /// For each face of `mesh` its material, an index into `materials`; empty when all faces have
    /// the same one, or none.
    std::vector<std::uint32_t> face_materials;
    /// Names of the materials of faces, "" for faces without one; empty when no face has one.
    std::vector<std::string> materials;
    std::vector<LibraryStatement> libraries;
    /// Faces that were dropped because corners coincide or all are collinear, so that no triangle
    /// is left.
    std::uint64_t degenerate = 0;
    /// What was left out or corrected, one sentence each, with the file and the place in it.
    std::vector<std::string> warnings;
};

/// How a mesh is read; the result is the same.
struct MeshReading {
    int threads = 1;  ///< 0: as many as the machine has
    /// How much of an OBJ file is one task, at least to the end of a line; 0: it is chosen by the
    /// file's size.
    std::size_t chunk_bytes = 0;
};

/// Reads a mesh in the format of the ending of `path`. Faces with more than three corners are
/// split: a convex one as a fan from its first corner, a concave one by ear clipping. Throws
/// FileError, whose message names the file and the place in it (line, byte or face), when the file
/// cannot be read, is truncated, is not a mesh, or has a vertex that is not finite or an index out
/// of range.
LoadedMesh read_mesh(const std::string& path, const MeshReading& reading = {});

/// The same for bytes, as if from a file called `name`.
LoadedMesh read_mesh(std::string_view bytes, const std::string& name,
                     const MeshReading& reading = {});

/// Appends the triangles of the face with these corners (indices into `vertices`) to `triangles`.
/// Each triangle is given by positions 0..n-1 of its corners in the face, so that normals and uvs
/// can use them, too. Triangles without area are dropped; returns false when none is left. A face
/// need not be planar. Throws FileError for a concave face with more than 10000 corners.
bool triangulate(std::span<const Vec3d> vertices, std::span<const std::uint32_t> corners,
                 std::vector<Mesh::Corners>& triangles);

}  // namespace lancer::io
