// Functions of the script: `func name(parameters) = value`.
#include <gtest/gtest.h>

#include "tests/parser/script.h"

namespace lancer {
namespace {

using test::run;

/// What `print` says about an expression behind some definitions.
std::string value(const std::string& definitions, const std::string& expression) {
    const auto result = run(definitions + "\nprint " + expression);
    EXPECT_EQ(result.messages, "");
    return result.printed.empty() ? "" : result.printed.back();
}

TEST(Functions, HaveTheValueOfTheirExpression) {
    EXPECT_EQ(value("func f(x) = x * x + 1", "f(3) + f(f(1))"), "15");
    EXPECT_EQ(value("func f() = [1, \"a\", true]", "f()[1] + str(len(f()))"), "a3");
    EXPECT_EQ(value("func f(x) = x > 0 && x < 2", "f(1) ? \"in\" : \"out\""), "in");
}

TEST(Functions, TakeArgumentsByPlaceThenByName) {
    const std::string f = "func f(a, b = a + 1, c = a * b) = [a, b, c, 0]";
    EXPECT_EQ(value(f, "[f(2), f(2, 5), f(2, 5, 7)]"),
              "[[2, 3, 6, 0], [2, 5, 10, 0], [2, 5, 7, 0]]");
    EXPECT_EQ(value(f, "f(c: 1, a: 4)"), "[4, 5, 1, 0]");
    EXPECT_EQ(value(f, "f(4, c: f(1, b: f(3)[0])[2])"), "[4, 5, 3, 0]");
    EXPECT_EQ(value(f, "max(f(1)[2], f(b: 1, a: f(a: 2)[1])[0])"), "3");
}

TEST(Functions, CallThemselvesAndThoseBefore) {
    EXPECT_EQ(value("func fact(n) = n < 2 ? 1 : n * fact(n - 1)", "fact(10)"), "3628800");
    EXPECT_EQ(value("func a(n) = n + 1 func b(n, m = a(n)) = n < 3 ? b(n + 1) : m", "b(0)"), "4");
    // As deep as the limit allows, without depth on the program's own stack.
    EXPECT_EQ(value("func d(n) = n == 0 ? 0 : 1 + d(n - 1)", "d(511)"), "511");
    Limits deep;
    deep.calls = 3'000'000;
    const auto result = run("func d(n) = n == 0 ? 0 : 1 + d(n - 1) print d(200001)", {}, {}, deep);
    ASSERT_EQ(result.messages, "");
    EXPECT_EQ(result.printed.at(0), "200001");
}

TEST(Functions, SeeTheNamesOfThePlaceWhereTheyWereWritten) {
    EXPECT_EQ(value("let k = 2 func f(x) = x * k", "f(1)"), "2");
    EXPECT_EQ(run("let k = 2 func f(x) = x * k if true { let k = 9 print f(1) }").printed.at(0),
              "2");
    const auto later = run("func f(x) = x * k let k = 2 print f(1)");
    EXPECT_NE(later.messages.find("'k' is not defined"), std::string::npos) << later.messages;
    const auto inner = run("def t(m) { func f(x) = x * m print f(5) } t(2) t(3)");
    EXPECT_EQ(inner.messages, "");
    EXPECT_EQ(inner.printed, (std::vector<std::string>{"10", "15"}));
    const auto included =
        run("include \"f\" print f(2)", {}, {{"f", "let k = 3 func f(x) = x * k"}});
    EXPECT_EQ(included.printed.at(0), "6");
}

TEST(Functions, StandWhereverAValueDoes) {
    const auto result =
        run("func r(i) = 1 + i / 2 func n() = 2 def ball(s) { sphere { radius s } }\n"
            "for i in n()..r(4) { if r(i) == 2 { ball(r(i)) } }");
    EXPECT_EQ(result.messages, "");
    EXPECT_EQ(result.scene.objects.size(), 1u);
    const auto params = run("param k = 1 func f(x) = x print f(k)", {{{"k", "max(2, 7)"}}, {}, {}});
    EXPECT_EQ(params.printed.at(0), "7");
}

TEST(Functions, OfTheScriptHideThoseOfTheLanguageWithAWarning) {
    const auto result = run("print min(2, 1) func min(a, b) = 7 print min(2, 1)");
    EXPECT_EQ(result.printed, (std::vector<std::string>{"1", "7"}));
    ASSERT_EQ(result.found.size(), 1u);
    EXPECT_EQ(result.found.at(0).severity, Severity::warning);
}

TEST(Functions, AMistakeInOneIsSaidOnceWithTheCallsThatLedThere) {
    const auto result = run("func f(x) = sqrt(x) func g(x) = f(x) + 1 let a = g(-1) let b = g(-2)");
    ASSERT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_EQ(result.found.at(0).message, "'sqrt' is not defined for -1");
    ASSERT_EQ(result.found.at(0).notes.size(), 2u);
    EXPECT_EQ(result.found.at(0).notes.at(1).message, "called here, 'g'");
}

TEST(Functions, OfABrokenArgumentSaysNothingMore) {
    const auto result = run("func f(x) = sqrt(x) let a = f(nothing) let b = f(x: nothing) + 1");
    EXPECT_EQ(result.found.size(), 2u) << result.messages;
}

TEST(Functions, GoOnAfterAConditionThatIsNone) {
    const auto result =
        run("func f(x, y = 1) = x ? 1 : 2 let a = [f(1, y: 3), f(2)] func g(z) = z print g(z: 4)");
    EXPECT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_EQ(result.printed.at(0), "4");
}

TEST(Functions, EndWhenTheyCallThemselvesForEver) {
    for (const char* text :
         {"func f(n) = f(n + 1) print f(0)", "func f(n, m = f(n)) = n print f(0)",
          "func f(n) = n def t(n) { t(f(n)) } t(0)"}) {
        const auto result = run(text);
        ASSERT_EQ(result.found.size(), 1u) << result.messages;
    }
    const auto endless = run("func f(n, m = f(n)) = n print f(0)");
    EXPECT_EQ(endless.found.at(0).message,
              "calls and includes are nested more than 512 levels deep");
    EXPECT_EQ(endless.found.at(0).notes.size(), 9u);
    Limits limits;
    limits.statements = 1000;
    const auto result =
        run("func f(n) = n == 0 ? 0 : f(n - 1) + f(n - 1) print f(100)", {}, {}, limits);
    ASSERT_EQ(result.found.size(), 1u);
    EXPECT_EQ(result.found.at(0).message, "more than 1000 statements were executed");
}

TEST(Functions, ThatNobodyCallsAreCheckedForNames) {
    const auto result = run("func f(x, y = w) = x + z func g(x) = x print g(1)");
    ASSERT_EQ(result.found.size(), 2u) << result.messages;
    EXPECT_EQ(result.found.at(0).message, "'w' is not defined");
    EXPECT_EQ(result.found.at(1).message, "'z' is not defined");
}

}  // namespace
}  // namespace lancer
