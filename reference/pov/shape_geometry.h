// The faces of one object, and when two numbers of them are one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "reference/pov/faces.h"

namespace lancer::reference::pov {

/// What rounding of the scene's own numbers leaves of a coincidence, of the numbers' size.
inline constexpr double rounding = 1e-9;

inline bool equal(double a, double b, double size) {
    return std::abs(a - b) <= rounding * std::max(1e-3, size);
}

/// Adds the faces of the object, until there are `most`.
void add_faces(const Scene& scene, std::uint32_t object, std::size_t most, std::vector<Face>& out);

}  // namespace lancer::reference::pov
