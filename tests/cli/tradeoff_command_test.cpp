// `lancer tradeoff`, run as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class TradeOffCommand : public testing::Test {
  protected:
    TradeOffCommand() { place_.write("a.lancer", small_scene()); }
    Finished tradeoff(std::vector<std::string> options) const {
        options.insert(options.begin(), {"tradeoff", "a.lancer", "--size", "16x12"});
        return place_.run(options, "", {"LANCER_CACHE=" + place_.path("cache")});
    }
    Workplace place_;
};

TEST_F(TradeOffCommand, TellsTableAndJson) {
    const Finished finished = tradeoff({"--json", "t.json"});
    EXPECT_EQ(finished.code, 0) << finished.err;
    EXPECT_THAT(finished.err, IsEmpty());
    EXPECT_THAT(finished.out, HasSubstr("a.lancer (16x12, "));
    EXPECT_THAT(finished.out, HasSubstr("as the scene says\n"));
    EXPECT_THAT(finished.out, HasSubstr("\nfor an error below 0.02: "));
    const nlohmann::json json = nlohmann::json::parse(place_.read("t.json"));
    const nlohmann::json& scene = json.at("scenes").at(0);
    EXPECT_EQ(scene.at("scene"), "a.lancer");
    EXPECT_EQ(scene.at("width"), 16);
    EXPECT_EQ(scene.at("truth").at("cached"), false);
    EXPECT_EQ(scene.at("advice").size(), 3U);
    const nlohmann::json& settings = scene.at("settings");
    ASSERT_GT(settings.size(), 20U);
    const nlohmann::json& exact = settings.at(scene.at("exact").get<std::size_t>());
    EXPECT_EQ(exact.at("knob"), "exact");
    std::size_t on_frontier = 0;
    for (const nlohmann::json& s : settings) {
        on_frontier += s.at("frontier") ? 1 : 0;
        EXPECT_EQ(s.at("frontier"), s.at("beaten_by").is_null());
        EXPECT_LE(s.at("low"), s.at("rmse"));
        EXPECT_LE(s.at("rmse"), s.at("high"));
        EXPECT_GT(s.at("rays").at("primary"), 0);
        EXPECT_GT(s.at("seconds"), 0);
    }
    EXPECT_GT(on_frontier, 2U);
    EXPECT_LT(on_frontier, settings.size());
    // The options are those of `render`, and do there what was measured.
    for (const nlohmann::json& s : settings) {
        if (s.at("knob") != "combination" && s.at("knob") != "exact" && s.at("knob") != "quality")
            continue;
        std::vector<std::string> words{"render", "a.lancer", "--size",
                                       "16x12",  "--stats",  "s.json"};
        std::istringstream options(s.at("options").get<std::string>());
        for (std::string word; options >> word;) words.push_back(word);
        ASSERT_EQ(place_.run(words).code, 0) << s.at("options");
        EXPECT_EQ(nlohmann::json::parse(place_.read("s.json")).at("rays"), s.at("rays"))
            << s.at("options");
    }
}

TEST_F(TradeOffCommand, KeepsTheTruthUntilTheSceneIsAnother) {
    const auto is_cached = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"--json", "t.json", "--budget", "1", "-q"});
        const Finished finished = tradeoff(more);
        EXPECT_EQ(finished.code, 0) << finished.err;
        EXPECT_THAT(finished.out, IsEmpty());
        return nlohmann::json::parse(place_.read("t.json"))["scenes"][0]["truth"]["cached"] == true;
    };
    EXPECT_FALSE(is_cached({}));
    EXPECT_TRUE(is_cached({}));
    EXPECT_FALSE(is_cached({"--no-cache"}));
    EXPECT_FALSE(is_cached({"-D", "size=0.7"}));
    place_.write("a.lancer", small_scene() + "sphere { center [0, 3, 0] radius 0.1 }\n");
    EXPECT_FALSE(is_cached({}));
    place_.write("a.lancer", small_scene());
    EXPECT_TRUE(is_cached({}));
}

TEST_F(TradeOffCommand, WrongUseIsTwo) {
    place_.write("b.json", "{}");
    for (const std::vector<std::string>& wrong :
         std::vector<std::vector<std::string>>{{"--budget", "0"},
                                               {"--budget", "long"},
                                               {"--camera", "nobody"},
                                               {"--size", "65535x65535"},
                                               {"--crop", "10,10,7,7"},
                                               {"--threads", "0"},
                                               {"--json", "a.lancer"},
                                               {"--samples", "3"}}) {
        const Finished finished = tradeoff(wrong);
        EXPECT_EQ(finished.code, 2) << wrong[0] << " " << wrong[1] << finished.err;
        EXPECT_THAT(finished.err, HasSubstr("error: "));
        EXPECT_THAT(finished.out, IsEmpty());
    }
    const Finished big =
        place_.run({"tradeoff", "a.lancer", "--size", "1200x900", "--budget", "0.1"});
    EXPECT_EQ(big.code, 2);
    EXPECT_THAT(
        big.err,
        HasSubstr("--budget 0.1 is too short for a.lancer: even the truth and one setting take"));
    EXPECT_EQ(place_.read("a.lancer"), small_scene());
}

TEST_F(TradeOffCommand, TheReportReplacesNothingButReports) {
    const std::vector<std::string> quick{"--report", "r", "--budget", "1", "-q"};
    ASSERT_EQ(tradeoff(quick).code, 0);
    EXPECT_THAT(place_.read("r/index.html"), HasSubstr("made by lancer tradeoff"));
    EXPECT_THAT(place_.read("r/plot.svg"), HasSubstr("made by lancer tradeoff"));
    EXPECT_EQ(tradeoff(quick).code, 0) << "an earlier report";
    for (const char* name : {"r/index.html", "r/plot.svg"}) {
        const std::string before = place_.read(name);
        place_.write(name, "mine");
        const Finished finished = tradeoff(quick);
        EXPECT_EQ(finished.code, 2);
        EXPECT_THAT(finished.err,
                    HasSubstr(std::string("'") + name + "' exists and is not an earlier"));
        EXPECT_EQ(place_.read(name), "mine");
        place_.write(name, before);
    }
    EXPECT_EQ(tradeoff({"--report", "a.lancer"}).code, 4) << "no folder";
    EXPECT_EQ(tradeoff({"--report", "r", "--json", "r/plot.svg"}).code, 2);
}

TEST_F(TradeOffCommand, WrongScenesAndFiles) {
    EXPECT_EQ(tradeoff({"--json", "no/folder.json"}).code, 4);
    EXPECT_EQ(place_.run({"tradeoff", "nowhere.lancer"}).code, 4);
    EXPECT_EQ(place_.run({"tradeoff", "-"}, "").code, 3) << "no camera";
    // Before the first is measured.
    const Finished second = tradeoff({"nowhere.lancer"});
    EXPECT_EQ(second.code, 4);
    EXPECT_THAT(second.out, IsEmpty());
}

}  // namespace
}  // namespace lancer::cli
