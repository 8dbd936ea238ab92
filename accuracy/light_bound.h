// The most light that a ray of a scene can bring, whatever it meets.
#pragma once

#include "model/scene.h"

namespace lancer::accuracy {

/// Whether any surface mirrors light or lets it pass. Where none does, rays have no branches.
bool has_branches(const Scene& scene);

/// A bound, by channel, on what any ray brings whose light is followed through at most `surfaces`
/// surfaces: to what each sends by itself, it adds what the one behind or before it sends, times
/// the share that passes or is mirrored. Infinite where that grows beyond all numbers. The terms
/// are those of docs/shading.md, each at its largest; rounding is not counted.
Color most_light(const Scene& scene, int surfaces);

}  // namespace lancer::accuracy
