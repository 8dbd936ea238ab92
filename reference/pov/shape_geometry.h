// The faces of one object, and the tolerance for equal numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "reference/pov/faces.h"

namespace lancer::reference::pov {

/// The relative error that rounding of the scene's numbers may leave between coincident faces.
inline constexpr double rounding = 1e-9;

inline bool equal(double a, double b, double size) {
    return std::abs(a - b) <= rounding * std::max(1e-3, size);
}

/// Adds the faces of the object, up to a total of `most`.
void add_faces(const Scene& scene, std::uint32_t object, std::size_t most, std::vector<Face>& out);

}  // namespace lancer::reference::pov
