#include "parser/grammar.h"

#include <gtest/gtest.h>

#include <tao/pegtl/contrib/analyze.hpp>

#include "model/utf8.h"
#include "parser/css_colors.h"
#include "parser/suggest.h"
#include "tests/parser/script.h"

namespace lancer {
namespace {

TEST(Grammar, HasNoRuleThatCanLoopWithoutReading) {
    EXPECT_EQ(tao::pegtl::analyze<grammar::file>(1), 0u);
    EXPECT_EQ(tao::pegtl::analyze<grammar::lone_expression>(1), 0u);
}

TEST(Recovery, GoesOnAtTheNextStatementOfTheSameDepth) {
    const auto result = test::run(
        "group {\n"
        "  sphere { center [0, 1 radius 2 }\n"
        "  let a = (1 +\n"
        "  box { min [0, 0, 0] max [1, 1, 1 }\n"
        "  cone { base } \n"
        "}\n"
        "sphere { raduis 1 }\n");
    EXPECT_EQ(result.found.size(), 5u) << result.messages;
}

TEST(Recovery, WhatABrokenStatementDeclaresCountsAsDeclared) {
    const auto result = test::run(
        "let a = (1\nmaterial red { color [1 }\ndef f(x { }\nsphere { radius a material red }\n"
        "f(1)\n");
    EXPECT_EQ(result.found.size(), 3u) << result.messages;
}

TEST(Recovery, AMistakeInALoopIsReportedOnce) {
    EXPECT_EQ(test::run("for i in 0..10 { sphere { radius -1 } }").found.size(), 1u);
}

TEST(Unreached, CodeIsCheckedAsFarAsItShows) {
    const auto result = test::run(
        "def never(x) { sphere { radius x colr 3 } lathe { profile x spline linear } other(x)"
        " if y { } }\n"
        "if false { box { min [0, 0, 0] } } \n");
    EXPECT_EQ(result.found.size(), 4u) << result.messages;
}

TEST(Suggestion, TakesTheNearestWordAndOnlyANearOne) {
    Suggestion radius("raduis");
    for (const char* word : {"radius", "roughness", "rotate"}) radius.consider(word);
    EXPECT_EQ(radius.word(), "radius");
    Suggestion none("x");
    for (const char* word : {"pi", "y", "max"}) none.consider(word);
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(edit_distance("abcd", "abdc", 9), 1u);
    EXPECT_EQ(edit_distance("sphere", "Spheres", 9), 1u);
    EXPECT_EQ(edit_distance("abc", "xyz", 2), 3u);
}

/// Most words are ruled out by their letters alone.
TEST(Suggestion, LeavesNoNearWordOut) {
    for (const CssColor& written : css_colors()) {
        for (const CssColor& known : css_colors()) {
            if (written.name == known.name) continue;
            const std::size_t distance = edit_distance(written.name, known.name, 99);
            Suggestion suggestion(written.name);
            suggestion.consider(known.name);
            EXPECT_EQ(!suggestion.empty(),
                      distance <= (written.name.size() + 1) / 3 && distance < known.name.size())
                << written.name << ' ' << known.name;
        }
    }
    const std::string longer(150, 'a');
    EXPECT_EQ(edit_distance(longer + "b", longer + "c", 9), 1u);
}

TEST(Utf8, FindsTheFirstByteThatIsNone) {
    constexpr auto npos = std::string_view::npos;
    EXPECT_EQ(find_invalid_utf8("plain text, long enough for eight at once"), npos);
    EXPECT_EQ(find_invalid_utf8("gr\xC3\xBCn \xE2\x82\xAC \xF0\x9F\x98\x80"), npos);
    EXPECT_EQ(find_invalid_utf8("ab\xC0\x80"), 2u);          // overlong
    EXPECT_EQ(find_invalid_utf8("ab\xED\xA0\x80"), 2u);      // a surrogate
    EXPECT_EQ(find_invalid_utf8("ab\xF4\x90\x80\x80"), 2u);  // above U+10FFFF
    EXPECT_EQ(find_invalid_utf8("0123456789\xE2\x82"), 10u);
    EXPECT_EQ(find_invalid_utf8(std::string_view("abc\0d", 5)), 3u);
}

}  // namespace
}  // namespace lancer
