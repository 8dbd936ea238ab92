// Target shares of pixels that are off are kept, and reported truly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "accuracy/binomial.h"
#include "accuracy/off_target.h"
#include "tests/accuracy/plain_pictures.h"

namespace lancer::accuracy {
namespace {

ErrorPicture rendered(const PlainRenderer& renderer, double share, double steps, std::uint64_t seed,
                      FixedLimits fixed = {}) {
    OffGoal goal;
    goal.share = share;
    goal.steps = steps;
    goal.seed = seed;
    goal.fixed = fixed;
    const Truth truth{renderer, limits_of_truth(goal.threshold())};
    return render_to_share(renderer, truth, view_of_128(), goal, {});
}

double share_off(const Image& image, const Image& truth, double steps) {
    int off = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            double most = 0;
            for (int c = 0; c < 3; ++c)
                most = std::max(most, std::abs(image.pixel(x, y)[c] - truth.pixel(x, y)[c]));
            off += most > steps / 255;
        }
    }
    return off / (double(image.width) * image.height);
}

/// The expected values are from R's binom.test.
TEST(Binomial, IntervalsAreThoseOfTheTables) {
    const auto expect = [](std::uint64_t k, std::uint64_t n, double low, double high) {
        const ChanceInterval interval = clopper_pearson(k, n);
        EXPECT_NEAR(interval.low, low, 5e-7) << k << ' ' << n;
        EXPECT_NEAR(interval.high, high, 5e-7) << k << ' ' << n;
    };
    expect(0, 10, 0, 0.3084971);
    expect(10, 10, 0.6915029, 1);
    expect(5, 100, 0.01643188, 0.11283491);
    expect(50, 100, 0.39832112, 0.60167888);
    expect(0, 40000, 0, 9.221759e-05);
}

TEST(Binomial, AChanceGivesItsProbability) {
    EXPECT_NEAR(chance_of_at_most(0, 10, 0.5), 1 - std::pow(0.5, 0.1), 1e-12);
}

TEST(OffTarget, SharesAreHeldAndIntervalsHoldTheTruth) {
    int runs = 0, missed = 0, unreached = 0;
    const auto count = [&](const std::string& name, double share, double steps, int seeds) {
        const PlainRenderer renderer(plain_picture(name));
        const Image truth = truth_of(plain_picture(name), view_of_128(), name == "wires" ? 64 : 32);
        for (int seed = 0; seed < seeds; ++seed) {
            const ErrorPicture picture =
                rendered(renderer, share, steps, static_cast<std::uint64_t>(seed));
            const double off = share_off(picture.image, truth, steps);
            const OffEstimate& told = picture.report.off->estimate;
            EXPECT_LE(off, share) << name << ' ' << share << ' ' << steps << ' ' << seed;
            EXPECT_LE(told.high - told.low, 1.5 * share);
            ++runs;
            missed += off < told.low || off > told.high;
            unreached += !picture.report.is_reached();
        }
    };
    for (const char* name : {"balls", "waves", "hall"}) count(name, 0.02, 2, 3);
    count("balls", 0.005, 4, 3);
    count("wires", 0.02, 4, 6);
    for (const char* name : {"balls", "waves"}) count(name, 0.001, 4, 2);  // twelve pixels
    EXPECT_EQ(runs, 22);
    // With intervals of 95 %, more than 5 of 22 miss by chance once in 1,000 times.
    EXPECT_LE(missed, 5);
    EXPECT_LE(unreached, 3);
}

TEST(OffTarget, TakesFewerRaysThanEvenOnes) {
    const PlainRenderer renderer(plain_picture("balls"));
    const ErrorPicture picture = rendered(renderer, 0.01, 2, 1);
    const Image truth = truth_of(plain_picture("balls"), view_of_128());
    PictureSamples even(renderer, view_of_128(), TraceLimits{64, 0}, 1);
    even.raise(std::vector<std::uint32_t>(even.size(), 16), {});
    EXPECT_GT(share_off(even.image(), truth, 2), 0.01);
    EXPECT_LT(picture.report.rays_per_pixel, 12);
}

/// A picture has many more calm pixels, and few draws of them are sufficient.
TEST(OffTarget, CalmPixelsHaveHalfOfTheDraws) {
    const ErrorPicture picture = rendered(PlainRenderer(plain_picture("balls")), 0.005, 4, 0);
    const OffCount& count = picture.sums.off->printed;
    EXPECT_EQ(count.pixels(), 128.0 * 96);
    EXPECT_GT(count.calm.pixels, 3 * count.risky.pixels / 2);
    const auto draws_of_a_pixel = [](const KindCount& kind) {
        return static_cast<double>(kind.draws) / static_cast<double>(kind.pixels);
    };
    EXPECT_NEAR(draws_of_a_pixel(count.risky) / draws_of_a_pixel(count.calm), 13.0 / 6, 0.02);
    EXPECT_EQ(count.calm.off, 0U);
}

/// Specks that no sample has met, in pixels whose samples all agree. An audit meets them, and the
/// interval includes them although nothing predicts them.
TEST(OffTarget, WhatNothingPredictsIsStillInTheInterval) {
    const auto speck = [](double x, double y, const TraceLimits&) {
        const double at_x = x - std::floor(x);
        const double at_y = y - std::floor(y);
        const int pixel = static_cast<int>(x) + 128 * static_cast<int>(y);
        const bool met = pixel % 97 == 5 && at_x > 0.4 && at_x < 0.6 && at_y > 0.4 && at_y < 0.7;
        return Color{1, 1, 1} * (met ? 1.0 : 0.4);
    };
    const PlainRenderer renderer(speck);
    const Image truth = truth_of(speck, view_of_128(), 32);
    int held = 0;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const ErrorPicture picture = rendered(renderer, 0.005, 4, seed);
        const OffEstimate& told = picture.report.off->estimate;
        const double off = share_off(picture.image, truth, 4);
        held += told.low <= off && off <= told.high;
    }
    EXPECT_GE(held, 4);
}

TEST(OffTarget, TheSamePictureForTheSameSeed) {
    const PlainRenderer renderer(plain_picture("balls"));
    const ErrorPicture picture = rendered(renderer, 0.01, 3, 4);
    EXPECT_EQ(picture.image.data, rendered(renderer, 0.01, 3, 4).image.data);
    EXPECT_NE(picture.image.data, rendered(renderer, 0.01, 3, 5).image.data);
}

TEST(OffTarget, WhatCannotBeReachedIsRefusedBeforehand) {
    const auto refusal = [](const std::string& name, double steps, FixedLimits fixed) {
        try {
            rendered(PlainRenderer(plain_picture(name)), 0.001, steps, 0, fixed);
        } catch (const Unreachable& refused) {
            return std::string(refused.what());
        }
        return std::string();
    };
    EXPECT_NE(refusal("hall", 4, {2, {}}).find("what they leave out already puts"),
              std::string::npos);
    EXPECT_NE(refusal("checker", 0.1, {}).find("can be reached"), std::string::npos);
}

/// As in error_target_test.cpp, in 2 % of the pixels.
TEST(OffTarget, WhatLimitsCutInFewPixelsIsFoundByAuditsAndNotCut) {
    const PlainRenderer renderer([](double x, double y, const TraceLimits& limits) {
        const bool deep = std::abs(x - 40.3) < 7.7 && std::abs(y - 50.4) < 7.6;
        const double wave = 0.5 + 0.4 * std::sin(x * x / 90) * std::cos(y / 7);
        return Color{1, 1, 1} * (deep && limits.max_depth < 30 ? 0.0 : wave);
    });
    const ErrorReport report = rendered(renderer, 0.01, 4, 0).report;
    EXPECT_GE(report.limits.max_depth, 30);
    EXPECT_TRUE(report.is_reached());
}

TEST(OffTarget, AFlatPictureHasNoPixelOff) {
    const PlainRenderer flat([](double, double, const TraceLimits&) {
        return Color{0.3, 0.3, 0.3};
    });
    const ErrorReport report = rendered(flat, 0.01, 1, 0).report;
    EXPECT_EQ(report.off->estimate.share, 0);
    EXPECT_LE(report.off->estimate.high, 0.01);
    EXPECT_TRUE(report.is_reached());
}

}  // namespace
}  // namespace lancer::accuracy
