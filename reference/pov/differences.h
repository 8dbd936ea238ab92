// What POV-Ray does otherwise by rule, found in a scene before it is rendered.
#pragma once

#include <vector>

#include "reference/pov/export.h"
#include "reference/pov/export_scale.h"

namespace lancer::reference::pov {

/// The rules that this scene can meet, each with the objects where it can show. Errs on the side of
/// naming one: boxes stand for objects where only these are compared.
std::vector<KnownDifference> known_differences(const Scene& scene, PowerOfTen scale,
                                               const std::vector<Coincidence>& coincidences);

}  // namespace lancer::reference::pov
