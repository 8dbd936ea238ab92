// An audit that counts the pixels of a picture that are off by more than a threshold. Its rays
// never enter the picture.
//
// The picture's own samples divide the pixels into calm ones, of which hardly any should be off,
// and risky ones. The draws from one kind are independent, and each pixel of the kind is equally
// likely. So the number of draws that are off is binomial; strata.h has the interval for both kinds
// together. The true value of a drawn pixel is estimated by the mean of independent nets of points.
// If the nets differ too much to decide, each gets twice as many points.
#pragma once

#include <cstdint>

#include <vector>

#include "accuracy/audit.h"
#include "accuracy/strata.h"

namespace lancer::accuracy {

struct OffPlan {
    std::vector<std::size_t> calm;   ///< indices of pixels
    std::vector<std::size_t> risky;  ///< all other pixels
    std::uint64_t calm_draws = 0;
    std::uint64_t risky_draws = 0;
    std::uint64_t step = 1;  ///< as in TwoKinds
    /// Audits of different numbers are independent of each other and of the picture.
    std::uint64_t number = 0;
    double threshold = 0;  ///< a pixel is off if a channel differs by more than this, linear light
};

/// Counts of the draws from one kind. A pixel is undecided if its error is so near to the threshold
/// that the nets cannot tell.
struct KindCount {
    std::uint64_t pixels = 0;
    std::uint64_t draws = 0;
    std::uint64_t off = 0;
    std::uint64_t undecided = 0;

    void add(const KindCount& other);
    double share() const;  ///< of draws off; undecided ones count half; 0 without draws
};

struct OffCount {
    KindCount calm;
    KindCount risky;
    std::uint64_t step = 1;  ///< as in TwoKinds
    RayCounts rays;

    double pixels() const { return static_cast<double>(calm.pixels + risky.pixels); }
    /// Upper and lower limit of t (strata.h): undecided draws count as off, or as not off.
    std::uint64_t most() const;
    std::uint64_t least() const { return step * calm.off + risky.off; }
};

OffCount count_off(const Truth& truth, const PictureSamples& samples, const OffPlan& plan);

/// Counts the pixels that are off because of what `renderer` and `limits` leave out, with any
/// number of samples. The truth and `renderer` trace the same few points in each drawn pixel. No
/// draw stays undecided.
OffCount count_left_out(const Truth& truth, const Renderer& renderer, const TraceLimits& limits,
                        const PictureSamples& samples, const OffPlan& plan);

/// A share of the pixels with its 95 % interval. Undecided pixels count as off for the upper end,
/// and as not off for the lower.
struct OffEstimate {
    double share = 0;  ///< undecided pixels count half
    double low = 0;
    double high = 1;
};
OffEstimate estimate(const OffCount& count);

/// OffEstimate::share alone, without an interval.
double share_of(const OffCount& count);

}  // namespace lancer::accuracy
