// `lancer render --max-error`, run as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class MaxError : public testing::Test {
  protected:
    MaxError() { place_.write("a.lancer", small_scene()); }
    Finished render(std::vector<std::string> options) const {
        options.insert(options.begin(), {"render", "a.lancer"});
        return place_.run(options);
    }
    double rms_difference(const std::string& a, const std::string& b) const {
        const Image one = place_.image(a);
        const Image two = place_.image(b);
        double sum = 0;
        for (std::size_t i = 0; i < one.data.size(); ++i)
            sum += (one.data[i] - two.data[i]) * (one.data[i] - two.data[i]);
        return std::sqrt(sum / static_cast<double>(one.data.size()));
    }
    Workplace place_;
};

TEST_F(MaxError, IsNotWhatAQualityAsksFor) {
    ASSERT_EQ(render({"--quality", "normal", "-o", "a.exr"}).code, 0);
    ASSERT_EQ(render({"--samples", "3", "--sampling", "sobol", "--max-depth", "16",
                      "--min-contribution", "0.01", "-o", "b.exr"})
                  .code,
              0);
    EXPECT_EQ(rms_difference("a.exr", "b.exr"), 0);
    ASSERT_EQ(render({"--quality", "normal", "--samples", "1", "--stats", "s.json"}).code, 0);
    EXPECT_EQ(nlohmann::json::parse(place_.read("s.json")).at("rays").at("primary"), 64 * 48);
}

TEST_F(MaxError, IsHeldAndToldAndWritten) {
    const Finished finished =
        render({"--max-error", "0.01", "-o", "a.exr", "--stats", "s.json", "--seed", "3"});
    EXPECT_EQ(finished.code, 0) << finished.out << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("RMSE 0.00"));
    EXPECT_THAT(finished.out, HasSubstr("steps of 8 bits), asked 0.01; "));
    ASSERT_EQ(render({"--samples", "32", "--sampling", "sobol", "--seed", "77", "--max-depth", "64",
                      "--min-contribution", "0", "-o", "truth.exr"})
                  .code,
              0);
    for (const char* name : {"lancer:error.asked", "lancer:error.low", "lancer:rays.per_pixel"})
        EXPECT_THAT(place_.read("a.exr"), HasSubstr(name));
    const double error = rms_difference("a.exr", "truth.exr");
    EXPECT_LE(error, 0.01);
    const nlohmann::json told = nlohmann::json::parse(place_.read("s.json")).at("error");
    EXPECT_EQ(told.at("asked"), 0.01);
    EXPECT_EQ(told.at("reached"), true);
    EXPECT_LE(told.at("high"), 0.01);
    // The interval would miss the error once in 20 seeds; one 1.3 times as wide hardly ever does.
    EXPECT_GT(error, told.at("low").get<double>() / 1.3);
    EXPECT_LT(error, told.at("high").get<double>() * 1.3);
    EXPECT_GE(told.at("audit_rays"), 1000 * 32);
    ASSERT_EQ(render({"--max-error", "0.02", "-q", "-o", "a.png"}).code, 0);
    EXPECT_THAT(place_.read("a.png"), HasSubstr("lancer:error.rmse"));
}

TEST_F(MaxError, WithoutAnAuditNoIntervalIsPrinted) {
    const Finished finished =
        render({"--max-error", "0.01", "--no-audit", "--stats", "s.json", "-o", "a.png"});
    EXPECT_THAT(finished.out, HasSubstr("not audited"));
    const nlohmann::json told = nlohmann::json::parse(place_.read("s.json")).at("error");
    EXPECT_TRUE(told.at("rmse").is_null());
    EXPECT_TRUE(told.at("high").is_null());
    EXPECT_EQ(told.at("audit_rays"), 0);
}

TEST_F(MaxError, ChannelsShowWhereErrorAndSamplesAre) {
    ASSERT_LE(render({"--max-error", "0.01", "--aov", "-o", "a.exr"}).code, 1);
    const Image image = place_.image("a.exr");
    std::vector<std::string> names = image.extra_names;
    std::sort(names.begin(), names.end());
    EXPECT_THAT(names, ElementsAre("depth.Z", "error.Y", "normal.X", "normal.Y", "normal.Z",
                                   "object.id", "samples.Z", "shadow.Y"));
    const auto at = std::find(image.extra_names.begin(), image.extra_names.end(), "samples.Z") -
                    image.extra_names.begin() + 3;
    double least = 1e9, most = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            least = std::min(least, image.pixel(x, y)[at]);
            most = std::max(most, image.pixel(x, y)[at]);
        }
    }
    EXPECT_EQ(least, 2);
    EXPECT_GE(most, 8);
}

TEST_F(MaxError, WhatCannotBeReachedIsRefusedWithoutAPicture) {
    for (const auto& options : std::vector<std::vector<std::string>>{
             {"--max-error", "0.00001"},               // needs more rays than allowed
             {"--max-error", "0.01", "--no-shadows"},  // samples cannot reduce this error
             {"--max-error", "0.01", "--quality", "fine"},
             {"--quality", "best"},
             {"--max-error", "0.01", "--samples", "3"},  // contradicts the target error
             {"--max-error", "0.01", "--sampling", "grid"},
             {"--max-error", "0"},
             {"--max-error", "2"},
             {"--max-error", "flip"},
             {"--max-off", "1%"},
             {"--max-off", "0.001%:2"},
             {"--max-off", "1%:0"},
             {"--max-off", "1%:2", "--max-error", "0.01"},
             {"--max-off", "1%:2", "--samples", "3"},
             {"--max-off", "1%:2", "--no-shadows"},
             {"--no-audit"}}) {
        const Finished finished = render(options);
        EXPECT_EQ(finished.code, 2) << options.back() << finished.out;
        EXPECT_THAT(finished.err, Not(IsEmpty()));
        EXPECT_THAT(place_.files(), ElementsAre("a.lancer"));
    }
    EXPECT_THAT(render({"--max-error", "0.00001"}).err, HasSubstr("can be reached"));
    EXPECT_THAT(render({"--max-error", "0.01", "--no-shadows"}).err,
                HasSubstr("what they leave out already makes"));
}

TEST_F(MaxError, AShareOfPixelsOffIsHeldAndToldAndWritten) {
    const Finished finished =
        render({"--max-off", "1%:2", "-o", "a.exr", "--stats", "s.json", "--seed", "3"});
    EXPECT_EQ(finished.code, 0) << finished.out << finished.err;
    EXPECT_THAT(finished.out,
                HasSubstr("of the pixels are off by more than 2 steps of 8 bits, asked 1 %; "));
    for (const char* name : {"lancer:off.steps", "lancer:off.high", "lancer:rays.per_pixel"})
        EXPECT_THAT(place_.read("a.exr"), HasSubstr(name));
    const nlohmann::json told = nlohmann::json::parse(place_.read("s.json")).at("error");
    EXPECT_EQ(told.at("reached"), true);
    EXPECT_EQ(told.at("off").at("asked"), 0.01);
    EXPECT_EQ(told.at("off").at("steps"), 2);
    EXPECT_LE(told.at("off").at("high"), 0.01);
    EXPECT_TRUE(told.at("rmse").is_null());
    ASSERT_EQ(render({"--samples", "32", "--sampling", "sobol", "--seed", "77", "--max-depth", "64",
                      "--min-contribution", "0", "-o", "truth.exr"})
                  .code,
              0);
    const Image one = place_.image("a.exr");
    const Image two = place_.image("truth.exr");
    int off = 0;
    for (std::size_t i = 0; i < one.data.size(); i += 3) {
        double most = 0;
        for (std::size_t c = i; c < i + 3; ++c)
            most = std::max(most, std::abs(one.data[c] - two.data[c]));
        off += most > 2 / 255.0;
    }
    EXPECT_LE(off, 0.01 * 64 * 48);
    ASSERT_EQ(render({"--max-off", "5:4", "--no-audit", "-o", "a.png"}).code, 0);
}

TEST_F(MaxError, HoldsForFramesAndCrops) {
    const Finished frames = render({"--max-error", "0.03", "--frames", "1..2", "-o", "f%d.png"});
    EXPECT_LE(frames.code, 1) << frames.err;
    EXPECT_THAT(place_.files(), ElementsAre("a.lancer", "f1.png", "f2.png"));
    const Finished crop = render({"--max-error", "0.03", "--crop", "20,10,30,20", "-o", "c.png"});
    EXPECT_LE(crop.code, 1) << crop.err;
    EXPECT_EQ(place_.image("c.png").width, 30);
}

TEST_F(MaxError, PassesGiveTheSameBytesForAnyNumberOfThreads) {
    ASSERT_EQ(render({"--passes", "14", "--threads", "1", "-o", "a.exr"}).code, 0);
    const Finished finished = render({"--passes", "14", "--threads", "3", "-o", "b.exr"});
    EXPECT_THAT(finished.out, HasSubstr("; --passes 14 makes the same picture again"));
    EXPECT_EQ(place_.read("a.exr"), place_.read("b.exr"));
    EXPECT_THAT(place_.read("a.exr"), HasSubstr("lancer:passes"));
    ASSERT_EQ(render({"--passes", "15", "-o", "b.exr"}).code, 0);
    EXPECT_NE(place_.read("a.exr"), place_.read("b.exr"));
}

/// On a busy machine the picture may be late; then the exit code says so.
TEST_F(MaxError, ATimeGivesAPictureThatItsPassesMakeAgain) {
    const Finished finished = render({"--time", "5", "-o", "a.png", "--stats", "s.json"});
    ASSERT_NE(finished.code, 2) << finished.err;
    const nlohmann::json told = nlohmann::json::parse(place_.read("s.json"));
    const double seconds = told.at("seconds").at("total");
    EXPECT_EQ(finished.code, seconds > 5.25 ? 1 : 0) << seconds << finished.out << finished.err;
    EXPECT_TRUE(told.at("error").at("asked").is_null());
    const int passes = told.at("error").at("passes");
    const Finished again = render({"--passes", std::to_string(passes), "-o", "b.png"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(place_.read("a.png"), place_.read("b.png"));
}

TEST_F(MaxError, ATimeTooShortForARayAPixelIsRefusedWithoutAPicture) {
    const Finished finished = render({"--time", "0.01", "--size", "6000x4000"});
    EXPECT_EQ(finished.code, 2) << finished.out;
    EXPECT_THAT(finished.err, HasSubstr("--time 0.01 is too short"));
    EXPECT_THAT(finished.err, HasSubstr("that takes about"));
    EXPECT_THAT(place_.files(), ElementsAre("a.lancer"));
}

}  // namespace
}  // namespace lancer::cli
