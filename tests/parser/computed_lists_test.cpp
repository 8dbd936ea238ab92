// Lists that are computed, and the functions of lists.
#include <gtest/gtest.h>

#include "tests/parser/script.h"

namespace lancer {
namespace {

using test::run;
using test::value_of;

std::string message_of(const std::string& text, const Limits& limits = {}) {
    const auto result = run(text, {}, {}, limits);
    return result.found.empty() ? "" : result.found.at(0).message;
}

TEST(ComputedLists, RunOverRangesAndLists) {
    EXPECT_EQ(value_of("[for i in 0..5: i * i]"), "[0, 1, 4, 9, 16]");
    EXPECT_EQ(value_of("[for i in 2..2: i]"), "[]");
    EXPECT_EQ(value_of("[for i in 3..-1: i]"), "[]");
    EXPECT_EQ(value_of("[for i in -1..2: i]"), "[-1, 0, 1]");
    EXPECT_EQ(value_of("[for x in [\"a\", [1, 2], true]: x]"), "[\"a\", [1, 2], true]");
    EXPECT_EQ(value_of("[for x in range(1, 0, -0.25): x * 4]"), "[4, 3, 2, 1]");
    EXPECT_EQ(value_of("[for x in []: x]"), "[]");
}

TEST(ComputedLists, TheLastForRunsFastestAndSeesTheOthers) {
    EXPECT_EQ(value_of("[for i in 0..2 for j in 0..3: i * 10 + j]"), "[0, 1, 2, 10, 11, 12]");
    EXPECT_EQ(value_of("[for x in [[1, 2], [3], []] for y in x: y]"), "[1, 2, 3]");
    EXPECT_EQ(value_of("[for i in 0..4 for j in 0..i for k in j..i: i + j + k]"),
              "[1, 2, 3, 4, 3, 4, 5, 5, 6, 7]");
}

TEST(ComputedLists, ConditionsLeaveElementsOut) {
    EXPECT_EQ(value_of("[for i in 0..10 if i % 3 == 0: i]"), "[0, 3, 6, 9]");
    EXPECT_EQ(value_of("[for i in 0..10 if i > 2 if i < 5: i]"), "[3, 4]");
    EXPECT_EQ(value_of("[for i in 0..4 if i != 2 for j in 0..2 if i != j: [i, j]]"),
              "[[0, 1], [1, 0], [3, 0], [3, 1]]");
}

TEST(ComputedLists, StandBesideElementsAndWithinEachOther) {
    EXPECT_EQ(value_of("[9, for i in 0..3: i, 8, for i in 0..0: i, for c in [7]: c, \"x\"]"),
              "[9, 0, 1, 2, 8, 7, \"x\"]");
    EXPECT_EQ(value_of("[for i in 0..3: [for j in 0..i: j + i]]"), "[[], [1], [2, 3]]");
    EXPECT_EQ(value_of("[for i in [for k in 0..3: k + 1]: [0, for k in 0..i: k][i - 1]]"),
              "[0, 0, 1]");
    EXPECT_EQ(value_of("len([for i in 0..9: i]) + [for i in 0..3: i + 1].z"), "12");
    EXPECT_EQ(value_of("[for i in 0..3: i] + [1, 1, 1] * 2"), "[2, 3, 4]");
    EXPECT_EQ(value_of("[for i in 0..2: i == 0 ? \"none\" : str(i)]"), "[\"none\", \"1\"]");
}

TEST(ComputedLists, HideNamesOfOutsideAndGiveThemBack) {
    const auto result =
        run("let i = 7 func f(x) = [for i in 0..x: i + x] print [for i in 0..2: f(i + 1)], i, f(1)"
            " def t(i) { print [for i in 0..i: i], i } t(2)");
    EXPECT_EQ(result.messages, "");
    EXPECT_EQ(result.printed, (std::vector<std::string>{"[[1], [2, 3]] 7 [1]", "[0, 1] 2"}));
    EXPECT_NE(run("print [for i in 0..2: i][0] + i").messages.find("'i' is not defined"),
              std::string::npos);
}

TEST(ComputedLists, SurviveAConditionThatIsNoneAndGoOn) {
    const auto result = run(
        "func f(x) = [for i in 0..3: [for j in 0..2: j ? 1 : 2]] let a = [1, for k in 0..2: f(k)]"
        " let k = 4 print [for i in 0..2: i + k]");
    EXPECT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_EQ(result.printed.at(0), "[4, 5]");
}

TEST(ComputedLists, AreConstantExpressionsOfTheCommandLine) {
    const auto result =
        run("param k = [] print k", {{{"k", "[for i in 0..3 if i != 1: i]"}}, {}, {}});
    EXPECT_EQ(result.usage, "");
    EXPECT_EQ(result.printed.at(0), "[0, 2]");
}

TEST(ComputedLists, ThatNothingReachesAreCheckedForNames) {
    const auto result = run("def t() { print [for i in 0..3: i + j] }");
    ASSERT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_EQ(result.found.at(0).message, "'j' is not defined");
}

TEST(ComputedLists, AreBounded) {
    Limits limits;
    limits.statements = 1000;
    EXPECT_EQ(message_of("let a = [for i in 0..900: i]", limits), "");
    EXPECT_EQ(message_of("let a = [for i in 0..1e15: i]", limits),
              "more than 1000 statements were executed");
    EXPECT_EQ(message_of("let a = [for i in 0..1000 if false: i]", limits),
              "more than 1000 statements were executed");
    limits = {};
    limits.list_elements = 1000;
    EXPECT_EQ(message_of("let a = [for i in 0..1e15: i]", limits),
              "more than 1000 list elements were created");
    EXPECT_EQ(message_of("let a = range(0, 600, 1) let b = concat(a, a)", limits),
              "more than 1000 list elements were created");
    EXPECT_EQ(message_of("let a = range(0, 600, 1) let b = sum(a)", limits),
              "more than 1000 list elements were created");
    limits = {};
    limits.nesting = 20;
    EXPECT_EQ(
        message_of("func f(n) = n == 0 ? 0 : [for i in 0..1: f(n - 1)] let a = f(30)", limits),
        "lists are nested more than 20 levels deep");
}

TEST(ComputedLists, HoldNoMoreThanIsAllowedAtOneTime) {
    Limits limits;
    limits.held_bytes = 1'000'000;
    const std::string message = "lists take more than 1000000 bytes at one time";
    EXPECT_EQ(message_of("let a = [for i in 0..1000000: i]", limits), message);
    EXPECT_EQ(message_of("let a = [for i in 0..1000000: []]", limits), message);
    EXPECT_EQ(message_of("let a = [for i in 0..1000000: str(i)]", limits), message);
    EXPECT_EQ(message_of("let a = [for i in 0..1000000: \"abc\"[i % 3]]", limits), message);
    EXPECT_EQ(
        message_of("func f(n) = n == 0 ? [\"a\"] : [f(n - 1), f(n - 1)] let a = f(20)", limits),
        message);
    EXPECT_EQ(
        message_of("func f(l, n) = n == 0 ? l : f(concat(l, l), n - 1) let a = f([1], 30)", limits),
        message);
    // Freed values do not count.
    EXPECT_EQ(message_of("for i in 0..1000 { let a = [for i in 0..1000: [i, i]] }", limits), "");
}

TEST(ListFunctions, MakeListsOfLists) {
    EXPECT_EQ(value_of("concat([1, 2], [], [\"a\"], range(0, 4, 1))"), "[1, 2, \"a\", 0, 1, 2, 3]");
    EXPECT_EQ(value_of("concat([1], [2, 3]) * 2"), "[2, 4, 6]");
    EXPECT_EQ(value_of("reverse([1, \"b\", [3]])"), "[[3], \"b\", 1]");
    EXPECT_EQ(value_of("reverse(range(0, 5, 1))"), "[4, 3, 2, 1, 0]");
    EXPECT_EQ(value_of("slice([1, 2, 3, 4, 5], 1, 3)"), "[2, 3]");
    EXPECT_EQ(value_of("slice([1, 2, 3, 4, 5], 3)"), "[4, 5]");
    EXPECT_EQ(value_of("slice([1, 2], 2)"), "[]");
    EXPECT_EQ(value_of("last([1, 2, 7])"), "7");
}

TEST(ListFunctions, SumCarriesRoundingErrorsAlong) {
    EXPECT_EQ(value_of("sum([])"), "0");
    EXPECT_EQ(value_of("sum([1e100, 1, -1e100, 1])"), "2");
    EXPECT_EQ(value_of("sum([for i in 0..10: 0.1])"), "1");
    EXPECT_EQ(value_of("sum([for i in 0..4: [i, 1]])"), "[6, 4]");
    EXPECT_EQ(value_of("sum([[1, 2, 3], [4, 5, 6]])"), "[5, 7, 9]");
}

TEST(ListFunctions, CharactersAreCountedAsLenCountsThem) {
    EXPECT_EQ(value_of("\"abc\"[1] + \"a\"[0]"), "ba");
    EXPECT_EQ(value_of("\"\xce\xb1\xce\xb2x\xe2\x82\xac\"[3]"), "\xe2\x82\xac");
    EXPECT_EQ(value_of("\"\xce\xb1\xce\xb2x\"[1]"), "\xce\xb2");
    EXPECT_EQ(value_of("slice(\"\xce\xb1\xce\xb2x\", 1)"), "\xce\xb2x");
    EXPECT_EQ(value_of("slice(\"abc\", 0, 0)"), "");
    EXPECT_EQ(value_of("last(\"x\xce\xb2\")"), "\xce\xb2");
    EXPECT_EQ(value_of("[for i in 0..len(\"abc\"): \"abc\"[i]]"), "[\"a\", \"b\", \"c\"]");
}

}  // namespace
}  // namespace lancer
