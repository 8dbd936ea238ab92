#include "tracer/splines/roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <random>
#include <vector>

namespace lancer::splines {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;

/// Bernstein coefficients of the product of (s - root), in wide arithmetic: multiplying by (s - r)
/// is multiplying by the linear polynomial with coefficients -r and 1 - r.
std::vector<Wide> from_roots(const std::vector<double>& roots) {
    std::vector<Wide> c{1};
    for (const double r : roots) {
        const std::size_t n = c.size();  // the new degree
        std::vector<Wide> next(n + 1, 0);
        for (std::size_t i = 0; i < n; ++i) {
            next[i] += c[i] * Wide(n - i) / n * Wide(-r);
            next[i + 1] += c[i] * Wide(i + 1) / n * (1 - Wide(r));
        }
        c = next;
    }
    return c;
}

Wide value(std::vector<Wide> c, const Wide& s) {
    for (std::size_t n = c.size() - 1; n > 0; --n) {
        for (std::size_t i = 0; i < n; ++i) c[i] = c[i] * (1 - s) + c[i + 1] * s;
    }
    return c[0];
}

template <std::size_t N>
Bernstein<double, N> rounded(const std::vector<Wide>& c, double factor = 1) {
    Bernstein<double, N> d{};
    for (std::size_t i = 0; i <= N; ++i) d[i] = static_cast<double>(c[i]) * factor;
    return d;
}

template <std::size_t N>
std::vector<Root<double>> find(const Bernstein<double, N>& c) {
    std::vector<Root<double>> roots;
    sign_change_roots<double>(Polynomial<double, N>{c}, [&](const auto& r) { roots.push_back(r); });
    return roots;
}

/// The root of the polynomial with exactly these double coefficients nearest to `s`, by bisection.
template <std::size_t N>
Wide true_root(const Bernstein<double, N>& c, double s, double reach) {
    const std::vector<Wide> wide(c.begin(), c.end());
    Wide low = Wide(s) - reach;
    Wide high = Wide(s) + reach;
    const bool negative = value(wide, low) < 0;
    EXPECT_NE(negative, value(wide, high) < 0);
    for (int i = 0; i < 120; ++i) {
        const Wide middle = (low + high) / 2;
        ((value(wide, middle) < 0) == negative ? low : high) = middle;
    }
    return low;
}

template <std::size_t N>
void check_random_roots(double factor) {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> place(-0.5, 1.5);
    for (int round = 0; round < 300; ++round) {
        std::vector<double> roots(N);
        for (double& r : roots) r = place(generator);
        std::ranges::sort(roots);
        double gap = 1;
        for (std::size_t i = 0; i < N; ++i) {
            gap = std::min({gap, std::abs(roots[i]), std::abs(roots[i] - 1)});
            if (i > 0) gap = std::min(gap, roots[i] - roots[i - 1]);
        }
        if (gap < 1e-3) continue;
        const auto c = rounded<N>(from_roots(roots), factor);
        const auto found = find<N>(c);
        std::erase_if(roots, [](double r) { return r < 0 || r > 1; });
        ASSERT_EQ(found.size(), roots.size()) << round;
        for (std::size_t i = 0; i < roots.size(); ++i) {
            EXPECT_NEAR(found[i].s, roots[i], 1e-6);
            // Backward stable: the error is that of coefficients rounded a few times.
            const std::vector<Wide> wide(c.begin(), c.end());
            const Wide truth = true_root<N>(c, found[i].s, gap / 4);
            const Wide slope = (value(wide, truth + 1e-20) - value(wide, truth)) / Wide(1e-20);
            double largest = 0;
            for (const double x : c) largest = std::max(largest, std::abs(x));
            const Wide bound = 32 * unit_roundoff<double> * (Wide(largest) / abs(slope) + 1);
            EXPECT_LE(abs(found[i].s - truth), bound) << round;
        }
    }
}

TEST(Roots, RandomCubicsAreFoundToTheLastDigits) {
    check_random_roots<3>(1);
}
TEST(Roots, RandomSexticsAreFoundToTheLastDigits) {
    check_random_roots<6>(1);
}
TEST(Roots, AnyScale) {
    check_random_roots<3>(1e90);
    check_random_roots<3>(1e-90);
    check_random_roots<6>(1e-200);
}

TEST(Roots, RisingAndFallingAlternate) {
    const auto found = find<3>(rounded<3>(from_roots({0.2, 0.5, 0.9})));
    ASSERT_EQ(found.size(), 3u);
    EXPECT_TRUE(found[0].rising);
    EXPECT_FALSE(found[1].rising);
    EXPECT_TRUE(found[2].rising);
}

TEST(Roots, AStraightPolynomialIsSolvedExactly) {
    const auto found = find<1>({-1.0, 3.0});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].s, 0.25);
}

TEST(Roots, ATouchIsNoCrossingAndATripleRootIsOne) {
    // Coefficients of (s - 1/2)^2 and (s - 1/2)^3 are dyadic: they are these polynomials exactly.
    EXPECT_TRUE(find<2>(rounded<2>(from_roots({0.5, 0.5}))).size() % 2 == 0);
    EXPECT_EQ(find<3>({-0.125, 0.125, -0.125, 0.125}).size(), 1u);
    EXPECT_EQ(find<3>({0, 0, 0, 0}).size(), 0u);
}

TEST(Roots, PairsASmallGapApartAreBothFound) {
    for (const double gap : {1e-2, 1e-4, 1e-6}) {
        EXPECT_EQ(find<3>(rounded<3>(from_roots({0.37, 0.37 + gap, 2}))).size(), 2u) << gap;
        EXPECT_EQ(find<6>(rounded<6>(from_roots({0.37, 0.37 + gap, 2, 3, 4, 5}))).size(), 2u)
            << gap;
    }
}

TEST(Roots, TheirNumberFollowsFromTheSignsAtTheEnds) {
    std::mt19937 generator(5);
    std::uniform_int_distribution<int> digit(-2, 2);
    for (int round = 0; round < 3000; ++round) {
        Bernstein<double, 6> c{};
        for (double& x : c) x = digit(generator);  // many zeros and ties
        const auto found = find<6>(c);
        EXPECT_EQ(found.size() % 2 == 1, (c.front() < 0) != (c.back() < 0));
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].rising, (i % 2 == 0) == (c.front() < 0));
        }
    }
}

}  // namespace
}  // namespace lancer::splines
