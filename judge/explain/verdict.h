// Summarizes the pixels of a picture, and decides whether it passes.
#pragma once

#include <cstddef>
#include <vector>

#include "judge/explain/explain.h"

namespace lancer::judge {

/// Measures the pixels away from edges.
void measure_interior(Judgement& result, const Mask& edges, const std::vector<double>& differences,
                      const Thresholds& limits);

/// A share of a count as a whole number of pixels, at least one: otherwise a small scene with one
/// edge exactly through a pixel's centre could never pass.
std::size_t allowed_pixels(double share, std::size_t of);

/// Lists in words what exceeds its limit, and decides whether the pictures pass.
void decide(Judgement& result, const Thresholds& limits);

}  // namespace lancer::judge
