// Flat faces of different objects in one place: glued blocks, a glass standing on a table.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene.h"

namespace lancer::reference::pov {

/// Indices of objects with a flat face in the plane of another object's flat face, where the boxes
/// round the two faces overlap. Faces of boxes, planes, triangles, and caps of cylinders, cones and
/// prisms are compared; meshes are not. Looks at the first 2,000 faces.
std::vector<std::uint32_t> coincident_objects(const Scene& scene);

}  // namespace lancer::reference::pov
