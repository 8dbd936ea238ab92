// Samples of stability that were taken already, kept by what they were made from.
#pragma once

#include <optional>
#include <string>

#include "judge/stability/stability.h"

namespace lancer::judge {

/// The sample that the cache has of this change; nothing when there is none or it is not whole.
std::optional<Sample> kept_sample(const SampleCache& cache, Change change, int exponent);

/// Keeps the sample, in one step. A cache that cannot be written costs time, not the result.
void keep_sample(const SampleCache& cache, Change change, const Sample& sample);

}  // namespace lancer::judge
