// True pictures that were made already, kept by what they were made from.
#pragma once

#include <string>

#include "judge/tradeoff/true_picture.h"

namespace lancer::judge {

/// Where true pictures are kept.
struct TruthCache {
    std::string folder;  ///< empty: nowhere
    /// All that decides the picture beside view, limits and seed: the scene's files, definitions,
    /// the program itself. Hashed with the rest.
    std::string content;
};

/// Names the entry: a digest.
std::string truth_key(const std::string& content, const View& view, const TraceLimits& limits,
                      std::uint64_t seed);

/// Takes the entry's points; false, and `picture` stays as it is, when there is none or it is not
/// whole.
bool read_truth(const TruthCache& cache, const std::string& key, TruePicture& picture);

/// Keeps the picture, in one step. A cache that cannot be written costs time, not the result.
void write_truth(const TruthCache& cache, const std::string& key, const TruePicture& picture);

}  // namespace lancer::judge
