// A cache of true pictures, keyed by all that they depend on.
#pragma once

#include <string>

#include "judge/tradeoff/true_picture.h"

namespace lancer::judge {

/// The folder and the key of the cache.
struct TruthCache {
    std::string folder;  ///< empty: nowhere
    /// All that the picture depends on beside view, limits and seed: the scene's files,
    /// definitions, the program itself. It is hashed with the rest.
    std::string content;
};

/// The name of an entry: a digest.
std::string truth_key(const std::string& content, const View& view, const TraceLimits& limits,
                      std::uint64_t seed);

/// Reads an entry's points. Returns false and leaves `picture` unchanged when there is none or it
/// is incomplete.
bool read_truth(const TruthCache& cache, const std::string& key, TruePicture& picture);

/// Stores the picture atomically. A failure to write costs time, not the result.
void write_truth(const TruthCache& cache, const std::string& key, const TruePicture& picture);

}  // namespace lancer::judge
