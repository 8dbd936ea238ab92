// The order of objects in the `.pov`.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/pov/export.h"

namespace lancer::reference::pov {

/// The objects' indices in the order of the scene, except for transparent bodies that may contain
/// the camera. These are sorted from the largest to the smallest, because POV-Ray assumes that a
/// camera inside of several bodies entered them in the order of declaration.
std::vector<std::uint32_t> declaration_order(const Scene& scene, const ExportView& view);

}  // namespace lancer::reference::pov
