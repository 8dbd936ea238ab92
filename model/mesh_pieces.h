// Splits a mesh into meshes of some of its faces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/shapes.h"

namespace lancer {

/// Returns `count` meshes. Mesh i has the faces whose entry in `numbers` (one per face) is i, in
/// their order, and only the vertices, normals and uvs that they use. Each number below `count`
/// must occur.
std::vector<Mesh> split(const Mesh& mesh, std::span<const std::uint32_t> numbers,
                        std::uint32_t count);

/// The mesh, which has no normals, with the averaged normals that a renderer would use: for each
/// vertex the mean of its faces' normals, weighted by area; 0 where they cancel.
Mesh with_averaged_normals(const Mesh& mesh);

}  // namespace lancer
