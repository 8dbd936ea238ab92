// How wrong each pixel may be, guessed from the samples of the pixel and of those around it. Good
// enough to tell where more rays help most; how wrong the picture is, an audit tells (audit.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "accuracy/picture_samples.h"

namespace lancer::accuracy {

/// The means over squares of (2 radius + 1)^2 values around each, cut off at the borders.
std::vector<double> box_means(std::span<const double> values, int width, int height, int radius);

/// Squared errors, summed over channels, as a function of the numbers of samples n:
/// kappa * score / n^1.5. Sobol points in a pixel with an edge behave so.
class Prediction {
  public:
    /// Scores from the samples as they are. The pixel's own variance counts the more the more
    /// samples it has; until then what its neighbours differ by stands for what it may have missed.
    void score(const PictureSamples& samples);

    /// What audits found over what was predicted; begins at a guess.
    double kappa = 0.6;

    const std::vector<double>& scores() const { return scores_; }
    double of(std::size_t pixel, double count) const;
    /// For each pixel, at its number of samples.
    std::vector<double> errors(const PictureSamples& samples) const;
    /// Mean of errors() over pixels and channels: the mean squared error.
    double mean_square(const PictureSamples& samples) const;

  private:
    std::vector<double> scores_;
};

}  // namespace lancer::accuracy
