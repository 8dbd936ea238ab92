// Finds, before rendering, in what POV-Ray will differ by its own rules.
#pragma once

#include <vector>

#include "reference/pov/export.h"
#include "reference/pov/export_scale.h"

namespace lancer::reference::pov {

/// The rules that may apply to this scene, each with the objects where it may show. May name too
/// many: some tests compare only the boxes of objects.
std::vector<KnownDifference> known_differences(const Scene& scene, PowerOfTen scale,
                                               const std::vector<Coincidence>& coincidences);

}  // namespace lancer::reference::pov
