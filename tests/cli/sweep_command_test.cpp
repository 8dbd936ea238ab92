// Sweeps over many scenes that several machines share: --part of validate, tradeoff and stability.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

using Words = std::vector<std::string>;

class Sweep : public testing::Test {
  protected:
    Sweep() {
        place_.write("a.lancer", small_scene());
        place_.write("b.lancer", small_scene() + "sphere { radius 0.1 }\n");
    }
    Finished run(const std::string& command, Words more, const std::string& cache) const {
        more.insert(more.begin(), {command, "a.lancer", "b.lancer", "--size", "16x12"});
        return place_.run(more, "", {"LANCER_CACHE=" + cache});
    }
    Workplace place_;
};

TEST_F(Sweep, WrongUseIsToldAndNothingWritten) {
    const std::string cache = place_.path("cache");
    for (const char* command : {"validate", "tradeoff", "stability"}) {
        const auto refused = [&](const Words& options, int code, const std::string& message,
                                 const std::string& folder) {
            const Finished finished = run(command, options, folder);
            EXPECT_EQ(finished.code, code) << command << finished.err;
            EXPECT_THAT(finished.err, HasSubstr(message)) << command;
            EXPECT_EQ(finished.out, "");
        };
        refused({"--part", "3/2"}, 2, "there is no part 3 of 2", cache);
        refused({"--part", "0/2"}, 2, "there is no part 0 of 2", cache);
        refused({"--part", "half"}, 2, "expected K/N", cache);
        refused({"--part", "1/2", "--no-cache"}, 2, "remove --no-cache", cache);
        refused({"--part", "1/2", "--json", "all.json"}, 2,
                "--json is about all scenes: write it by a last run without --part", cache);
        // Whoever runs the tests may write everywhere but where there is no folder.
        refused({"--part", "1/2"}, 4, "cannot write the cache", place_.path("a.lancer/cache"));
        refused({"--part", "1/2"}, 4, "cannot write the cache", "/proc/lancer");
    }
    EXPECT_EQ(place_.files(), (Words{"a.lancer", "b.lancer"}));
}

/// The last run does not compute again what a part has stored.
TEST_F(Sweep, PartsOfATradeOffKeepTheTruthsOfTheirScenes) {
    const std::string cache = place_.path("cache");
    const auto truths = [&] {
        return std::distance(fs::directory_iterator(cache + "/truth"), fs::directory_iterator());
    };
    ASSERT_EQ(run("tradeoff", {"--part", "1/2", "--budget", "20"}, cache).code, 0);
    EXPECT_EQ(truths(), 1);
    ASSERT_EQ(run("tradeoff", {"--part", "2/2", "--budget", "20"}, cache).code, 0);
    EXPECT_EQ(truths(), 2);
    const Finished last = run("tradeoff", {"--json", "all.json", "--budget", "40", "-q"}, cache);
    ASSERT_EQ(last.code, 0) << last.err;
    const nlohmann::json all = nlohmann::json::parse(place_.read("all.json"));
    for (const auto& scene : all.at("scenes")) EXPECT_EQ(scene.at("truth").at("cached"), true);
    EXPECT_EQ(truths(), 2);
}

}  // namespace
}  // namespace lancer::cli
