// The power of two that brings a scene to an extent near 1.
//
// Multiplying by a power of two is exact. So a scene and the same scene scaled by 2^k compile to
// the same World, bit for bit, and overflow and underflow are avoided where possible.
#pragma once

#include "model/scene.h"
#include "tracer/numerics/power_of_two.h"

namespace lancer {

/// The largest absolute coordinate of the shape in its own space, within a factor of two; for a
/// plane, its offset.
double extent_of(const Shape& shape, const Scene& scene);

/// k such that 2^k times the extent of the scene (objects, cameras, lights) is near 1; 0 for an
/// empty scene.
int scale_exponent(const Scene& scene);

}  // namespace lancer
