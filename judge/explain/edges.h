// Finds edges in our own picture: of geometry, shadows, cells of a texture.
#pragma once

#include <cstdint>
#include <vector>

#include "judge/explain/probe_function.h"
#include "model/image.h"

namespace lancer::judge {

/// One flag per pixel, rows from the top.
using Mask = std::vector<std::uint8_t>;

/// Marks both pixels of each pair of neighbours (side by side, one above the other) between which
/// `image` has an edge of at least `contrast`: another object or other lights, or a step at least
/// four times what the slopes at the two pixels predict. `image` must be what `probe` gives at the
/// centres.
Mask find_edges(const Image& image, const ProbeFunction& probe, double contrast = 0.01);

}  // namespace lancer::judge
