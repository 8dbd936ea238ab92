// `lancer stability`, run as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/session.h"
#include "cli/stability_options.h"
#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(ChangeRange, IsReadWhole) {
    const ChangeRange scale = parse_change_range("scale=1e-6..1e6");
    EXPECT_EQ(scale.change, judge::Change::scale);
    EXPECT_EQ(scale.low, -6);
    EXPECT_EQ(scale.high, 6);
    const ChangeRange twos = parse_change_range("twos=2^-40..1024");
    EXPECT_EQ(twos.low, -40);
    EXPECT_EQ(twos.high, 10);
    const ChangeRange shift = parse_change_range("shift=1e6");
    EXPECT_FALSE(shift.low);
    EXPECT_EQ(shift.high, 6);
    EXPECT_FALSE(parse_change_range("axes").high);
}

TEST(ChangeRange, EndsBetweenPowersAreRoundedOutwards) {
    const ChangeRange range = parse_change_range("scale=3e-7..2e5");
    EXPECT_EQ(range.low, -7);
    EXPECT_EQ(range.high, 6);
    for (int k = -300; k <= 300; ++k) {
        const std::string text = "1e" + std::to_string(k);
        EXPECT_EQ(parse_change_range("shift=" + text).high, k);
    }
}

TEST(ChangeRange, WrongOnesAreRefused) {
    for (const char* text : {"",
                             "size",
                             "scale=",
                             "scale=3",
                             "scale=..",
                             "scale=1..",
                             "scale=1e6..1e-6",
                             "scale=20..30",
                             "scale=0..1",
                             "scale=-1..1",
                             "scale=a..b",
                             "scale=nan..1",
                             "scale=1..1e999",
                             "scale=1..10^400",
                             "scale=1..3^2",
                             "twos=1..2^2000",
                             "twos=2^..2",
                             "axes=1",
                             "extended=1..2",
                             "distance=0.1",
                             "distance=0.5..2",
                             "shift=",
                             "shift=inf",
                             "scale=1..2..3"})
        EXPECT_THROW(parse_change_range(text), UsageError) << text;
}

Finished stability(const Workplace& place, std::vector<std::string> more) {
    std::vector<std::string> arguments{"stability", "-", "--size", "32x24", "--no-povray"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return place.run(arguments, small_scene());
}

TEST(StabilityCommand, TellsTheWindowAsTableJsonAndPlot) {
    const Workplace place;
    const Finished finished =
        stability(place, {"--json", "s.json", "--plot", "s.svg", "--require", "twos=2^-30..2^30",
                          "--require", "scale=1e-6..1e6", "--require", "axes"});
    EXPECT_EQ(finished.code, 0) << finished.out << finished.err;
    EXPECT_THAT(finished.err, IsEmpty());
    EXPECT_THAT(finished.out, HasSubstr("size, times 10^k"));
    EXPECT_THAT(finished.out, HasSubstr("demanded scale=1e-6..1e6: held"));
    EXPECT_THAT(finished.out, HasSubstr("\nright from 1e-100 to 1e100 times its size, the same "));
    const auto json = nlohmann::json::parse(place.read("s.json"));
    EXPECT_EQ(json["changes"].size(), 6u);
    EXPECT_EQ(json["changes"][0]["right"], nlohmann::json({-100, 100}));
    EXPECT_EQ(json["povray"], nullptr);
    EXPECT_EQ(json["demands"].size(), 3u);
    EXPECT_THAT(place.read("s.svg"), HasSubstr("</svg>"));
}

TEST(StabilityCommand, AWindowThatIsNotHeldIsOne) {
    const Workplace place;
    // Moved by 10^20, all coordinates become one number, and nothing is visible.
    const Finished finished = stability(place, {"--try", "shift=1e3", "--require", "shift=1e20"});
    EXPECT_EQ(finished.code, 1);
    EXPECT_THAT(finished.out, HasSubstr("demanded shift=1e20: NOT HELD"));
    EXPECT_EQ(stability(place, {"--try", "shift=1e3", "--require", "shift=1e3"}).code, 0);
    const Finished quiet = stability(place, {"-q", "--try", "axes", "--require", "shift=1e20"});
    EXPECT_EQ(quiet.code, 1);
    EXPECT_THAT(quiet.out, IsEmpty());
}

TEST(StabilityCommand, TimeThatRanOutHoldsNothing) {
    const Workplace place;
    const Finished finished = place.run({"stability", "-", "--no-povray", "--size", "800x600",
                                         "--time", "0.1", "--every", "--require", "axes"},
                                        small_scene());
    EXPECT_EQ(finished.code, 1);
    EXPECT_THAT(finished.out, HasSubstr("no time for more"));
}

TEST(StabilityCommand, SaysWhenPovRayIsMissing) {
    const Workplace place;
    const Finished finished = place.run({"stability", "-", "--size", "8x6", "--try", "axes"},
                                        small_scene(), {"LANCER_POVRAY=/nowhere/povray"});
    EXPECT_EQ(finished.code, 0);
    EXPECT_THAT(finished.out, HasSubstr("/nowhere/povray"));
}

/// Three machines share two scenes; the last run takes all results from the cache.
TEST(StabilityCommand, PartsKeepWhatALastRunOverAllNeeds) {
    const Workplace place;
    place.write("a.lancer", small_scene());
    place.write("b.lancer", small_scene() + "sphere { radius 0.1 }\n");
    const std::vector<std::string> cache{"LANCER_CACHE=" + place.path("cache")};
    const auto sweep = [&](std::vector<std::string> more) {
        more.insert(more.begin(),
                    {"stability", "a.lancer", "b.lancer", "--size", "32x24", "--no-povray"});
        return place.run(more, "", cache);
    };
    ASSERT_EQ(sweep({"--json", "whole.json", "--no-cache"}).code, 0);
    EXPECT_FALSE(place.exists("cache")) << "a plain run keeps nothing";
    int rows = 0;
    for (const char* part : {"1/5", "2/5", "3/5", "4/5", "5/5"}) {
        const Finished finished = sweep({"--part", part});
        EXPECT_EQ(finished.code, 0) << finished.err;
        for (const char* title : {"size, times 10^k", "size, times 2^k", "moved by", "as far",
                                  "axes renamed", "against 64 bits"})
            for (std::size_t at = 0; (at = finished.out.find(title, at)) != std::string::npos; ++at)
                ++rows;
    }
    EXPECT_EQ(rows, 12) << "each change of each scene once";
    namespace fs = std::filesystem;
    std::vector<fs::path> entries;
    for (const auto& entry : fs::directory_iterator(place.path("cache/stability")))
        entries.push_back(entry.path());
    EXPECT_GT(entries.size(), 30U);

    ASSERT_EQ(sweep({"--json", "joined.json"}).code, 0);
    EXPECT_EQ(place.read("joined.json"), place.read("whole.json"));
    EXPECT_EQ(nlohmann::json::parse(place.read("joined.json")).at("scenes").size(), 2U);
    // Damaged entries are computed again.
    for (const fs::path& entry : entries) place.write(fs::relative(entry, place.path("")), "x");
    ASSERT_EQ(sweep({"--json", "joined.json"}).code, 0);
    EXPECT_EQ(place.read("joined.json"), place.read("whole.json"));
    EXPECT_EQ(sweep({"--part", "1/2", "--json", "a.json"}).code, 2);
    EXPECT_EQ(sweep({"--part", "1/2", "--no-cache"}).code, 2);
    EXPECT_EQ(sweep({"--part", "3/2"}).code, 2);
    EXPECT_EQ(sweep({"--plot", "a.svg"}).code, 2);
}

TEST(StabilityCommand, WrongUseIsTwo) {
    const Workplace place;
    place.write("good.lancer", small_scene());
    const std::vector<std::vector<std::string>> wrong{
        {"--try", "size=1..2"},    {"--require", "scale"},
        {"--require", "shift"},    {"--plot", "plot.png"},
        {"--fail", "2"},           {"--fail-percent", "101"},
        {"--time", "0"},           {"--size", "0x3"},
        {"--camera", "nobody"},    {"--try", "scale=10..100"},
        {"--size", "65535x65535"}, {"--precision", "quadruple"}};
    for (std::vector<std::string> arguments : wrong) {
        arguments.insert(arguments.begin(), {"stability", "good.lancer", "--no-povray"});
        const Finished finished = place.run(arguments);
        EXPECT_EQ(finished.code, 2) << arguments[3] << " " << arguments[4] << finished.err;
        EXPECT_THAT(finished.err, HasSubstr("error: "));
    }
}

TEST(StabilityCommand, WrongScenesAndFiles) {
    const Workplace place;
    EXPECT_EQ(place.run({"stability", "-"}, "sphere { raduis 1 }").code, 3);
    EXPECT_EQ(place.run({"stability", "-"}, "").code, 3) << "no camera";
    EXPECT_EQ(place.run({"stability", "nowhere.lancer"}).code, 4);
    EXPECT_EQ(stability(place, {"--json", "no/folder.json"}).code, 4);
    EXPECT_EQ(stability(place, {"--try", "axes", "--plot", "no/plot.svg"}).code, 4);
    EXPECT_THAT(place.files(), IsEmpty());
}

}  // namespace
}  // namespace lancer::cli
