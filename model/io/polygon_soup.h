// What a mesh file holds, as it stands there: faces of any number of corners.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "model/io/mesh_file.h"
#include "model/shapes.h"

namespace lancer::io {

/// Filled by the readers of the formats, which check numbers; indices are checked by `build_mesh`.
struct PolygonSoup {
    std::vector<Vec3d> vertices;
    std::vector<Vec3d> normals;
    std::vector<Vec2d> uvs;
    std::vector<Vec3d> colors;  ///< of the vertices, linear light; empty, or one for each

    /// One entry per corner, face after face. `normal_corners` and `uv_corners` may be empty: then
    /// normals (uvs), if there are any, belong to the vertices one by one.
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> normal_corners;  ///< may hold `none`
    std::vector<std::uint32_t> uv_corners;      ///< may hold `none`

    /// For each face the end of its corners; faces of three corners throughout may leave it empty.
    std::vector<std::uint64_t> face_ends;
    /// For each face the line it stands on, for messages; empty: faces are counted from 0 instead.
    std::vector<std::uint32_t> face_lines;

    /// For each face the number of its material in `materials`, or `none`; empty: none has one.
    std::vector<std::uint32_t> face_materials;
    std::vector<std::string> materials;  ///< names
    std::vector<LibraryStatement> libraries;

    /// What the format counts its first vertex as: messages count as the file does.
    std::uint32_t first_index = 0;
    /// Vertices, normals, uvs and colours with a number that is not finite, or of a colour
    /// negative, with what to say of the first face that uses one. What no face uses does not
    /// matter.
    std::map<std::uint32_t, std::string> bad_vertices, bad_normals, bad_uvs, bad_colors;
    std::vector<std::string> warnings;
};

/// An index that counts back from the end of a list that is empty so far.
inline constexpr std::uint32_t before_the_first = none - 1;

/// Triangulates, leaves out degenerate faces and counts them. Throws FileError naming `name` and
/// the place when an index is out of range or there is no face at all.
LoadedMesh build_mesh(PolygonSoup soup, const std::string& name);

}  // namespace lancer::io
