// Predicts the error of each pixel from its samples and those of the pixels around it. The
// prediction is good enough to decide where more rays help most. The error of the whole picture is
// measured by an audit (audit.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "accuracy/picture_samples.h"

namespace lancer::accuracy {

/// For each value the mean over the square of (2 radius + 1)^2 values around it, clipped at the
/// borders.
std::vector<double> box_means(std::span<const double> values, int width, int height, int radius);

/// The predicted squared error of a pixel with n samples, summed over channels, is
/// kappa * score / n^1.5. This is the rate of Sobol points in a pixel with an edge.
class Prediction {
  public:
    /// Scores from the samples as they are. The pixel's own variance counts the more the more
    /// samples it has; until then what its neighbours differ by stands for what it may have missed.
    void score(const PictureSamples& samples);

    /// The ratio of measured to predicted squared error. It starts at a guess; audits correct it.
    double kappa = 0.6;

    const std::vector<double>& scores() const { return scores_; }
    /// The predicted squared error of a pixel if it had `count` samples.
    double of(std::size_t pixel, double count) const;
    /// For each pixel, at its number of samples.
    std::vector<double> errors(const PictureSamples& samples) const;
    /// Mean of errors() over pixels and channels: the mean squared error.
    double mean_square(const PictureSamples& samples) const;

  private:
    std::vector<double> scores_;
};

}  // namespace lancer::accuracy
