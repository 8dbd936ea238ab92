// The points that pixels are sampled at: nets, unbiased, pinned.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "model/sobol.h"

namespace lancer {
namespace {

/// Each rectangle of 2^-i x 2^(i-m) holds one of 2^m points.
void expect_net(const SobolPoints& points, std::uint32_t first, int m) {
    const std::uint32_t count = 1U << m;
    for (int i = 0; i <= m; ++i) {
        std::vector<int> held(count);
        for (std::uint32_t k = 0; k < count; ++k) {
            const SquarePoint p = points[first + k];
            const auto column = static_cast<std::uint32_t>(std::ldexp(p.x, i));
            const auto row = static_cast<std::uint32_t>(std::ldexp(p.y, m - i));
            ++held[(column << (m - i)) + row];
        }
        EXPECT_TRUE(std::ranges::all_of(held, [](int n) { return n == 1; }))
            << "from " << first << ", " << count << " points, " << (1 << i) << " columns";
    }
}

TEST(Sobol, EveryRunOfAPowerOfTwoIsANet) {
    for (const std::uint64_t key : {0U, 1U, 77U}) {
        const SobolPoints points(pixel_key(key, 3, 5));
        for (int m = 0; m <= 10; ++m) {
            for (const std::uint32_t run : {0U, 1U, 5U})
                expect_net(points, run << static_cast<unsigned>(m), m);
        }
    }
    expect_net(SobolPoints(0), 0, 16);  // seeds of 0, too
}

TEST(Sobol, PointsLieInsideTheSquare) {
    for (int pixel = 0; pixel < 100; ++pixel) {
        const SobolPoints points(pixel_key(0, pixel, 0));
        for (std::uint32_t i = 0; i < 1000; ++i) {
            const SquarePoint p = points[i];
            ASSERT_TRUE(p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1);
        }
    }
}

/// Over pixels each index is uniform: the chi-square of 16 x 16 cells, 255 degrees of freedom.
TEST(Sobol, EachPointIsUniformOverPixels) {
    constexpr int pixels = 256;
    for (const std::uint32_t index : {0U, 1U, 2U, 15U, 1000U}) {
        std::vector<double> cells(256);
        for (int y = 0; y < pixels; ++y) {
            for (int x = 0; x < pixels; ++x) {
                const SquarePoint p = SobolPoints(pixel_key(9, x, y))[index];
                ++cells[static_cast<std::size_t>(p.x * 16) * 16 +
                        static_cast<std::size_t>(p.y * 16)];
            }
        }
        double chi_square = 0;
        for (const double n : cells) chi_square += (n - pixels) * (n - pixels) / pixels;
        // One in 10^5 below or above.
        EXPECT_GT(chi_square, 163) << index;
        EXPECT_LT(chi_square, 360) << index;
    }
}

/// The mean squared error of n points for the share of the square beyond a slanted line.
template <class Points>
double squared_error(int repeats, std::uint32_t n, Points points_of) {
    double sum = 0;
    for (int r = 0; r < repeats; ++r) {
        const auto points = points_of(r);
        double inside = 0;
        for (std::uint32_t i = 0; i < n; ++i) inside += points(i).x + 0.37 * points(i).y < 0.6;
        const double truth = 0.6 - 0.37 / 2;
        sum += (inside / n - truth) * (inside / n - truth);
    }
    return sum / repeats;
}

TEST(Sobol, AnEdgeIsMeasuredWithAFractionOfTheErrorOfRandomPoints) {
    constexpr int repeats = 4000;
    const auto ours = [](int r) {
        const SobolPoints points(pixel_key(1, r, 0));
        return [points](std::uint32_t i) { return points[i]; };
    };
    const double variance = 0.415 * 0.585;
    EXPECT_LT(squared_error(repeats, 16, ours), variance / 16 / 3);
    EXPECT_LT(squared_error(repeats, 256, ours), variance / 256 / 12);
    // There is no bias: the mean over many sequences equals the truth within 4 standard errors.
    double mean = 0;
    for (int r = 0; r < repeats; ++r) {
        const auto points = ours(r);
        for (std::uint32_t i = 0; i < 16; ++i)
            mean += (points(i).x + 0.37 * points(i).y < 0.6) / (16.0 * repeats);
    }
    EXPECT_NEAR(mean, 0.415, 4 * std::sqrt(squared_error(repeats, 16, ours) / repeats));
}

/// Two nets with half the points each determine the error of the whole, which requires that they
/// are independent.
TEST(Sobol, NetsOfDifferentStreamsAreIndependent) {
    constexpr int pixels = 20000;
    double product = 0, square = 0;
    for (int x = 0; x < pixels; ++x) {
        double mean[2]{};
        for (const std::uint64_t stream : {0U, 1U}) {
            const SobolPoints points(pixel_key(2, x, 7, stream));
            for (std::uint32_t i = 0; i < 8; ++i)
                mean[stream] += (points[i].x + 0.37 * points[i].y < 0.6) / 8.0 - 0.415 / 8;
        }
        product += mean[0] * mean[1];
        square += mean[0] * mean[0];
    }
    EXPECT_LT(std::abs(product / square), 4 / std::sqrt(pixels));
}

TEST(Sobol, KeysDependOnEverything) {
    std::set<std::uint64_t> keys;
    for (const std::uint64_t seed : {0U, 1U})
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x)
                for (const std::uint64_t stream : {0U, 1U, 2U})
                    keys.insert(pixel_key(seed, x, y, stream));
    EXPECT_EQ(keys.size(), 2 * 40 * 40 * 3u);
    EXPECT_NE(pixel_key(0, 1, 0), pixel_key(0, 0, 1));
}

/// Pictures have the same bytes at any time and on any machine.
TEST(Sobol, PinnedValues) {
    EXPECT_EQ(pixel_key(0, 0, 0), 18152189527315630385U);
    EXPECT_EQ(pixel_key(1, 640, 480, 2), 9663613426371829864U);
    const SobolPoints points(pixel_key(0, 0, 0));
    const SquarePoint expected[] = {{0x1.513cf2c1p-1, 0x1.ca84eed5p-1},
                                    {0x1.7f04c5a6p-2, 0x1.3aaf6facp-3},
                                    {0x1.cbb02d39p-1, 0x1.e4cb874ep-2}};
    for (std::uint32_t i = 0; i < 3; ++i) {
        EXPECT_EQ(points[i].x, expected[i].x) << i;
        EXPECT_EQ(points[i].y, expected[i].y) << i;
    }
}

}  // namespace
}  // namespace lancer
