// Reads Wavefront OBJ.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/io/mesh_file.h"
#include "model/io/polygon_soup.h"

namespace lancer::io {

/// How much of a file stands before a chunk of it, or in it.
struct ObjCounts {
    std::uint32_t lines = 0;
    std::size_t vertices = 0;
    std::size_t uvs = 0;
    std::size_t normals = 0;
    std::size_t faces = 0;
};

/// Statements that follow each other in a file. Indices and lines are those of the file; materials
/// are the chunk's own.
struct ObjChunk {
    PolygonSoup soup;
    std::uint64_t first_faces = 0;  ///< that come before any `usemtl`
    /// Of the faces that follow; nothing when it is still that from before the chunk.
    std::optional<std::uint32_t> material;
    std::string colorless;  ///< the warning for the first vertex without a colour
};

/// Reads `v`, `vt`, `vn` and `f` (Wavefront, Advanced Visualizer manual, appendix B1); skips the
/// other statements of the format. Negative indices count back from the last element. Throws
/// FileError, which names `name` and the line, for an invalid or non-finite number, for a statement
/// that OBJ does not have, and for an index that is 0 or before the first. Reserves memory for
/// `within`, which may be a guess.
ObjChunk read_obj_chunk(std::string_view bytes, const std::string& name, const ObjCounts& before,
                        const ObjCounts& within);

/// Reads a whole file, by chunks if `reading` and its size say so, with the same result.
std::vector<ObjChunk> read_obj(std::string_view bytes, const std::string& name,
                               const MeshReading& reading);

/// All chunks of a file as one.
PolygonSoup join_obj(std::vector<ObjChunk> chunks);

}  // namespace lancer::io
