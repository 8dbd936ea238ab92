// Puts samples where they bring most pixels near their true value, until the predicted share of
// pixels off is small enough.
#pragma once

#include <cstdint>
#include <vector>

#include "accuracy/picture_samples.h"
#include "accuracy/prediction.h"

namespace lancer::accuracy {

/// The predicted share of pixels that are off by more than a threshold, in linear light. Errors are
/// taken as normal, with the variance that Prediction guesses.
double predicted_off(const PictureSamples& samples, const Prediction& prediction, double threshold);

/// The pixels in two kinds. A pixel's risk is its predicted probability to be off, raised where its
/// neighbours may be off.
struct PixelKinds {
    std::vector<std::size_t> calm;   ///< the largest set of least risk within `calm_share`
    std::vector<std::size_t> risky;  ///< the others
};
PixelKinds kinds_of(const PictureSamples& samples, const Prediction& prediction, double threshold,
                    double calm_share);

/// Numbers of samples, and the predicted result.
struct OffAllocation {
    std::vector<std::uint32_t> counts;  ///< per pixel, at least the samples that it has
    double share = 0;                   ///< predicted share of pixels off
    double rays = 0;                    ///< sum of counts
};

/// About the fewest samples with a share of at most `share`, or the smallest share with
/// `most_rays`. A pixel that is too dear to mend stays off, as long as there are few such.
OffAllocation allocation_for(const PictureSamples& samples, const Prediction& prediction,
                             double threshold, double share, double most_rays);

/// Doubles the samples of some pixels and predicts anew, until the predicted share is at most
/// `share`. False when that would take more than `most_rays`. `prediction` is left scored.
bool refine_off(PictureSamples& samples, Prediction& prediction, double threshold, double share,
                std::uint64_t most_rays, const Progress& progress);

}  // namespace lancer::accuracy
