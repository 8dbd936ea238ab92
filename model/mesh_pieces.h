// A mesh taken apart into meshes of some of its faces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/shapes.h"

namespace lancer {

/// One mesh for each number below `count`, with the faces that have it in `numbers` (one for each
/// face of the mesh) in their order, and no vertex, normal or uv that they do not use. Each number
/// is some face's.
std::vector<Mesh> split(const Mesh& mesh, std::span<const std::uint32_t> numbers,
                        std::uint32_t count);

/// The mesh, which has no normals, with those that a renderer would make: for each vertex the mean
/// of its faces' normals, weighted by area; 0 where they cancel.
Mesh with_averaged_normals(const Mesh& mesh);

}  // namespace lancer
