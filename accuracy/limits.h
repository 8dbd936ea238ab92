// The cheapest limits of recursion that cut too little to matter for the error asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "accuracy/audit.h"

namespace lancer::accuracy {

/// Limits that the command line fixes.
struct FixedLimits {
    std::optional<int> max_depth;
    std::optional<double> min_contribution;
};

/// Limits of a truth for measuring an RMSE of `error`. They cut only branches of a weight below a
/// hundredth of it, and branches deeper than the depth of the quality `exact`.
TraceLimits limits_of_truth(double error);

/// The truth's limits, except for those that are fixed.
TraceLimits whole_limits(const Truth& truth, const FixedLimits& fixed);

/// The coarsest limits whose mean squared difference from the truth is at most `mean_square`, as
/// estimated at points spread over the picture. Adds to `rays`.
TraceLimits cheapest_limits(const Truth& truth, const View& view, const FixedLimits& fixed,
                            double mean_square, std::uint64_t seed, RayCounts& rays);

/// The mean squared error, over pixels, that remains with any number of samples of `renderer`.
ErrorEstimate bias(const Renderer& renderer, const TraceLimits& limits, const Truth& truth,
                   const View& view, std::uint64_t seed, RayCounts& rays);

/// How much of the squared error in some pixels is what `limits`, with which `samples` were made,
/// cut: from 0 to about 1, as 16 points in each of them tell.
double share_cut(const Truth& truth, const PictureSamples& samples, const TraceLimits& limits,
                 std::span<const PixelShare> pixels, RayCounts& rays);

}  // namespace lancer::accuracy
