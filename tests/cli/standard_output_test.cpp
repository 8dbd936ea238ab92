// Standard output: `-` is its name for all commands, and a result that cannot be written to it is
// an error.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Output : public testing::Test {
  protected:
    Output() {
        place_.write("a.lancer", small_scene());
        EXPECT_EQ(place_.run({"render", "a.lancer", "-o", "a.png"}).code, 0);
        EXPECT_EQ(place_.run({"render", "a.lancer", "-o", "b.png", "-D", "size=0.7"}).code, 0);
    }
    /// Each command with something to say.
    const std::vector<std::vector<std::string>> commands_{
        {"render", "a.lancer", "-o", "c.png"},
        {"render", "a.lancer", "-o", "c.png", "--stats", "-", "-q"},
        {"render", "a.lancer", "-o", "/dev/stdout"},
        {"check", "a.lancer"},
        {"info", "a.lancer"},
        {"info", "a.lancer", "--json"},
        {"export", "a.lancer", "-o", "a.pov"},
        {"compare", "a.png", "b.png"},
        {"compare", "a.png", "a.png", "-q", "--json", "-"},
        {"compare", ".", "."},
        {"validate", "a.lancer", "--size", "8x6"},
        {"stability", "a.lancer", "--no-povray", "--size", "8x6", "--try", "axes"},
        {"--help"},
        {"render", "--help"},
        {"--version"},
        {"info", "--version"}};
    Workplace place_;
};

TEST_F(Output, ThatCannotBeWrittenIsFour) {
    const std::vector<std::pair<BrokenOutput, std::string>> kinds{
        {BrokenOutput::full, "No space left on device"},
        {BrokenOutput::closed_pipe, "Broken pipe"},
        {BrokenOutput::closed, "Bad file descriptor"}};
    for (const auto& [output, reason] : kinds) {
        for (const std::vector<std::string>& command : commands_) {
            const Finished finished = place_.run_in({.output = output}, command);
            if (output == BrokenOutput::closed && command.back() == "/dev/stdout") {
                EXPECT_EQ(finished.code, 4) << "by whatever reason the system gives";
                continue;
            }
            const std::string shown = command[0] + " " + reason;
            EXPECT_EQ(finished.code, 4) << shown << "\n" << finished.err;
            EXPECT_THAT(finished.err, HasSubstr(reason)) << shown;
            EXPECT_EQ(finished.err.find(reason), finished.err.rfind(reason)) << "told once";
        }
    }
}

TEST_F(Output, ThatIsNotNeededMayBeMissing) {
    for (const BrokenOutput output :
         {BrokenOutput::full, BrokenOutput::closed_pipe, BrokenOutput::closed}) {
        EXPECT_EQ(place_.run_in({.output = output}, {"render", "a.lancer", "-q"}).code, 0);
        EXPECT_EQ(place_.run_in({.output = output}, {"check", "a.lancer", "-q"}).code, 0);
    }
    // If a file of the run had the number of the closed stream, the message would be in that file.
    const std::string picture = place_.read("a.png");
    EXPECT_EQ(place_.run_in({.output = BrokenOutput::closed}, {"render", "a.lancer"}).code, 4);
    EXPECT_EQ(place_.read("a.png"), picture);
}

TEST_F(Output, JsonMayGoThereFromEveryCommand) {
    const std::vector<std::vector<std::string>> commands{
        {"compare", "a.png", "b.png"},
        {"validate", "a.lancer", "--size", "8x6"},
        {"stability", "a.lancer", "--no-povray", "--size", "8x6", "--try", "axes"}};
    for (std::vector<std::string> command : commands) {
        const Finished plain = place_.run(command);
        EXPECT_THAT(plain.out, Not(IsEmpty())) << command[0];
        EXPECT_THAT(plain.err, IsEmpty()) << command[0];
        command.insert(command.end(), {"--json", "-"});
        const Finished finished = place_.run(command);
        EXPECT_EQ(finished.code, plain.code) << command[0];
        EXPECT_TRUE(nlohmann::json::accept(finished.out)) << finished.out;
        EXPECT_THAT(finished.err, StartsWith(plain.out.substr(0, plain.out.find(' '))))
            << "what else is printed";
        EXPECT_FALSE(place_.exists("-"));
        command.emplace_back("-q");
        EXPECT_THAT(place_.run(command).err, IsEmpty()) << command[0];
    }
}

TEST_F(Output, StatisticsForPeopleAreAllThatStandsThere) {
    const Finished finished = place_.run({"render", "a.lancer", "--stats", "-"});
    EXPECT_THAT(finished.out, StartsWith("parse "));
    EXPECT_THAT(finished.out, Not(HasSubstr("wrote")));
    EXPECT_THAT(finished.err, StartsWith("wrote a.png"));
}

}  // namespace
}  // namespace lancer::cli
