// The search for a scene's safe window, with a renderer that is wrong where the test says so.
#include "judge/stability/stability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "judge/stability/stability_text.h"
#include "model/diagnostic.h"

namespace lancer::judge {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

constexpr int side = 10;

Scene ball() {
    Scene scene;
    scene.cameras.push_back({"", {0, 0, 5}, {0, 0, 0}, {0, 1, 0}, PerspectiveProjection{40}, {}});
    scene.objects.push_back({Sphere{}, 0, 0, none, true, {}});
    return scene;
}

/// Grey, except for one pixel that is white when the radius of the scene's ball is outside
/// `low..high`.
struct FakeRenderer {
    double low = 0;
    double high = std::numeric_limits<double>::infinity();
    double off = 0.5;  ///< by which the pixel differs
    int* pictures = nullptr;

    Image operator()(const Scene& scene, Precision precision) const {
        if (pictures != nullptr) ++*pictures;
        const double radius = std::get<Sphere>(scene.objects[0].shape).radius;
        Image image(side, side);
        std::fill(image.data.begin(), image.data.end(), 0.5);
        if (radius < low || radius > high || precision == Precision::extended)
            image.data[3] = 0.5 + off;
        return image;
    }
};

Window run(const FakeRenderer& renderer, const Trial& trial, const StabilityOptions& options = {}) {
    const Scene scene = ball();
    StabilityTest test(scene, renderer, options, [] { return true; });
    return test.run(trial);
}

TEST(Stability, FindsBothEndsWithFewPictures) {
    int pictures = 0;
    const Window w = run({1e-7, 1.5e11, 0.5, &pictures}, {Change::scale, -100, 100, {}});
    EXPECT_EQ(w.lowest, -7);
    EXPECT_EQ(w.highest, 11);
    EXPECT_LE(pictures, 16);
    EXPECT_TRUE(w.holds(-7, 11));
    EXPECT_FALSE(w.holds(-8, 11));
    EXPECT_FALSE(w.holds(-7, 12));
}

TEST(Stability, WhatIsKeptIsNotLookedAtAgain) {
    const Scene scene = ball();
    int pictures = 0;
    const FakeRenderer renderer{1e-7, 1.5e11, 0.5, &pictures};
    const fs::path folder = fs::path(testing::TempDir()) / "lancer-stability-cache";
    fs::remove_all(folder);
    const auto found = [&](const std::string& content) {
        StabilityTest test(scene, renderer, {}, [] { return true; },
                           {folder.string(), content, true});
        return test.run({Change::scale, -100, 100, {}});
    };
    const Window first = found("a");
    const int made = pictures;
    const Window second = found("a");
    EXPECT_EQ(pictures, made) << "not even the unchanged one";
    EXPECT_EQ(second.lowest, -7);
    EXPECT_EQ(second.highest, 11);
    ASSERT_EQ(second.samples.size(), first.samples.size());
    for (std::size_t i = 0; i < first.samples.size(); ++i) {
        EXPECT_EQ(second.samples[i].wrong, first.samples[i].wrong);
        EXPECT_EQ(second.samples[i].most, first.samples[i].most);
    }
    found("b");
    EXPECT_EQ(pictures, 2 * made);
    fs::remove_all(folder);
}

TEST(Stability, EveryEndIsFound) {
    for (int end = 0; end <= 20; ++end) {
        const Window w =
            run({0, 1.5 * std::pow(10.0, end), 0.5, nullptr}, {Change::scale, -3, 20, {}});
        EXPECT_EQ(w.highest, end);
        EXPECT_EQ(w.lowest, -3);
        EXPECT_EQ(w.samples.back().exponent >= end, true);
    }
}

TEST(Stability, WhatWasNotLookedAtIsNotHeld) {
    const Window w = run({}, {Change::scale, -100, 100, {}});
    EXPECT_TRUE(w.holds(-100, 100));
    EXPECT_FALSE(w.holds(-100, 99)) << "99 is not one of the search's steps";
    EXPECT_TRUE(run({}, {Change::scale, -100, 100, {99}}).holds(-100, 99));
}

TEST(Stability, AWrongSampleInTheMiddleEndsTheWindow) {
    // Wrong between 10^2.5 and 10^3.5 only: the search steps over it, `also` does not.
    const auto hole = [](const Scene& scene, Precision) {
        const double r = std::get<Sphere>(scene.objects[0].shape).radius;
        Image image(side, side);
        if (r > 300 && r < 3000) image.data[0] = 1;
        return image;
    };
    const Scene scene = ball();
    StabilityTest test(scene, hole, {}, [] { return true; });
    EXPECT_EQ(test.run({Change::scale, 0, 50, {}}).highest, 50);
    EXPECT_EQ(test.run({Change::scale, 0, 50, {3}}).highest, 2);
    StabilityOptions options;
    options.every = true;
    StabilityTest all(scene, hole, options, [] { return true; });
    const Window w = all.run({Change::scale, 0, 50, {}});
    EXPECT_EQ(w.highest, 2);
    EXPECT_EQ(w.samples.size(), 50u);
}

TEST(Stability, TwosAskForTheSameBits) {
    const FakeRenderer nearly{0, 5, 1e-15, nullptr};
    EXPECT_EQ(run(nearly, {Change::scale, 0, 9, {}}).highest, 9);
    const Window w = run(nearly, {Change::twos, 0, 9, {}});
    EXPECT_EQ(w.highest, 2);
    EXPECT_EQ(w.samples.back().different, 1u);
    EXPECT_EQ(w.samples.back().wrong, 0u);
}

TEST(Stability, ThresholdsDecideWhatIsWrong) {
    const FakeRenderer renderer{0, 5, 0.25, nullptr};
    StabilityOptions options;
    options.fail = 0.3;
    EXPECT_EQ(run(renderer, {Change::scale, 0, 4, {}}, options).highest, 4);
    options = {};
    options.fail_percent = 1;  // one pixel of a hundred
    EXPECT_EQ(run(renderer, {Change::scale, 0, 4, {}}, options).highest, 4);
    options.fail_percent = 0.9;
    EXPECT_EQ(run(renderer, {Change::scale, 0, 4, {}}, options).highest, 0);
}

TEST(Stability, NotANumberIsWrong) {
    Image good(1, 1);
    Image bad(1, 1);
    bad.data[2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(compare_to(good, bad, 3, {}).wrong, 1u);
    EXPECT_EQ(compare_to(bad, bad, 3, {}).wrong, 1u) << "NaN is never right";
    good.data[0] = 7;
    bad.data = {9, 0, 0};
    EXPECT_EQ(compare_to(good, bad, 3, {}).wrong, 0u) << "both are white";
    EXPECT_EQ(compare_to(good, bad, 3, {}).different, 1u);
}

TEST(Stability, ASceneThatCannotBeRenderedThereEndsTheWindow) {
    const auto refuses = [](const Scene& scene, Precision) {
        if (std::get<Sphere>(scene.objects[0].shape).radius > 1e3)
            throw SceneError({}, "out of range");
        return Image(side, side);
    };
    const Scene scene = ball();
    StabilityTest test(scene, refuses, {}, [] { return true; });
    const Window w = test.run({Change::scale, 0, 9, {}});
    EXPECT_EQ(w.highest, 3);
    EXPECT_EQ(w.samples.back().failure, "out of range");
    EXPECT_EQ(w.samples.back().wrong, 100u);
}

TEST(Stability, ShiftBeginsBeforeItsFirstStep) {
    const auto moved_too_far = [](const Scene& scene, Precision) {
        Image image(side, side);
        if (std::get<Sphere>(scene.objects[0].shape).center.x > 2e4) image.data[0] = 1;
        return image;
    };
    const Scene scene = ball();
    StabilityTest test(scene, moved_too_far, {}, [] { return true; });
    EXPECT_EQ(test.run({Change::shift, 0, 16, {}}).highest, 4);
    EXPECT_EQ(test.run({Change::shift, 5, 16, {}}).highest, 4) << "none of what was tried";
    EXPECT_EQ(default_trial(scene, 0, Change::shift).low, 0) << "5 away from what it looks at";
}

TEST(Stability, NoTimeLeavesItOpen) {
    int left = 3;
    const Scene scene = ball();
    StabilityTest test(scene, FakeRenderer{}, {}, [&] { return left-- > 0; });
    const Window w = test.run({Change::scale, -100, 100, {100}});
    EXPECT_TRUE(w.cut_short);
    EXPECT_EQ(w.samples.size(), 3u);
    EXPECT_EQ(w.samples.back().exponent, 100) << "what was asked for comes first";
    EXPECT_FALSE(test.run({Change::extended, 0, 0, {}}).holds());
}

StabilityReport report() {
    StabilityReport r;
    r.scene = "a & b.lancer";
    r.precision = "double";
    r.width = r.height = side;
    r.windows.push_back(run({1e-7, 1.5e11, 0.5, nullptr}, {Change::scale, -100, 100, {}}));
    r.windows.push_back(run({}, {Change::twos, -50, 50, {}}));
    r.windows.push_back(run({}, {Change::extended, 0, 0, {}}));
    return r;
}

TEST(StabilityText, SaysItInOneSentence) {
    StabilityReport r = report();
    EXPECT_EQ(stability_sentence(r),
              "right from 1e-7 to 1e11 times its size, the same bits from 2^-50 to 2^50 times its "
              "size, not as with more digits");
    r.povray.emplace();
    r.povray->lowest = -2;
    r.povray->highest = 3;
    EXPECT_THAT(stability_sentence(r),
                testing::EndsWith("; POV-Ray from 1e-2 to 1e3 times its size"));
    r.povray->failure = "not there";
    EXPECT_THAT(stability_sentence(r), testing::Not(HasSubstr("POV-Ray")));
}

TEST(StabilityText, RowsSayWhereItEndsAndHow) {
    const StabilityReport r = report();
    const std::string scale = stability_row(r, r.windows[0]);
    EXPECT_THAT(scale, HasSubstr("1e-7"));
    EXPECT_THAT(scale, HasSubstr("1e12: 1 pixel wrong, 1 %"));
    EXPECT_THAT(stability_row(r, r.windows[1]), HasSubstr("2^50*"));
    EXPECT_THAT(stability_row(r, r.windows[2]), HasSubstr("1 pixel wrong"));
}

TEST(StabilityText, ThePlotHasAPanelPerRange) {
    const std::string svg = stability_plot(report());
    EXPECT_THAT(svg, testing::StartsWith("<svg "));
    EXPECT_THAT(svg, HasSubstr("a &amp; b.lancer"));
    EXPECT_THAT(svg, HasSubstr("size, times 10^k"));
    EXPECT_THAT(svg, testing::Not(HasSubstr("64 bits")));
    EXPECT_THAT(svg, testing::Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace lancer::judge
