// A share of pixels from two kinds of them: calm ones, of which hardly any should be off, and risky
// ones, of which some are.
//
// Each kind is drawn from apart, so each count is binomial, and the risky ones have more draws for
// a pixel. What is seen is put into one number, t = step * calm + risky, by a step that is fixed
// beforehand. An interval holds all shares with which so low a t (for its upper end) or so high a
// one (for its lower end) comes about more often than once in 40 times, whatever part of the share
// lies in either kind. So it misses the true share at most once in 20 times.
#pragma once

#include <cstdint>

#include "accuracy/binomial.h"

namespace lancer::accuracy {

struct KindOfPixels {
    double weight = 0;  ///< of all pixels
    std::uint64_t draws = 0;
};

struct TwoKinds {
    KindOfPixels calm;
    KindOfPixels risky;
    std::uint64_t step =
        1;  ///< at least 1: as many as this of the risky ones a calm one counts for
    /// The draws of a kind have one chance to be off, as where each is any of its pixels. Where it
    /// is true of parts that have different ones, their mean is meant, and what is known of sums of
    /// different chances makes the interval wider: Hoeffding, "On the distribution of the number of
    /// successes in independent trials", Ann. Math. Stat. 27, 1956.
    bool alike = true;
};

/// The most and the least share of all pixels, for such a t: 1 where nothing is known.
double upper_share(const TwoKinds& kinds, std::uint64_t t);
double lower_share(const TwoKinds& kinds, std::uint64_t t);

}  // namespace lancer::accuracy
