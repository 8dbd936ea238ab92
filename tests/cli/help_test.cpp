// The page about the command line and the program's own help name the same options.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

using testing::IsSupersetOf;

std::set<std::string> options_in(const std::string& text) {
    static const std::regex option("--[a-z][a-z-]+");
    std::set<std::string> found;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), option);
         match != std::sregex_iterator(); ++match)
        found.insert(match->str());
    return found;
}

TEST(Help, AndThePageNameTheSameOptions) {
    const Workplace place;
    std::ifstream in(std::string(LANCER_SOURCE_DIR) + "/docs/command-line.md");
    const std::set<std::string> page = options_in({std::istreambuf_iterator<char>(in), {}});
    std::set<std::string> program = options_in(place.run({"--help"}).out);
    for (const char* command : {"render", "join", "check", "info", "export", "compare", "validate",
                                "pack", "stability", "tradeoff", "probe"}) {
        const std::set<std::string> own = options_in(place.run({command, "--help"}).out);
        EXPECT_GT(own.size(), 3u) << command;
        program.insert(own.begin(), own.end());
    }
    EXPECT_THAT(page, IsSupersetOf(program)) << "the page lacks one";
    EXPECT_THAT(program, IsSupersetOf(page)) << "the page names one that is not there";
}

}  // namespace
}  // namespace lancer::cli
