// Pictures that get better pass by pass.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "accuracy/passes.h"
#include "tests/accuracy/plain_pictures.h"

namespace lancer::accuracy {
namespace {

struct PassRun {
    ErrorPicture picture;
    std::map<int, Image> after;           ///< pictures on the way
    std::map<int, std::uint64_t> before;  ///< samples of each pass, as announced
};

PassRun run_of(const Formula& formula, int most, bool audited = false, std::uint64_t seed = 0) {
    const PlainRenderer renderer(formula);
    PassGoal goal;
    goal.seed = seed;
    goal.audited = audited;
    PassRun run;
    run.picture = render_by_passes(renderer, {renderer, {64, 1e-5}}, view_of_128(), goal,
                                   [&](const PassState& state) {
                                       if (state.passes > 0)
                                           run.after[state.passes] = state.samples.image();
                                       run.before[state.passes + 1] = state.next;
                                       EXPECT_EQ(state.audits > 0, audited);
                                       return state.passes < most;
                                   });
    return run;
}

TEST(Passes, APictureDependsOnTheirNumberAlone) {
    const Formula& balls = plain_picture("balls");
    PassRun all = run_of(balls, 30);
    EXPECT_EQ(all.picture.report.passes, 30);
    for (const int most : {1, 2, 5, 9, 10, 20}) {
        const PassRun some = run_of(balls, most);
        EXPECT_EQ(some.picture.report.passes, most);
        EXPECT_EQ(some.picture.image.data, all.after.at(most).data) << most;
    }
    EXPECT_NE(all.after.at(10).data, all.after.at(20).data);
    EXPECT_NE(run_of(balls, 5, false, 1).picture.image.data, all.after.at(5).data);
}

TEST(Passes, EachTakesFewRaysAndTogetherTheyMendThePicture) {
    const Formula& balls = plain_picture("balls");
    const Image truth = truth_of(balls, view_of_128());
    PassRun run = run_of(balls, 120);
    const std::uint64_t pixels = 128 * 96;
    EXPECT_EQ(run.before.at(1), pixels);
    std::uint64_t held = pixels;
    for (int pass = 2; pass <= 120; ++pass) {
        EXPECT_GT(run.before.at(pass), 0U);
        // The last item of a pass may be a pixel with many samples.
        EXPECT_LE(run.before.at(pass), std::max(pixels / 8, held / 50 + 1024)) << pass;
        held += run.before.at(pass);
    }
    EXPECT_EQ(held, run.picture.report.picture.primary);
    const auto error = [&](int passes) { return rms_difference(run.after.at(passes), truth); };
    EXPECT_LT(error(9), 0.8 * error(1));
    EXPECT_LT(error(30), 0.7 * error(9));
    EXPECT_LT(error(119), 0.3 * error(30));
    // Evenly distributed samples have at least 1.8 times the error for the same number of rays.
    const PlainRenderer renderer(balls);
    const View view = view_of_128();
    PictureSamples even(renderer, view, {}, 0);
    even.raise(std::vector<std::uint32_t>(pixels, static_cast<std::uint32_t>(held / pixels)), {});
    EXPECT_LT(1.8 * error(119), rms_difference(even.image(), truth));
}

TEST(Passes, TheirErrorIsTold) {
    const Formula& waves = plain_picture("waves");
    const Image truth = truth_of(waves, view_of_128());
    int missed = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const ErrorPicture picture = run_of(waves, 25, true, seed).picture;
        const ErrorReport& report = picture.report;
        EXPECT_TRUE(report.is_told);
        EXPECT_TRUE(report.is_reached());
        const double error = rms_difference(picture.image, truth);
        missed += error < report.error.low || error > report.error.high;
    }
    EXPECT_LE(missed, 4);  // chance exceeds this once in 400 times
    const ErrorReport sparks = run_of(plain_picture("sparks"), 25, true).picture.report;
    EXPECT_FALSE(sparks.is_told);
}

TEST(Passes, EndWhenNothingIsLeftToMend) {
    const PassRun run = run_of(
        [](double, double, const TraceLimits&) {
            return Color{0.3, 0.3, 0.3};
        },
        1000, true);
    EXPECT_EQ(run.picture.report.passes, 9);
    EXPECT_TRUE(run.picture.report.error.all_zero);
    const PassRun nearly = run_of(
        [](double x, double, const TraceLimits&) {
            return Color{1, 1, 1} * (0.3 + 1e-7 * (x - std::floor(x)));
        },
        1000);
    EXPECT_EQ(nearly.picture.report.passes, 9);
}

}  // namespace
}  // namespace lancer::accuracy
