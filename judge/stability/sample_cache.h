// A cache of stability samples, keyed by all that they depend on.
#pragma once

#include <optional>
#include <string>

#include "judge/stability/stability.h"

namespace lancer::judge {

/// The cached sample of this change; nothing when there is none or it is incomplete.
std::optional<Sample> kept_sample(const SampleCache& cache, Change change, int exponent);

/// Stores the sample atomically. A failure to write costs time, not the result.
void keep_sample(const SampleCache& cache, Change change, const Sample& sample);

}  // namespace lancer::judge
