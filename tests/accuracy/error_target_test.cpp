// Target errors are kept, and reported truly: some runs compared with truths.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "accuracy/error_target.h"
#include "tests/accuracy/plain_pictures.h"

namespace lancer::accuracy {
namespace {

ErrorPicture rendered(const PlainRenderer& renderer, double error, std::uint64_t seed,
                      FixedLimits fixed = {}) {
    ErrorGoal goal;
    goal.max_error = error;
    goal.seed = seed;
    goal.fixed = fixed;
    return render_to_error(renderer, {renderer, limits_of_truth(error)}, view_of_128(), goal, {});
}

struct Tally {
    int runs = 0, told = 0, missed = 0, above = 0;
};

void count(Tally& tally, const std::string& name, double goal, std::uint64_t seeds) {
    const PlainRenderer renderer(plain_picture(name));
    const Image truth = truth_of(plain_picture(name), view_of_128(), name == "wires" ? 64 : 32);
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const ErrorPicture picture = rendered(renderer, goal, seed);
        const ErrorEstimate& told = picture.report.error;
        const double error = rms_difference(picture.image, truth);
        ++tally.runs;
        tally.above += error > goal;
        EXPECT_LT(error, 1.1 * goal) << name << ' ' << goal << ' ' << seed;
        if (!picture.report.is_told) continue;
        ++tally.told;
        tally.missed += error < told.low || error > told.high;
        EXPECT_LE(told.half_width(), 0.2);
    }
}

TEST(ErrorTarget, IntervalsHoldTheTruthAndGoalsAreHeld) {
    Tally tally;
    for (const char* name : {"balls", "waves", "hall"})
        for (const double goal : {0.02, 0.01}) count(tally, name, goal, 6);
    count(tally, "wires", 0.02, 20);
    EXPECT_EQ(tally.runs, 56);
    EXPECT_GE(tally.told, 54);
    // With intervals of 95 %, more than 8 of 56 miss by chance once in 500 times.
    EXPECT_LE(tally.missed, 8);
    EXPECT_LE(tally.above, 3);
}

/// Half of the draws of an audit decides without the other half, and the limits are found by
/// bisection.
TEST(ErrorTarget, DecidingTakesFewRaysWhereItIsEasy) {
    const ErrorReport report = rendered(PlainRenderer(plain_picture("balls")), 0.05, 0).report;
    EXPECT_TRUE(report.is_reached());
    EXPECT_LT(report.deciding.primary, 42000U);
}

/// In a large picture that is mostly smooth, most pixels have one sample. The audits remain
/// correct.
TEST(ErrorTarget, LargePicturesTakeOneRayWhereOneWillDo) {
    View view;
    view.width = 320;
    view.height = 240;
    const PlainRenderer renderer(plain_picture("balls"));
    const Image truth = truth_of(plain_picture("balls"), view, 32);
    int missed = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        ErrorGoal goal;
        goal.max_error = 0.008;
        goal.seed = seed;
        const ErrorPicture picture =
            render_to_error(renderer, {renderer, limits_of_truth(0.008)}, view, goal, {});
        EXPECT_TRUE(picture.report.is_reached()) << seed;
        EXPECT_LT(picture.report.rays_per_pixel, 1.2) << seed;
        const double error = rms_difference(picture.image, truth);
        EXPECT_LT(error, goal.max_error) << seed;
        missed += error < picture.report.error.low || error > picture.report.error.high;
    }
    EXPECT_LE(missed, 2);
}

TEST(ErrorTarget, SparksOfALargePictureAreMetByTwoRays) {
    View view;
    view.width = 320;
    view.height = 240;
    const PlainRenderer renderer(plain_picture("sparks"));
    ErrorGoal goal;
    goal.max_error = 0.02;
    const ErrorReport report =
        render_to_error(renderer, {renderer, limits_of_truth(0.02)}, view, goal, {}).report;
    EXPECT_GE(report.rays_per_pixel, 2);
}

TEST(ErrorTarget, SparksAreRefusedAnInterval) {
    const PlainRenderer renderer(plain_picture("sparks"));
    for (const double goal : {0.02, 0.01}) {
        for (std::uint64_t seed = 0; seed < 8; ++seed) {
            const ErrorReport report = rendered(renderer, goal, seed).report;
            EXPECT_FALSE(report.is_told) << goal << ' ' << seed;
            EXPECT_FALSE(report.is_reached()) << goal << ' ' << seed;
            EXPECT_TRUE(report.rare_light) << goal << ' ' << seed;
            EXPECT_FALSE(report.dominant.empty()) << goal << ' ' << seed;
        }
    }
}

TEST(ErrorTarget, AnAuditThatFindsNothingIsNoSuccessWhereSamplesDiffer) {
    ErrorReport report;
    report.asked = 0.02;
    report.audited = true;
    report.error.all_zero = true;
    EXPECT_TRUE(report.is_reached());
    report.predicted = 0.015;
    EXPECT_FALSE(report.is_reached());
    report.predicted = 0;
    report.rare_light = true;
    EXPECT_FALSE(report.is_reached());
}

TEST(ErrorTarget, TheSamePictureForTheSameSeed) {
    const PlainRenderer renderer(plain_picture("balls"));
    const ErrorPicture picture = rendered(renderer, 0.01, 4);
    EXPECT_EQ(picture.image.data, rendered(renderer, 0.01, 4).image.data);
    EXPECT_NE(picture.image.data, rendered(renderer, 0.01, 5).image.data);
    const double rays = std::accumulate(picture.counts.begin(), picture.counts.end(), 0.0);
    EXPECT_EQ(rays, picture.report.picture.primary);
}

TEST(ErrorTarget, WhatCannotBeReachedIsRefusedBeforehand) {
    const PlainRenderer hall(plain_picture("hall"));
    try {
        rendered(hall, 0.01, 0, {2, {}});
        FAIL() << "two levels of a hall of mirrors are not enough";
    } catch (const Unreachable& refused) {
        EXPECT_NE(std::string(refused.what()).find("already makes an RMSE of 0."),
                  std::string::npos);
    }
    const PlainRenderer checker(plain_picture("checker"));
    try {
        rendered(checker, 0.0005, 0);
        FAIL() << "a checker to the horizon";
    } catch (const Unreachable& refused) {
        EXPECT_NE(std::string(refused.what()).find("can be reached"), std::string::npos);
    }
}

/// A few pixels show light that went through 30 mirrors. Points spread over the picture miss them,
/// and more samples do not help if limits cut this light.
TEST(ErrorTarget, WhatLimitsCutInFewPixelsIsFoundByAuditsAndNotCut) {
    const PlainRenderer renderer([](double x, double y, const TraceLimits& limits) {
        const bool deep = std::abs(x - 40.3) < 1.7 && std::abs(y - 50.4) < 1.6;
        const double wave = 0.5 + 0.4 * std::sin(x * x / 90) * std::cos(y / 7);
        return Color{1, 1, 1} * (deep && limits.max_depth < 30 ? 0.0 : wave);
    });
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const ErrorReport report = rendered(renderer, 0.008, seed).report;
        EXPECT_GE(report.limits.max_depth, 30) << seed;
        EXPECT_TRUE(report.is_reached()) << seed;
        EXPECT_LT(report.rays_per_pixel, 20) << seed;
    }
}

TEST(ErrorTarget, AFlatPictureHasNoError) {
    const PlainRenderer flat([](double, double, const TraceLimits&) {
        return Color{0.3, 0.3, 0.3};
    });
    const ErrorReport report = rendered(flat, 0.001, 0).report;
    EXPECT_TRUE(report.error.all_zero);
    EXPECT_TRUE(report.is_reached());
    EXPECT_FALSE(report.is_told);
}

}  // namespace
}  // namespace lancer::accuracy
