// Functions that are computed in a second way give the same numbers.
#include "model/elementary.h"

#include <gtest/gtest.h>
#include <sleef.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace lancer {
namespace {

/// The function for one number, which works on every processor.
double pow_by_itself(double x, double y) {
    return Sleef_cinz_powd1_u10purec(x, y);
}

bool same(double a, double b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(Elementary, PowIsTheSameByTwoLanesAndByOne) {
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<double> share(0, 1);
    int different = 0;
    for (int i = 0; i < 500000; ++i) {
        // As highlights ask, then of all sizes, then any bits.
        const double cosine = share(engine);
        const double exponent = 200 * share(engine);
        different += !same(elementary::pow(cosine, exponent), pow_by_itself(cosine, exponent));
        const double large = std::exp(200 * (share(engine) - 0.5));
        different +=
            !same(elementary::pow(large, exponent - 100), pow_by_itself(large, exponent - 100));
        const auto any = std::bit_cast<double>(engine());
        const auto other = std::bit_cast<double>(engine());
        different += !same(elementary::pow(any, other), pow_by_itself(any, other));
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double special[] = {0.0, -0.0, 1.0,    -1.0,   0.5,      2.0,       3.0,
                              -3., 1e17, 1e-308, 5e-324, infinity, -infinity, std::nan("")};
    for (const double x : special)
        for (const double y : special)
            different += !same(elementary::pow(x, y), pow_by_itself(x, y));
    EXPECT_EQ(different, 0);
}

}  // namespace
}  // namespace lancer
