// An interval for the share of pixels off, where pixels are of two kinds: calm pixels, of which
// hardly any should be off, and risky pixels, of which some are.
//
// The kinds are drawn from independently, so each count is binomial; risky pixels have more draws
// per pixel. The two counts of draws off are combined to one number, t = step * calm + risky, with
// a step that is fixed before the draws. The upper end of the interval is the largest share for
// which a t this low or lower has a probability above 1/40, for any distribution of the share over
// the two kinds. The lower end is the smallest share for which a t this high or higher has such a
// probability. So the interval misses the true share with a probability of at most 1/20.
#pragma once

#include <cstdint>

#include "accuracy/binomial.h"

namespace lancer::accuracy {

struct KindOfPixels {
    double weight = 0;  ///< share of all pixels
    std::uint64_t draws = 0;
};

struct TwoKinds {
    KindOfPixels calm;
    KindOfPixels risky;
    std::uint64_t step = 1;  ///< at least 1: a calm draw off counts as this many risky ones
    /// Whether all draws of a kind have the same probability to be off. They do when each draw can
    /// be any pixel of the kind. They do not when parts of a picture draw from their own pixels;
    /// the probability is then the mean over the draws, and bounds for sums of unequal trials make
    /// the interval wider: Hoeffding, "On the distribution of the number of successes in
    /// independent trials", Ann. Math. Stat. 27, 1956.
    bool alike = true;
};

/// The ends of the interval for this t, as shares of all pixels.
double upper_share(const TwoKinds& kinds, std::uint64_t t);
double lower_share(const TwoKinds& kinds, std::uint64_t t);

}  // namespace lancer::accuracy
