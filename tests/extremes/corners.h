// Bodies cut from bodies, of glass, seen where three faces of different parts meet.
#pragma once

#include <random>

#include "model/scene.h"

namespace lancer::extremes {

/// One of several bodies, as it is or turned and stretched, seen from anywhere, zoomed up to 10^12
/// onto a corner, or onto an edge next to it. A picture of odd size aims its middle ray at the very
/// place.
Scene random_corner(std::mt19937& random, int side);

}  // namespace lancer::extremes
