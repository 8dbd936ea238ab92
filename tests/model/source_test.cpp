#include "model/source.h"

#include <gtest/gtest.h>

#include "model/diagnostic.h"
#include "model/elementary.h"
#include "model/utf8.h"

namespace lancer {
namespace {

TEST(SourceMap, LocatesLinesAfterLfAndCrlf) {
    SourceMap sources;
    const std::uint32_t file = sources.add("t.lancer", "one\r\ntwo\nthree");
    EXPECT_EQ(sources.locate({file, 0, 1}).line, 1u);
    EXPECT_EQ(sources.locate({file, 5, 1}).line, 2u);
    EXPECT_EQ(sources.locate({file, 11, 1}).line, 3u);
    EXPECT_EQ(sources.locate({file, 11, 1}).column, 3u);
    EXPECT_EQ(sources.line_text({file, 1, 1}), "one");
    EXPECT_EQ(sources.line_text({file, 11, 1}), "three");
}

TEST(SourceMap, ACarriageReturnAloneEndsALine) {
    SourceMap sources;
    const std::uint32_t file = sources.add("t.lancer", "one\rtwo\r\rfour\r\nfive\n\rseven");
    const auto line_of = [&](std::uint32_t offset) {
        return sources.locate({file, offset, 1}).line;
    };
    EXPECT_EQ(line_of(3), 1u);
    EXPECT_EQ(line_of(4), 2u);
    EXPECT_EQ(line_of(8), 3u);
    EXPECT_EQ(line_of(9), 4u);
    EXPECT_EQ(line_of(15), 5u);
    EXPECT_EQ(line_of(21), 7u);
    EXPECT_EQ(sources.line_text({file, 5, 1}), "two");
    EXPECT_EQ(sources.line_text({file, 8, 1}), "");
    EXPECT_EQ(sources.line_text({file, 10, 1}), "four");
}

TEST(Diagnostic, StaysOnItsLineWhateverANameHolds) {
    SourceMap sources;
    const std::uint32_t file = sources.add("a\nb\x1b[2J.lancer", "sphere");
    const std::string text = format(
        {Severity::error, {file, 0, 1}, "no 'maps\new\t\x7f\x9b\xc2\x9b'", "\xe2\x80\xae!\r", {}},
        sources);
    EXPECT_EQ(text,
              "a\\nb\\x1b[2J.lancer:1:1: error: no 'maps\\new\\t\\x7f\\x9b\\u009b'\n"
              "    sphere\n"
              "    ^\n"
              "    hint: \\u202e!\\x0d\n");
    EXPECT_EQ(printable("gr\xc3\xbcn C:\\maps"), "gr\xc3\xbcn C:\\maps");
}

TEST(Diagnostic, QuotesTheLineWithACaretAndKeepsTabs) {
    SourceMap sources;
    const std::uint32_t file = sources.add("t.lancer", "sphere {\n\traduis 2\n}\n");
    EXPECT_EQ(
        format({Severity::error, {file, 10, 6}, "sphere has no property 'raduis'", "radius?", {}},
               sources),
        "t.lancer:2:2: error: sphere has no property 'raduis'\n"
        "    \traduis 2\n"
        "    \t^~~~~~\n"
        "    hint: radius?\n");
}

TEST(Diagnostic, CropsALongLineAroundTheCaret) {
    SourceMap sources;
    const std::uint32_t file =
        sources.add("t", std::string(5000, 'a') + "X" + std::string(5000, 'b'));
    const std::string text = format({Severity::warning, {file, 5000, 1}, "m", "", {}}, sources);
    EXPECT_LT(text.size(), 400u);
    EXPECT_NE(text.find("...a"), std::string::npos);
    EXPECT_NE(text.find("aX"), std::string::npos);
}

TEST(Elementary, QuarterTurnsAreExact) {
    for (int quarter = -8; quarter <= 8; ++quarter) {
        const auto [sine, cosine] = elementary::sine_cosine_of_degrees(90.0 * quarter);
        const int k = ((quarter % 4) + 4) % 4;
        EXPECT_EQ(sine, (k == 1) - (k == 3));
        EXPECT_EQ(cosine, (k == 0) - (k == 2));
    }
}

}  // namespace
}  // namespace lancer
