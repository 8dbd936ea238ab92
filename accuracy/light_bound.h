// An upper bound on the light of any ray in a scene.
#pragma once

#include "model/scene.h"

namespace lancer::accuracy {

/// Whether any surface mirrors or transmits light. If none does, rays have no branches.
bool has_branches(const Scene& scene);

/// An upper bound, per channel, on the light of any ray that is followed through at most `surfaces`
/// surfaces. It iterates b := sent + passed * b, where `sent` is what a surface sends by itself and
/// `passed` is the factor of the mirrored and transmitted light. Infinite on overflow. The terms
/// are those of docs/shading.md, each at its largest; rounding is not included.
Color most_light(const Scene& scene, int surfaces);

}  // namespace lancer::accuracy
