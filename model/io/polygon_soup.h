// The content of a mesh file before triangulation: faces with any number of corners.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "model/io/mesh_file.h"
#include "model/shapes.h"

namespace lancer::io {

/// Filled by the readers of the formats, which check numbers; build_mesh() checks indices.
struct PolygonSoup {
    std::vector<Vec3d> vertices;
    std::vector<Vec3d> normals;
    std::vector<Vec2d> uvs;
    std::vector<Vec3d> colors;  ///< of the vertices, linear light; empty, or one for each

    /// One entry per corner, face by face. `normal_corners` and `uv_corners` may be empty: then the
    /// normals (uvs), if there are any, belong to the vertices one by one.
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> normal_corners;  ///< may hold `none`
    std::vector<std::uint32_t> uv_corners;      ///< may hold `none`

    /// The end of each face's corners; may be empty when all faces have three corners.
    std::vector<std::uint64_t> face_ends;
    /// The line of each face, for messages; empty: faces are counted from 0 instead.
    std::vector<std::uint32_t> face_lines;

    /// The material of each face, an index into `materials`, or `none`; empty when no face has one.
    std::vector<std::uint32_t> face_materials;
    std::vector<std::string> materials;  ///< names
    std::vector<LibraryStatement> libraries;

    /// The number of the first vertex in this format: messages count like the file.
    std::uint32_t first_index = 0;
    /// Vertices, normals, uvs and colours with a number that is not finite, or with a negative
    /// colour; and the message for the first face that uses them. If no face uses them, they do not
    /// matter.
    std::map<std::uint32_t, std::string> bad_vertices, bad_normals, bad_uvs, bad_colors;
    std::vector<std::string> warnings;
};

/// A relative index into a list that is still empty.
inline constexpr std::uint32_t before_the_first = none - 1;

/// Triangulates; drops degenerate faces and counts them. Throws FileError, which names `name` and
/// the place, when an index is out of range or there is no face at all.
LoadedMesh build_mesh(PolygonSoup soup, const std::string& name);

}  // namespace lancer::io
