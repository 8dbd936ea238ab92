#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <charconv>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "parser/value.h"
#include "tests/parser/script.h"

namespace lancer {
namespace {

using test::run;
using test::value_of;

TEST(Expressions, BindAsTheManualSays) {
    EXPECT_EQ(value_of("1 + 2 * 3"), "7");
    EXPECT_EQ(value_of("(1 + 2) * 3"), "9");
    EXPECT_EQ(value_of("2 - 3 - 4"), "-5");
    EXPECT_EQ(value_of("2 ^ 3 ^ 2"), "512");
    EXPECT_EQ(value_of("-2 ^ 2"), "-4");
    EXPECT_EQ(value_of("2 ^ -1"), "0.5");
    EXPECT_EQ(value_of("2 ^ -1 * 3"), "1.5");
    EXPECT_EQ(value_of("2 ^ - 1 ^ 2"), "0.5");
    EXPECT_EQ(value_of("- - 1"), "1");
    EXPECT_EQ(value_of("1 < 2 == 3 >= 2"), "true");
    EXPECT_EQ(value_of("true || false && false"), "true");
    EXPECT_EQ(value_of("!true == false"), "true");
    EXPECT_EQ(value_of("false ? 1 : true ? 2 : 3"), "2");
    EXPECT_EQ(value_of("1 < 2 ? 1 + 1 : 5"), "2");
    EXPECT_EQ(value_of("-[1, 2, 3].y"), "-2");
    EXPECT_EQ(value_of("[[1, 2], [3, 4], [5, 6], 7][2] [0]"), "5");
}

TEST(Expressions, EvaluateOnlyWhatTheyNeed) {
    EXPECT_EQ(value_of("false && 1 / 0 > 1"), "false");
    EXPECT_EQ(value_of("true || 1 / 0 > 1"), "true");
    EXPECT_EQ(value_of("true ? 1 : 1 / 0"), "1");
    EXPECT_EQ(value_of("false && false && 1 / 0 > 0 || true"), "true");
}

TEST(Expressions, NumbersAreReadAsWritten) {
    EXPECT_EQ(value_of(".5"), "0.5");
    EXPECT_EQ(value_of("1e-9"), "1e-09");
    EXPECT_EQ(value_of("1.5E+3"), "1500");
    EXPECT_EQ(value_of("#ff8000.x"), "1");
    EXPECT_EQ(value_of("#FF0000 == [1, 0, 0]"), "true");
}

TEST(Expressions, VectorsWorkComponentByComponent) {
    EXPECT_EQ(value_of("[1, 2, 3] * [2, 3, 4]"), "[2, 6, 12]");
    EXPECT_EQ(value_of("[2, 4] / 2"), "[1, 2]");
    EXPECT_EQ(value_of("1 - [1, 2]"), "[0, -1]");
    EXPECT_EQ(value_of("[2, 3] ^ 2"), "[4, 9]");
    EXPECT_EQ(value_of("abs([-1, 2, -3])"), "[1, 2, 3]");
    EXPECT_EQ(value_of("clamp([-1, 0.5, 3], 0, 1)"), "[0, 0.5, 1]");
    EXPECT_EQ(value_of("mix([0, 0], [2, 4], 0.5)"), "[1, 2]");
    EXPECT_EQ(value_of("max([1, 5], [3, 2], 2)"), "[3, 5]");
}

TEST(Expressions, RemainderHasTheSignOfItsRightSide) {
    EXPECT_EQ(value_of("7 % 3"), "1");
    EXPECT_EQ(value_of("-7 % 3"), "2");
    EXPECT_EQ(value_of("7 % -3"), "-2");
    EXPECT_EQ(value_of("-7 % -3"), "-1");
    EXPECT_EQ(value_of("-6 % 3"), "0");
}

TEST(Expressions, RoundTakesHalvesAwayFromZero) {
    EXPECT_EQ(value_of("round([0.5, -0.5, 2.5])"), "[1, -1, 3]");
}

TEST(Expressions, WholePowersAreExactWhereTheyCanBe) {
    EXPECT_EQ(value_of("10 ^ 2"), "100");
    EXPECT_EQ(value_of("10 ^ -2"), "0.01");
    EXPECT_EQ(value_of("3 ^ 30 == 205891132094649"), "true");
    EXPECT_EQ(value_of("(-2) ^ 3"), "-8");
    EXPECT_EQ(value_of("0 ^ 0"), "1");
    EXPECT_EQ(value_of("1e-200 ^ 2"), "0");
    EXPECT_EQ(value_of("2 ^ -1074"), "5e-324");
}

TEST(Expressions, EqualityComparesValuesOfAllKinds) {
    EXPECT_EQ(value_of("[1, [2, \"a\"], true, 4] == [1, [2, \"a\"], true, 4]"), "true");
    EXPECT_EQ(value_of("[1, 2] == [1, 2, 3]"), "false");
    EXPECT_EQ(value_of("1 == \"1\""), "false");
    EXPECT_EQ(value_of("\"a\" != \"b\""), "true");
}

TEST(Expressions, StringsJoinAndEscape) {
    EXPECT_EQ(value_of(R"("a\"b\\" + "\tc")"), "a\"b\\\tc");
    EXPECT_EQ(value_of("\"n = \" + str(1.5) + str([1, \"x\"])"), "n = 1.5[1, \"x\"]");
    EXPECT_EQ(value_of("len(\"gr\xC3\xBCn\")"), "4");
}

TEST(Expressions, RangesFollowTheirDefinition) {
    EXPECT_EQ(value_of("range(0, 1, 0.25)"), "[0, 0.25, 0.5, 0.75]");
    EXPECT_EQ(value_of("range(3, 0, -1)"), "[3, 2, 1]");
    EXPECT_EQ(value_of("range(0, 0, 1)"), "[]");
    EXPECT_EQ(value_of("len(range(0, 1, 0.1))"), "10");
    EXPECT_EQ(value_of("range(0, 1, 0.1)[3] == 3 * 0.1"), "true");
}

TEST(Expressions, RandIsAFunctionOfItsArgumentsAlone) {
    EXPECT_EQ(value_of("rand(1, 2) == rand(1, 2)"), "true");
    EXPECT_EQ(value_of("rand(1, 2) == rand(2, 1)"), "false");
    EXPECT_EQ(value_of("rand(0) == rand(-0)"), "true");
    EXPECT_EQ(value_of("rand(1)"), value_of("rand([1, 1].x)"));
}

TEST(Expressions, RandIsTheHashThatTheManualDescribes) {
    // Computed in Python from the description in docs/language.md, not by this program.
    const std::vector<std::pair<std::string, std::string>> known{
        {"rand(0)", "0.8833108082136426"},
        {"rand(-0)", "0.8833108082136426"},
        {"rand(1)", "0.5345422839126993"},
        {"rand(2)", "0.002598817123781516"},
        {"rand(-1)", "0.6634604186012825"},
        {"rand(0.1)", "0.9692977027004345"},
        {"rand(1, 2)", "0.23436461775888184"},
        {"rand(2, 1)", "0.08522354133821164"},
        {"rand([1, 2, 3])", "0.5115926941369916"},
        {"rand(7, [0.5, -0.5], 1e300)", "0.666670180061929"},
    };
    for (const auto& [call, value] : known) EXPECT_EQ(value_of(call), value) << call;
}

TEST(Expressions, RandIsSpreadEvenly) {
    const auto result =
        run("def add(n, sum) { if n == 0 { print sum / 100 } else { add(n - 1, sum + rand(n)) } }"
            "add(100, 0)");
    ASSERT_EQ(result.messages, "");
    EXPECT_NEAR(std::stod(result.printed.at(0)), 0.5, 0.1);
}

TEST(Expressions, APropertyEndsWhereTheNextNameBegins) {
    const auto result =
        run("let a = [1, 2, 3] let r = 2\n"
            "sphere { center a radius r }\n"
            "box { min (a - r) max max(a, r) }");
    ASSERT_EQ(result.messages, "");
    EXPECT_EQ(std::get<Box>(result.scene.objects.at(1).shape).max, Vec3d(2, 2, 3));
}

TEST(Expressions, AWordOrAStringChoosesOneOfAFew) {
    for (const char* spline : {"bezier", "\"bezier\"", "kind"}) {
        const auto result =
            run("let kind = \"bezier\" let linear = 3 lathe { profile [[1, 0], [2, 1], [2, 2], "
                "[1, 3]] spline " +
                std::string(spline) + " }");
        EXPECT_EQ(result.messages, "");
        EXPECT_EQ(result.scene.lathes.at(0).spline, Spline::bezier);
    }
}

// Text of a number reads back as the same number, through the whole parser.
TEST(Expressions, NumbersSurviveStrAndReading) {
    EXPECT_TRUE(rc::check([](double x) {
        if (!std::isfinite(x)) return;
        const std::string text = to_text(x);
        RC_ASSERT(value_of(text) == text);
        double back = 0;
        std::from_chars(text.data(), text.data() + text.size(), back);
        RC_ASSERT(back == x);
    }));
}

}  // namespace
}  // namespace lancer
