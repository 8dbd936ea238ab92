// How many pixels of a picture are off by more than so much, by rays that never enter it.
//
// Pixels are drawn with equal chances, each draw on its own, so the number of those that are off is
// binomial. What a drawn pixel should be is the mean of independent nets of points; their spread
// says whether that is known well enough to decide, else each net gets twice as many.
#pragma once

#include <cstdint>

#include "accuracy/audit.h"

namespace lancer::accuracy {

struct OffPlan {
    int draws = 0;
    /// Audits of different numbers are independent of each other and of the picture.
    std::uint64_t number = 0;
    double threshold = 0;  ///< a pixel is off when a channel differs by more, in linear light
};

/// Of the draws. A pixel so near to the threshold that its nets do not tell is undecided.
struct OffCount {
    std::uint64_t draws = 0;
    std::uint64_t off = 0;
    std::uint64_t undecided = 0;
    RayCounts rays;
};

OffCount count_off(const Truth& truth, const Samples& samples, const OffPlan& plan);

/// The same for what `renderer` and `limits` leave out, however many samples are taken: both sides
/// take the same points, few, in each drawn pixel. Nothing stays undecided.
OffCount count_left_out(const Truth& truth, const Renderer& renderer, const TraceLimits& limits,
                        const Samples& samples, const OffPlan& plan);

/// A share of the pixels with its interval of 95 %. Undecided ones count as off for its upper end,
/// and as not off for its lower.
struct OffEstimate {
    double share = 0;  ///< undecided ones count half
    double low = 0;
    double high = 1;
};
OffEstimate estimate(const OffCount& count);

}  // namespace lancer::accuracy
