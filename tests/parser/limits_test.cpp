// Running into a limit is an ordinary error; nothing crashes, hangs or eats the machine.
#include <gtest/gtest.h>

#include "tests/parser/script.h"

namespace lancer {
namespace {

using test::run;

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

TEST(Limits, LongFlatChainsAreNoRecursion) {
    EXPECT_EQ(run("print 1" + repeated("+1", 200000)).printed.at(0), "200001");
    EXPECT_EQ(run("print true" + repeated("&&true", 100000)).printed.at(0), "true");
    EXPECT_EQ(run("let a = [1, 2, 3] let b = a" + repeated("\n.x", 100000)).found.size(), 1u);
    EXPECT_EQ(run("print len([" + repeated("1,", 200000) + "1])").printed.at(0), "200001");
    EXPECT_EQ(run(repeated("let a = 1\n", 1) + repeated("print a\n", 100000)).printed.size(),
              100000u);
}

class DeepText : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(DeepText, IsReadUpToTheLimitAndIsAnErrorBeyond) {
    const std::string& open = GetParam().first;
    const std::string& close = GetParam().second;
    const auto nested = [&](int depth) {
        const std::string inside = open.find('{') == std::string::npos ? "1" : "";
        const std::string start = open.find('{') == std::string::npos ? "let a = " : "";
        return run(start + repeated(open, depth) + inside + repeated(close, depth)).messages;
    };
    EXPECT_EQ(nested(500).find("the nesting is more than"), std::string::npos);
    EXPECT_NE(nested(600).find("the nesting is more than 512 levels deep"), std::string::npos);
    EXPECT_NE(nested(100000).find("the nesting is more than 512 levels deep"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    OfEachKind, DeepText,
    testing::Values(std::pair("(", ")"), std::pair("[", "]"), std::pair("-", ""),
                    std::pair("2^", ""), std::pair("true?", ":1"), std::pair("sin(", ")"),
                    std::pair("[1][", "]"), std::pair("group{", "}"), std::pair("if true{", "}"),
                    std::pair("for i in 0..1{", "}"), std::pair("def f(){", "}"),
                    std::pair("if false{}else ", "if true{}"), std::pair("sphere{", "}")));

TEST(Limits, DeepCallsWithinDeepBlocksNeedNoStack) {
    const std::string ifs = repeated("if true {", 400);
    const auto result =
        run("def f(n) {" + ifs + "if n > 0 { f(n - 1) }" + repeated("}", 400) + "} f(500)");
    EXPECT_EQ(result.messages, "");
}

TEST(Limits, RecursionWithoutEndIsOneError) {
    const auto result = run("def f() { f() f() } f()");
    EXPECT_EQ(result.found.size(), 1u);
    EXPECT_EQ(result.found.at(0).message,
              "calls and includes are nested more than 512 levels deep");
    EXPECT_EQ(result.found.at(0).notes.size(), 9u);
    EXPECT_EQ(result.found.at(0).notes.back().message, "... 504 more calls");
}

TEST(Limits, EachIsAnErrorAtItsPlace) {
    Limits limits;
    limits.statements = 1000;
    limits.list_elements = 1000;
    limits.objects = 10;
    limits.text_bytes = 1000;
    limits.source_bytes = 200;
    const auto message = [&](const std::string& text) {
        const auto result = run(text, {}, {{"long", repeated(" ", 150)}}, limits);
        return result.found.empty() ? "" : result.found.at(0).message;
    };
    EXPECT_EQ(message("for i in 0..500 { }"), "");
    EXPECT_EQ(message("for i in 0..2000 { }"), "more than 1000 statements were executed");
    EXPECT_EQ(message("let a = range(0, 2000, 1)"), "more than 1000 list elements were created");
    EXPECT_EQ(message("let a = range(0, 1e300, 1)"), "more than 1000 list elements were created");
    EXPECT_EQ(message("for i in 0..20 { sphere { radius 1 } }"),
              "the scene has more than 10 objects");
    EXPECT_EQ(message("for i in 0..20 { group { sphere { radius 1 scale 2 } } }"),
              "the scene has more than 10 objects");
    EXPECT_EQ(message("for i in 0..20 { light point { position [0, 0, 0] } }"),
              "the scene has more than 10 lights");
    EXPECT_EQ(message("for i in 0..20 { camera { position [0, 0, 1] look_at [0, 0, 0] } }"),
              "the scene has more than 10 cameras");
    EXPECT_EQ(message("for i in 0..20 { material m { } }"), "the scene has more than 10 materials");
    EXPECT_EQ(message("for i in 0..200 { print \"0123456789\" }"),
              "more than 1000 bytes of strings were created");
    EXPECT_EQ(message(repeated(" ", 300)), "the source files have more than 200 bytes");
    EXPECT_EQ(message(repeated(" ", 100) + "include \"long\""), "'long' is too long");
}

TEST(Limits, OfErrorsLeavesTheRestOut) {
    Limits limits;
    limits.errors = 3;
    const auto result = run(repeated("sphere { raduis 1 }\n", 5), {}, {}, limits);
    ASSERT_EQ(result.found.size(), 4u);
    EXPECT_EQ(result.found.back().message,
              "there are more than 3 errors: the others are not shown");
}

TEST(Limits, ListsThatShareTheirPartsDoNotExplode) {
    Limits limits;
    limits.list_elements = 1'000'000;
    const auto result =
        run("def twice(a, b, n) { if n > 0 { twice([a, a], [b, b], n - 1) } else { print a == b } }"
            "twice([1, \"x\"], [1, \"x\"], 60)",
            {}, {}, limits);
    ASSERT_EQ(result.found.size(), 1u);
    EXPECT_EQ(result.found.at(0).message, "more than 1000000 list elements were created");
}

}  // namespace
}  // namespace lancer
