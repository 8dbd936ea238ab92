// Rays where they bring most pixels near their true value, until few enough are predicted off.
#pragma once

#include <cstdint>
#include <vector>

#include "accuracy/picture_samples.h"
#include "accuracy/prediction.h"

namespace lancer::accuracy {

/// The predicted share of pixels that are off by more than a threshold, in linear light. Errors are
/// taken as normal, with the variance that Prediction guesses.
double predicted_off(const PictureSamples& samples, const Prediction& prediction, double threshold);

/// The pixels in two kinds. Where neighbours may be off, what is predicted of a pixel alone is not
/// enough to call it calm.
struct PixelKinds {
    std::vector<std::size_t> calm;   ///< as many as hold at most so large a predicted share
    std::vector<std::size_t> risky;  ///< the others
};
PixelKinds kinds_of(const PictureSamples& samples, const Prediction& prediction, double threshold,
                    double calm_share);

/// Numbers of samples, and what they are predicted to bring.
struct OffAllocation {
    std::vector<std::uint32_t> counts;  ///< each pixel's, at least those that it has
    double share = 0;                   ///< of pixels off
    double rays = 0;                    ///< of all counts
};

/// About the fewest samples with a share of at most `share`, or the smallest share with
/// `most_rays`. A pixel that is too dear to mend stays off, as long as there are few such.
OffAllocation allocation_for(const PictureSamples& samples, const Prediction& prediction,
                             double threshold, double share, double most_rays);

/// Doubles the samples of pixels, looks again, and goes on until the predicted share is at most
/// `share`. False when that would take more than `most_rays`. `prediction` is left scored.
bool refine_off(PictureSamples& samples, Prediction& prediction, double threshold, double share,
                std::uint64_t most_rays, const Progress& progress);

}  // namespace lancer::accuracy
