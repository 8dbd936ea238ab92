// The order of objects in the `.pov`.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/pov/export.h"

namespace lancer::reference::pov {

/// The objects' indices in the order of the scene, but for bodies that light passes and that may
/// hold the camera: these stand from the largest to the smallest, because POV-Ray takes those that
/// hold the camera to have been entered in the order of declaration.
std::vector<std::uint32_t> declaration_order(const Scene& scene, const ExportView& view);

}  // namespace lancer::reference::pov
