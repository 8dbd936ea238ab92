// Which shapes have an inside. Only what has one can be entered and left: docs/shading.md, "bodies
// and sheets".
#pragma once

#include <map>

#include "model/scene.h"

namespace lancer {

/// For each vertex the smallest index of a vertex at the same place.
std::vector<std::uint32_t> first_at_same_place(const std::vector<Vec3d>& vertices);

/// True when every edge of the mesh belongs to exactly two faces. Vertices at the same place are
/// one vertex, so a mesh whose corners are not shared by index can be closed too. Sorts the edges:
/// n log n time, about 30 bytes per triangle.
bool is_closed(const Mesh& mesh);

/// True for a sphere, box, plane, capped cylinder, cone and prism, a closed mesh, a lathe whose
/// curve ends on the axis or in itself, and what is made of such bodies. All else is a sheet: it
/// has no inside. For a mesh the author's word comes before its edges.
bool is_body(const Scene& scene, const Shape& shape);

/// The same, for many shapes of one scene: each mesh's edges are looked at once.
class Bodies {
  public:
    explicit Bodies(const Scene& scene) : scene_(scene) {}
    bool holds(const Shape& shape);

  private:
    const Scene& scene_;
    std::map<std::uint32_t, bool> closed_;  // by mesh
};

}  // namespace lancer
