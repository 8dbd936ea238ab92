// Meshes: scaled, with normals where somebody interpolates, and with a tree.
#pragma once

#include <memory>

#include "tracer/shapes/mesh.h"

namespace lancer {

struct MeshNeeds {
    bool normals = false;  ///< some instance interpolates
    bool body = false;     ///< rays go through its inside: it matters which way its faces look
};

/// \param exponent  vertices are multiplied by 2^exponent
template <class Real>
std::unique_ptr<TriangleMesh<Real>> compile_mesh(const std::shared_ptr<const Mesh>& source,
                                                 int exponent, const MeshNeeds& needs, int threads);

/// Which faces of a closed mesh (model/bodies.h) look inside: one byte per face, 1 for those that
/// do; empty when all look outside. Faces that turn against their neighbours are turned with them,
/// and the whole so that its volume is positive: scripts and scanners care little about winding.
std::vector<std::uint8_t> inward_faces(const Mesh& mesh);

}  // namespace lancer
