#include <gtest/gtest.h>

#include "tests/parser/script.h"

namespace lancer {
namespace {

using test::run;

std::vector<std::string> printed(const std::string& text,
                                 const std::map<std::string, std::string>& files = {}) {
    const auto result = run(text, {}, files);
    EXPECT_EQ(result.messages, "");
    return result.printed;
}
using Lines = std::vector<std::string>;

TEST(Statements, AnInnerScopeHidesAndTheOuterComesBack) {
    EXPECT_EQ(printed("let a = 1 if true { let a = 2 print a } print a"), (Lines{"2", "1"}));
}

TEST(Statements, ATemplateSeesTheNamesOfThePlaceWhereItWasWritten) {
    EXPECT_EQ(printed("let a = 1 def show() { print a } group { let a = 2 show() }"), (Lines{"1"}));
    const auto later = run("def show() { print b } let b = 1 show()");
    EXPECT_NE(later.messages.find("'b' is not defined"), std::string::npos) << later.messages;
}

TEST(Statements, ATemplateMayCallItself) {
    EXPECT_EQ(printed("def down(n) { print n if n > 0 { down(n - 1) } } down(2)"),
              (Lines{"2", "1", "0"}));
}

TEST(Statements, ATemplateWithinATemplateSeesItsParameters) {
    EXPECT_EQ(printed("def outer(a) { let b = a * 2 def inner(c) { print a, b, c } inner(b + 1) }"
                      "outer(1) outer(2)"),
              (Lines{"1 2 3", "2 4 5"}));
}

TEST(Statements, DefaultsAreEvaluatedAtTheCallAndMayUseEarlierParameters) {
    EXPECT_EQ(printed("def f(a, b = a + 1, c = b * 2) { print a, b, c } f(1) f(1, c: 0) f(1, 5)"),
              (Lines{"1 2 4", "1 2 0", "1 5 10"}));
}

TEST(Statements, CallsLookForTemplatesAndFunctionsOnly) {
    EXPECT_EQ(printed("material floor { } let max = 3 print floor(2.5), max(1, 2), max"),
              (Lines{"2 2 3"}));
}

TEST(Statements, MaterialsAndTexturesCanBePassed) {
    const auto result =
        run("material red { color [1, 0, 0] } def ball(m) { sphere { radius 1 material m } }"
            "texture t { checker [[1, 1, 1], [0, 0, 0]] }"
            "def painted(c) { sphere { radius 1 material { color c } } } ball(red) painted(t)");
    EXPECT_EQ(result.messages, "");
    EXPECT_EQ(result.scene.materials.at(result.scene.objects.at(0).material).color, Color(1, 0, 0));
    EXPECT_EQ(result.scene.materials.at(result.scene.objects.at(1).material).texture, 0u);
}

TEST(Statements, LoopsRunOverRangesAndLists) {
    EXPECT_EQ(printed("for i in 0..3 { print i }"), (Lines{"0", "1", "2"}));
    EXPECT_EQ(printed("for i in 3..3 { print i } for i in 5..-1 { print i }"), (Lines{}));
    EXPECT_EQ(printed("let n = 2 for i in n - 1..n * 2 { print i }"), (Lines{"1", "2", "3"}));
    EXPECT_EQ(printed("for p in [[1, 2], \"a\"] { print p }"), (Lines{"[1, 2]", "a"}));
    EXPECT_EQ(printed("for x in range(1, 0, -0.5) { print x }"), (Lines{"1", "0.5"}));
}

TEST(Statements, IfTakesTheFirstThatHolds) {
    EXPECT_EQ(printed("for i in 0..3 { if i == 0 { print \"a\" } else if i == 1 { print \"b\" } "
                      "else { print \"c\" } }"),
              (Lines{"a", "b", "c"}));
}

TEST(Statements, AnIncludeStandsForItsTextOnceAndOnlyOnce) {
    const std::map<std::string, std::string> files{
        {"lib/a.lancer", "include \"b.lancer\" let a = b"},
        {"lib/b.lancer", "let b = 7 print \"b\""}};
    EXPECT_EQ(printed("include \"lib/a.lancer\" include \"lib/b.lancer\" print a", files),
              (Lines{"b", "7"}));
}

TEST(Statements, AGroupsPropertyMayStandInAnIf) {
    const auto result = run("group { sphere { radius 1 } if true { scale 2 } }");
    EXPECT_EQ(result.messages, "");
    EXPECT_EQ(map_vector(result.scene.transforms.at(1), Vec3d(1, 0, 0)), Vec3d(2, 0, 0));
}

TEST(Statements, ByteOrderMarkCrLfAndCommentsAreBlanks) {
    EXPECT_EQ(printed("\xEF\xBB\xBFlet a = 1 // one\r\n/* two\r\n */ print a\r\n"), (Lines{"1"}));
}

TEST(Statements, ACarriageReturnAloneEndsACommentAndALine) {
    const auto result =
        run("camera { position [0, 1, 5] look_at [0, 0, 0] }   // the view\r"
            "light point { position [1, 2, 3] }\rsphere { raduis 1 }\r");
    EXPECT_EQ(result.messages,
              "main.lancer:3:10: error: 'raduis' is not a property of a sphere\n"
              "    sphere { raduis 1 }\n"
              "             ^~~~~~\n"
              "    hint: did you mean 'radius'?\n");
    EXPECT_EQ(run("let a = \"x\rprint a").found.size(), 1u);  // a string ends on its line
}

TEST(Statements, WordsOfOtherLanguagesAreNamesLikeOthers) {
    const auto result =
        run("def while(n) { sphere { radius n } } while(2)\n"
            "let rgb = [[1, 0, 0], [0, 1, 0]] let red = 3 let mm = 2\n"
            "sphere { radius 1 material { color rgb[0] } }\n"
            "sphere { radius 1 capped_or_not 2 }\n");
    EXPECT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_EQ(run("let rgb = 2 sphere { radius rgb < 1 ? 1 : 2 }").messages, "");
    EXPECT_EQ(run("let not = true if not { sphere { radius 1 } }").messages, "");
}

TEST(Statements, AnAssignmentInALoopChangesNothingButIsAnError) {
    const auto result = run("let n = 1\nfor i in 0..3 {\n  n = n + i\n  sphere { radius n }\n}\n");
    ASSERT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_NE(
        result.messages.find("3:3: error: 'n' already has a value, and a value cannot be changed"),
        std::string::npos)
        << result.messages;
    EXPECT_NE(result.messages.find("main.lancer:1:5: note: first here"), std::string::npos);
}

TEST(Definitions, ReplaceParamsByAnyConstantExpression) {
    const auto result =
        run("param level = 3 print level", {{{"level", "2 * sin(pi / 2)"}}, {}, {}});
    EXPECT_EQ(result.messages + result.usage, "");
    EXPECT_EQ(result.printed, (Lines{"2"}));
}

TEST(Definitions, OfUnknownParamsAreWrongUseWithAHint) {
    const auto result = run("param level = 3", {{{"levle", "2"}}, {}, {}});
    EXPECT_EQ(result.usage,
              "lancer: error: -D levle: the scene has no param of this name\n"
              "    hint: did you mean 'level'?\n");
}

TEST(Definitions, WithAMistakeAreWrongUse) {
    const auto broken = run("param level = 3", {{{"level", "2 +"}}, {}, {}});
    EXPECT_NE(broken.usage.find("-D level:1:4: error: expected an expression"), std::string::npos)
        << broken.usage;
    const auto more = run("param level = 3", {{{"level", "2 3"}}, {}, {}});
    EXPECT_NE(more.usage.find("expected the end after the value, found '3'"), std::string::npos)
        << more.usage;
    const auto unknown = run("param level = 3", {{{"level", "x"}}, {}, {}});
    EXPECT_NE(unknown.usage.find("'x' is not defined"), std::string::npos) << unknown.usage;
}

TEST(Definitions, FrameAndTimeAreZeroWithoutAnAnimation) {
    EXPECT_EQ(printed("print frame, time"), (Lines{"0 0"}));
    const auto result = run("param time = 0.5 print frame, time", {{}, 3, 0.25});
    EXPECT_EQ(result.printed, (Lines{"3 0.25"}));
    EXPECT_EQ(printed("param time = 0.5 print time"), (Lines{"0.5"}));
}

}  // namespace
}  // namespace lancer
