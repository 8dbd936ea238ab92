// Intervals for the share of pixels of two kinds contain the true share as often as they promise.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

#include "accuracy/strata.h"

namespace lancer::accuracy {
namespace {

TEST(Strata, OfOneKindAreClopperAndPearsons) {
    for (const auto& [k, n] :
         {std::pair{0U, 100U}, {3U, 100U}, {40U, 100U}, {100U, 100U}, {2U, 5000U}}) {
        const ChanceInterval right = clopper_pearson(k, n);
        for (const bool alike : {true, false}) {
            const TwoKinds calm{{1, n}, {0, 0}, 1, alike};
            const TwoKinds risky{{0, 0}, {1, n}, 7, alike};
            for (const TwoKinds& kinds : {calm, risky}) {
                EXPECT_NEAR(upper_share(kinds, k), right.high, 1e-6) << k << ' ' << n;
                EXPECT_LE(lower_share(kinds, k), right.low) << k << ' ' << n;
                EXPECT_GE(lower_share(kinds, k), 0.98 * right.low) << k << ' ' << n;
            }
        }
    }
}

/// Both kinds have the same draws per pixel, and each pixel that is off counts as one.
TEST(Strata, OfEqualDrawsAreThoseOfAllTogether) {
    const TwoKinds kinds{{0.75, 3000}, {0.25, 1000}, 1, true};
    for (const std::uint64_t k : {0U, 2U, 9U}) {
        const ChanceInterval right = clopper_pearson(k, 4000);
        EXPECT_NEAR(upper_share(kinds, k) / right.high, 1.01, 0.015) << k;
        EXPECT_LE(lower_share(kinds, k), right.low) << k;
        EXPECT_GE(lower_share(kinds, k), 0.9 * right.low) << k;
    }
}

TEST(Strata, KnowLessOfPartsThatAreNotAlike) {
    TwoKinds kinds{{0.9, 5400}, {0.1, 1300}, 6, true};
    const double alike = upper_share(kinds, 3);
    const double low = lower_share(kinds, 9);
    kinds.alike = false;
    EXPECT_GE(upper_share(kinds, 3), alike);
    EXPECT_LT(upper_share(kinds, 3), 1.3 * alike);
    EXPECT_LE(lower_share(kinds, 9), low);
    EXPECT_GT(lower_share(kinds, 9), 0.5 * low);
}

/// Counts that are drawn, wherever the share lies.
TEST(Strata, MissTheTruthOnceInFortyTimesOnEitherSide) {
    std::mt19937_64 random(5);
    for (const std::uint64_t step : {1U, 6U}) {
        for (const auto& [calm, risky] :
             {std::pair{0.0, 0.005}, {0.0004, 0.0}, {0.0001, 0.003}, {0.001, 0.02}}) {
            const TwoKinds kinds{{0.9, 5400}, {0.1, 1300}, step, true};
            const double share = 0.9 * calm + 0.1 * risky;
            std::binomial_distribution<std::uint64_t> of_calm(kinds.calm.draws, calm);
            std::binomial_distribution<std::uint64_t> of_risky(kinds.risky.draws, risky);
            std::map<std::uint64_t, int> seen;
            for (int run = 0; run < 2000; ++run) ++seen[step * of_calm(random) + of_risky(random)];
            int below = 0;
            int above = 0;
            for (const auto& [t, times] : seen) {
                below += upper_share(kinds, t) < share ? times : 0;
                above += lower_share(kinds, t) > share ? times : 0;
            }
            // 50 are allowed; 75 are three and a half standard deviations more.
            EXPECT_LE(below, 75) << step << ' ' << calm << ' ' << risky;
            EXPECT_LE(above, 75) << step << ' ' << calm << ' ' << risky;
        }
    }
}

}  // namespace
}  // namespace lancer::accuracy
