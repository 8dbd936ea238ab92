#include "cli/output_names.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "cli/session.h"

namespace lancer::cli {
namespace {

TEST(OutputNames, ThePictureIsCalledLikeTheScene) {
    EXPECT_EQ(default_output("scenes/gallery/tower.lancer"), "tower.png");
    EXPECT_EQ(default_output("tower"), "tower.png");
    EXPECT_EQ(default_output("../a.b.lancer"), "a.b.png");
    EXPECT_EQ(default_output("-"), "stdin.png");
    EXPECT_EQ(default_output("../a.b.lancer", true), "a.b-preview.png");
    EXPECT_EQ(default_output("-", true), "stdin-preview.png");
}

TEST(OutputNames, APatternIsFilledAsPrintfWould) {
    for (const char* pattern :
         {"out-%d.png", "out-%04d.png", "%4d.png", "a%%b%03d.exr", "%09d", "folder.d/x%d"}) {
        for (const int frame : {0, 7, -7, 12345, -12345}) {
            char expected[64];
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
            std::snprintf(expected, sizeof expected, pattern, frame);
#pragma GCC diagnostic pop
            EXPECT_EQ(FrameNames(pattern).name(frame), expected) << pattern << " " << frame;
        }
    }
}

TEST(OutputNames, WithoutAPatternTheNumberStandsBeforeTheEnding) {
    EXPECT_EQ(FrameNames("out.png").name(7), "out-0007.png");
    EXPECT_EQ(FrameNames("folder.x/out.png").name(12345), "folder.x/out-12345.png");
    EXPECT_EQ(FrameNames("100%%.png").name(1), "100%-0001.png");
}

TEST(OutputNames, AnythingElseThatPrintfKnowsIsRefused) {
    for (const char* wrong :
         {"%s.png", "%n.png", "%d%d.png", "%.3d.png", "%-4d.png", "%+d.png", "%ld.png", "%1$d.png",
          "%x.png", "%", "out%", "%04", "%99999999999d.png", "%21d.png", "%*d.png"})
        EXPECT_THROW(FrameNames{wrong}, UsageError) << wrong;
}

}  // namespace
}  // namespace lancer::cli
