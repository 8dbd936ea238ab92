// Puts samples where they lower the predicted error most, until it is small enough.
#pragma once

#include <cstdint>

#include "accuracy/picture_samples.h"
#include "accuracy/prediction.h"

namespace lancer::accuracy {

/// The largest number of samples of a pixel.
inline constexpr std::uint32_t most_per_pixel = 1U << 14;

/// The fewest samples per pixel, at best spread, whose predicted mean squared error is
/// `mean_square`, and no pixel loses any that it has.
double rays_for(const PictureSamples& samples, const Prediction& prediction, double mean_square);

/// The mean squared error that rays_for() so many rays a pixel would leave.
double mean_square_for(const PictureSamples& samples, const Prediction& prediction,
                       double rays_per_pixel);

/// Doubles the samples of pixels, looks again, and goes on until the predicted mean squared error
/// is at most `mean_square`. False when that would take more than `most_rays` in all, or more than
/// most_per_pixel where it matters. `prediction` is left scored.
bool refine(PictureSamples& samples, Prediction& prediction, double mean_square,
            std::uint64_t most_rays, const Progress& progress);

}  // namespace lancer::accuracy
