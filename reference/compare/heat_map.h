// Draws differences as a picture.
#pragma once

#include <vector>

#include "model/image.h"

namespace lancer::reference {

/// The scale is logarithmic and always the same, so that heat maps can be compared: from a
/// millionth (about an eighth of half a step of a 16-bit picture) to 1.
inline constexpr double heat_lowest = 1e-6;
inline constexpr double heat_highest = 1.0;

/// The differences (rows from the top, `width` per row, at least one) in magma: black up to
/// heat_lowest, pale yellow from heat_highest on, white where not finite. With `scale`, a bar with
/// numerals, one per factor of ten, is added below; a narrow picture is widened for it.
Image heat_map(const std::vector<double>& differences, int width, bool scale = true);

}  // namespace lancer::reference
