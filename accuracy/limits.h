// How far rays must be followed: as far as the error that is asked for can tell.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "accuracy/audit.h"

namespace lancer::accuracy {

/// What the command line has decided.
struct FixedLimits {
    std::optional<int> max_depth;
    std::optional<double> min_contribution;
};

/// TraceLimits that cut nothing which an RMSE of `error` could tell: a branch of a hundredth of it,
/// or what lies deeper than the quality `exact` goes.
TraceLimits limits_of_truth(double error);

/// The truth's limits, but for what is fixed: nothing else is cut.
TraceLimits whole_limits(const Truth& truth, const FixedLimits& fixed);

/// The limits with the fewest rays whose mean squared difference from the truth is at most
/// `mean_square`, as far as points spread over the picture tell. Adds to `rays`.
TraceLimits cheapest_limits(const Truth& truth, const View& view, const FixedLimits& fixed,
                            double mean_square, std::uint64_t seed, RayCounts& rays);

/// The mean squared error, over pixels, that remains however many samples `renderer` takes.
ErrorEstimate bias(const Renderer& renderer, const TraceLimits& limits, const Truth& truth,
                   const View& view, std::uint64_t seed, RayCounts& rays);

/// How much of the squared error in some pixels is what `limits`, with which `samples` were made,
/// cut: from 0 to about 1, as 16 points in each of them tell.
double share_cut(const Truth& truth, const PictureSamples& samples, const TraceLimits& limits,
                 std::span<const PixelShare> pixels, RayCounts& rays);

}  // namespace lancer::accuracy
