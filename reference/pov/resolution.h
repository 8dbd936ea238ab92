// Moves objects so that no faces coincide, while the picture is the one that Lancer's contact rule
// gives with coincident faces.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene.h"
#include "reference/pov/coincidence.h"

namespace lancer::reference::pov {

struct ResolvedScene {
    Scene scene;
    /// Glued bodies of the same glass: each group is one body. Sorted; contains no single objects.
    std::vector<std::vector<std::uint32_t>> merged;
    /// The pairs as given, but Resolution::none where no solution was found.
    std::vector<FacePair> pairs;
};

/// Faces of boxes, cylinders and cones move by multiples of `step` (scene units), other bodies grow
/// about their centre by about as much, planes and sheets move along their normal. Pairs that need
/// no change, and those without a solution, remain.
ResolvedScene resolved(const Scene& scene, const std::vector<FacePair>& pairs, double step);

}  // namespace lancer::reference::pov
