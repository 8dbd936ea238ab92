// Decides which shapes have an inside. Rays enter and leave only these: docs/shading.md, "bodies
// and sheets".
#pragma once

#include <map>

#include "model/scene.h"

namespace lancer {

/// For each vertex the smallest index of a vertex at the same place.
std::vector<std::uint32_t> first_at_same_place(const std::vector<Vec3d>& vertices);

/// True when every edge of the mesh belongs to exactly two faces. Vertices at the same place count
/// as one, so a mesh whose corners do not share indices can be closed, too. Sorts the edges: n log
/// n time, about 30 bytes per triangle.
bool is_closed(const Mesh& mesh);

/// True for a sphere, box, plane, capped cylinder, cone and prism, a closed mesh, a lathe whose
/// curve is closed or ends on the axis, and a composite of such bodies. All others are sheets,
/// which have no inside. For a mesh, the declaration of its author overrides its edges.
bool is_body(const Scene& scene, const Shape& shape);

/// The same for many shapes of one scene: examines the edges of each mesh once.
class Bodies {
  public:
    explicit Bodies(const Scene& scene) : scene_(scene) {}
    bool holds(const Shape& shape);

  private:
    const Scene& scene_;
    std::map<std::uint32_t, bool> closed_;  // by mesh
};

}  // namespace lancer
