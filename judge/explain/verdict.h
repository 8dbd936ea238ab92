// What a whole picture's pixels come to, and whether it passes.
#pragma once

#include <cstddef>
#include <vector>

#include "judge/explain/explain.h"

namespace lancer::judge {

/// Everything that is told about pixels away from edges.
void measure_interior(Judgement& result, const Mask& edges, const std::vector<double>& differences,
                      const Thresholds& limits);

/// A share of a count as a whole number of pixels; one is always allowed, or a small scene with one
/// edge exactly through a pixel's centre could never pass.
std::size_t allowed_pixels(double share, std::size_t of);

/// What is too much, in words, and whether the pictures pass.
void decide(Judgement& result, const Thresholds& limits);

}  // namespace lancer::judge
