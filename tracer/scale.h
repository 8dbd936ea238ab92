// The power of two that brings a scene to an extent near 1.
//
// Multiplying by a power of two is exact, so a scene and the same scene 2^k times as large compile
// to the same World, bit for bit, and nothing overflows or vanishes that need not.
#pragma once

#include <cmath>
#include <optional>

#include "model/scene.h"

namespace lancer {

/// Largest absolute coordinate of the shape in its own space; nothing for a plane's infinite
/// extent.
double extent_of(const Shape& shape, const Scene& scene);

/// k such that 2^k times the extent of the scene (objects, cameras, lights) lies in [0.5, 1); 0 for
/// an empty one.
int scale_exponent(const Scene& scene);

/// k such that 2^k extent lies in [0.5, 1); 0 for 0.
int exponent_for(double extent);

inline Vec3d scaled(const Vec3d& p, int exponent) {
    return {ldexp(p.x, exponent), ldexp(p.y, exponent), ldexp(p.z, exponent)};
}

}  // namespace lancer
