#include "cli/terminal.h"

#include <gtest/gtest.h>

#include <regex>

#include "cli/progress.h"

namespace lancer::cli {
namespace {

const std::string plain =
    "a.lancer:2:5: error: 'raduis' is not a property of sphere\n"
    "        raduis 0.5: error: x\n"
    "        ^~~~~~\n"
    "    hint: did you mean 'radius'?\n"
    "a.lancer:1:1: note: in this call\n";

TEST(Terminal, ColorsAddOnlyEscapeSequences) {
    const std::string colored = with_colors(plain);
    EXPECT_NE(colored, plain);
    EXPECT_EQ(std::regex_replace(colored, std::regex("\033\\[[0-9;]*m"), ""), plain);
}

TEST(Terminal, HeadingsAndCaretsAreColoredQuotedLinesAreNot) {
    const std::string colored = with_colors(plain);
    EXPECT_NE(colored.find("\033[1;31merror:\033[0m"), std::string::npos);
    EXPECT_NE(colored.find("\033[1;36mnote:\033[0m"), std::string::npos);
    EXPECT_NE(colored.find("        \033[1;32m^~~~~~\033[0m\n"), std::string::npos);
    EXPECT_NE(colored.find("\n        raduis 0.5: error: x\n"), std::string::npos);
}

TEST(Terminal, TimeLeftReadsLikeAClock) {
    EXPECT_EQ(as_clock_time(0), "0:00");
    EXPECT_EQ(as_clock_time(2.1), "0:03");
    EXPECT_EQ(as_clock_time(59.5), "1:00");
    EXPECT_EQ(as_clock_time(3723), "1:02:03");
    EXPECT_EQ(as_clock_time(1e300), "99:59:59");
}

}  // namespace
}  // namespace lancer::cli
