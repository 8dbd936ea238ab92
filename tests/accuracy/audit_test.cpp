// Audits compared with truths that they did not use.
#include <gtest/gtest.h>

#include <cmath>

#include "accuracy/allocation.h"
#include "accuracy/audit.h"
#include "accuracy/limits.h"
#include "accuracy/prediction.h"
#include "accuracy/rare_light.h"
#include "tests/accuracy/plain_pictures.h"

namespace lancer::accuracy {
namespace {

View small_view() {
    View view;
    view.width = 64;
    view.height = 48;
    return view;
}

/// However wrong the weights of the draws are, the mean of many audits is the true error.
TEST(Audit, HasNoBias) {
    for (const char* name : {"balls", "wires", "hall"}) {
        const PlainRenderer renderer(plain_picture(name));
        const View view = small_view();
        const Image truth = truth_of(plain_picture(name), view);
        const TraceLimits shallow{3, 0};
        PictureSamples samples(renderer, view, shallow, 7);
        samples.raise(std::vector<std::uint32_t>(samples.size(), 2), {});
        const double error = rms_difference(samples.image(), truth);
        Prediction prediction;
        prediction.score(samples);
        const Truth judge{renderer, {60, 0}};
        const std::vector<double> predicted = prediction.errors(samples);
        const DrawShares learned =
            best_shares(audit(judge, samples, predicted, {600, 99}, {}).seen);
        std::vector<double> all;
        for (std::uint64_t number = 0; number < 30; ++number) {
            const DrawShares& shares = number % 2 == 0 ? first_shares : learned;
            const Audit a = audit(judge, samples, predicted, {400, number, shares}, {});
            all.insert(all.end(), a.terms.begin(), a.terms.end());
            EXPECT_GE(a.rays.primary, 400 * 32U);
        }
        const ErrorEstimate e = estimate(all);
        EXPECT_NEAR(e.mean_square, error * error, 4 * e.standard_error) << name;
        EXPECT_LT(e.standard_error, 0.08 * e.mean_square) << name;
    }
}

TEST(Audit, DrawsOtherPointsForEachNumberAndSeed) {
    const PlainRenderer renderer(plain_picture("balls"));
    const View view = small_view();
    PictureSamples samples(renderer, view, {}, 7);
    samples.raise(std::vector<std::uint32_t>(samples.size(), 2), {});
    const std::vector<double> even(samples.size(), 1.0);
    const Truth truth{renderer, {}};
    const Audit first = audit(truth, samples, even, {200, 0}, {});
    EXPECT_EQ(first.terms, audit(truth, samples, even, {200, 0}, {}).terms);
    EXPECT_NE(first.terms, audit(truth, samples, even, {200, 1}, {}).terms);
}

TEST(Estimate, TheIntervalIsThatOfTheLogarithm) {
    std::vector<double> terms;
    for (int i = 0; i < 100; ++i) terms.push_back(i % 2 == 0 ? 1e-4 : 3e-4);
    const ErrorEstimate e = estimate(terms);
    EXPECT_NEAR(e.mean_square, 2e-4, 1e-12);
    EXPECT_NEAR(e.standard_error, 1e-4 / std::sqrt(99), 1e-12);
    EXPECT_NEAR(e.rmse, std::sqrt(2e-4), 1e-9);
    EXPECT_NEAR(e.high / e.rmse, std::exp(1.96 * e.log_error() / 2), 1e-9);
    EXPECT_NEAR(e.rmse / e.low, e.high / e.rmse, 1e-9);
    EXPECT_NEAR(e.effective_draws, 80, 1e-6);
}

TEST(Estimate, WhatFewDrawsCarryHasFewEffectiveOnes) {
    std::vector<double> terms(1000, 1e-6);
    terms[17] = 1;
    EXPECT_LT(estimate(terms).effective_draws, 2);
    EXPECT_EQ(estimate(std::vector<double>(1000, -1e-6)).rmse, 0);
    EXPECT_EQ(estimate({}).rmse, 0);
    EXPECT_TRUE(estimate(std::vector<double>(1000, 0.0)).all_zero);
}

TEST(Estimate, EarlierDrawsSayHowFarTheOnesThatCountMayBeOff) {
    const std::vector<double> lucky(100, 1e-4);  // met none of the rare large errors
    std::vector<double> earlier(100, 1e-4);
    for (std::size_t i = 0; i < 10; ++i) earlier[i] = 2e-3;
    const ErrorEstimate e = estimate(lucky, earlier);
    EXPECT_NEAR(e.mean_square, 1e-4, 1e-12);
    const double mean = (190 * 1e-4 + 10 * 2e-3) / 200;
    const double squares = (190 * 1e-8 + 10 * 4e-6) / 200;
    const double variance = (squares - mean * mean) * 200 / 199;
    EXPECT_NEAR(e.log_error(), std::sqrt(variance / 100) / mean, 1e-9);
    EXPECT_NEAR(e.high / e.rmse, std::exp(1.96 * e.log_error() / 2), 1e-9);
    EXPECT_LT(estimate(lucky).log_error(), 1e-6);
}

TEST(BestShares, FollowTheGuessThatWouldHaveServed) {
    // The errors follow the third guess; the first guess is far off.
    std::vector<SeenDraw> draws;
    for (int i = 0; i < 100; ++i) {
        const bool inside = i % 4 == 0;
        draws.push_back({{inside ? 0.001 : 0.02, 0.01, inside ? 0.04 : 0.0001, 0.01},
                         0.01,
                         inside ? 1.0 : 0.0});
    }
    const DrawShares best = best_shares(draws);
    EXPECT_NEAR(best[0] + best[1] + best[2] + best[3], 1, 1e-12);
    EXPECT_NEAR(best[0], 0.1, 1e-3);
    EXPECT_NEAR(best[2], 0.7, 1e-3);
    for (SeenDraw& d : draws) d.found = 0;
    EXPECT_EQ(best_shares(draws), first_shares);
}

TEST(CheapestLimits, CutWhatTheErrorCannotTell) {
    const PlainRenderer renderer(plain_picture("hall"));
    const View view = small_view();
    const Truth truth{renderer, {64, 1e-5}};
    RayCounts rays;
    const TraceLimits coarse = cheapest_limits(truth, view, {}, 1e-4, 0, rays);
    const TraceLimits fine = cheapest_limits(truth, view, {}, 1e-8, 0, rays);
    EXPECT_LT(coarse.max_depth, fine.max_depth);
    EXPECT_GT(rays.primary, 0U);
    for (const auto& [limits, most] : {std::pair(coarse, 1e-4), std::pair(fine, 1e-8)})
        EXPECT_LT(bias(renderer, limits, truth, view, 1, rays).mean_square, most);
    const TraceLimits given = cheapest_limits(truth, view, {5, 0.25}, 1e-8, 0, rays);
    EXPECT_EQ(given.max_depth, 5);
    EXPECT_EQ(given.min_contribution, 0.25);
}

TEST(Bias, IsWhatNoSamplesRemove) {
    const PlainRenderer renderer(plain_picture("hall"));
    const View view = small_view();
    const TraceLimits shallow{3, 0};
    RayCounts rays;
    const ErrorEstimate found = bias(renderer, shallow, {renderer, {60, 0}}, view, 3, rays);
    PictureSamples samples(renderer, view, shallow, 1);
    samples.raise(std::vector<std::uint32_t>(samples.size(), 256), {});
    const double error = rms_difference(samples.image(), truth_of(plain_picture("hall"), view));
    EXPECT_NEAR(found.rmse, error, 0.1 * error);
}

TEST(RareLight, IsNoticedInSparksAlone) {
    View view;
    view.width = 128;
    view.height = 96;
    for (const PlainPicture& picture : plain_pictures()) {
        const PlainRenderer renderer(picture.formula);
        PictureSamples samples(renderer, view, {}, 3);
        samples.raise(std::vector<std::uint32_t>(samples.size(), 2), {});
        const RareLight rare(samples);
        Prediction prediction;
        prediction.score(samples);
        refine(samples, prediction, 1e-4, 20 * samples.size(), {});
        EXPECT_EQ(rare.missed(samples).forbid(0.01, double(samples.size())),
                  picture.name == "sparks")
            << picture.name;
    }
}

/// The squares at the horizon are smaller than a pixel, but the nets of an audit meet all of them.
TEST(RareLight, WhatFillsMuchOfAPixelIsNone) {
    const PlainRenderer renderer(plain_picture("checker"));
    View view;
    view.width = 128;
    view.height = 96;
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
        PictureSamples samples(renderer, view, {}, seed);
        samples.raise(std::vector<std::uint32_t>(samples.size(), 2), {});
        const RareLight rare(samples);
        Prediction prediction;
        refine(samples, prediction, 0.7 * 25e-6, 1000 * samples.size(), {});
        EXPECT_FALSE(rare.missed(samples).forbid(0.005, double(samples.size()))) << seed;
    }
}

}  // namespace
}  // namespace lancer::accuracy
