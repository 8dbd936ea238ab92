// Finds out why a mesh is not closed.
#pragma once

#include <cstdint>

#include "model/shapes.h"

namespace lancer {

/// Edges of a mesh that do not belong to exactly two faces (model/bodies.h, is_closed).
struct OpenEdges {
    std::uint64_t count = 0;
    std::uint64_t faces = 0;             ///< of the first such edge, in the order of the faces
    Vec3d begin{0, 0, 0}, end{0, 0, 0};  ///< of the first
};
OpenEdges open_edges(const Mesh& mesh);

}  // namespace lancer
