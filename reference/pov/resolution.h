// A scene in which no two faces lie in one place, and whose picture is what Lancer's contact rule
// makes of the scene in which they do.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene.h"
#include "reference/pov/coincidence.h"

namespace lancer::reference::pov {

struct ResolvedScene {
    Scene scene;
    /// Bodies of the same glass, glued: each group is one body. Sorted; objects of no group are
    /// left out.
    std::vector<std::vector<std::uint32_t>> merged;
    /// As given, but Resolution::none where no way is found.
    std::vector<FacePair> pairs;
};

/// Faces of boxes, cylinders and cones move by multiples of `step` (scene units), other bodies grow
/// by about as much about their middle, planes and sheets move along the normal. Pairs that ask for
/// nothing, and those for which no way is found, stay as they are.
ResolvedScene resolved(const Scene& scene, const std::vector<FacePair>& pairs, double step);

}  // namespace lancer::reference::pov
