// How many pixels of a picture are off by more than so much, by rays that never enter it.
//
// The picture's own samples part the pixels into calm ones, of which hardly any should be off, and
// risky ones. Those of a kind are drawn with equal chances, each draw on its own, so the number of
// those that are off is binomial; strata.h has the interval of both together. What a drawn pixel
// should be is the mean of independent nets of points; their spread says whether that is known well
// enough to decide, else each net gets twice as many.
#pragma once

#include <cstdint>

#include <vector>

#include "accuracy/audit.h"
#include "accuracy/strata.h"

namespace lancer::accuracy {

struct OffPlan {
    std::vector<std::size_t> calm;   ///< pixels
    std::vector<std::size_t> risky;  ///< all others
    std::uint64_t calm_draws = 0;
    std::uint64_t risky_draws = 0;
    std::uint64_t step = 1;  ///< as in TwoKinds
    /// Audits of different numbers are independent of each other and of the picture.
    std::uint64_t number = 0;
    double threshold = 0;  ///< a pixel is off when a channel differs by more, in linear light
};

/// Of the draws from pixels of one kind. A pixel so near to the threshold that its nets do not tell
/// is undecided.
struct KindCount {
    std::uint64_t pixels = 0;
    std::uint64_t draws = 0;
    std::uint64_t off = 0;
    std::uint64_t undecided = 0;

    void add(const KindCount& other);
    double share() const;  ///< off, undecided ones count half; 0 without draws
};

struct OffCount {
    KindCount calm;
    KindCount risky;
    std::uint64_t step = 1;  ///< as in TwoKinds
    RayCounts rays;

    double pixels() const { return static_cast<double>(calm.pixels + risky.pixels); }
    /// What strata.h calls t, at the most and at the least.
    std::uint64_t most() const;
    std::uint64_t least() const { return step * calm.off + risky.off; }
};

OffCount count_off(const Truth& truth, const PictureSamples& samples, const OffPlan& plan);

/// The same for what `renderer` and `limits` leave out, however many samples are taken: both sides
/// take the same points, few, in each drawn pixel. Nothing stays undecided.
OffCount count_left_out(const Truth& truth, const Renderer& renderer, const TraceLimits& limits,
                        const PictureSamples& samples, const OffPlan& plan);

/// A share of the pixels with its interval of 95 %. Undecided ones count as off for its upper end,
/// and as not off for its lower.
struct OffEstimate {
    double share = 0;  ///< undecided ones count half
    double low = 0;
    double high = 1;
};
OffEstimate estimate(const OffCount& count);

/// Its first number alone.
double share_of(const OffCount& count);

}  // namespace lancer::accuracy
