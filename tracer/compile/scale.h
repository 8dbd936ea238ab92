// The power of two that brings a scene to an extent near 1.
//
// Multiplying by a power of two is exact, so a scene and the same scene 2^k times as large compile
// to the same World, bit for bit, and nothing overflows or vanishes that need not.
#pragma once

#include "model/scene.h"
#include "tracer/numerics/power_of_two.h"

namespace lancer {

/// Largest absolute coordinate of the shape in its own space; of a plane, its offset.
double extent_of(const Shape& shape, const Scene& scene);

/// k such that 2^k times the extent of the scene (objects, cameras, lights) lies in [0.5, 1); 0 for
/// an empty one.
int scale_exponent(const Scene& scene);

}  // namespace lancer
