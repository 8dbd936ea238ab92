// A warning about composites of which nothing is left.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/parser/script.h"

namespace lancer {
namespace {

/// Replaces CUBE, BALL and RING by the opening of a block of that shape with size 1.
bool is_empty(std::string script) {
    for (const auto& [word, block] :
         {std::pair("CUBE", "box { min [-1, -1, -1] max [1, 1, 1]"),
          std::pair("BALL", "sphere { radius 1"), std::pair("RING", "torus { radius 1 tube 0.5"),
          std::pair("FLOOR", "plane { normal [0, 1, 0]")})
        for (std::size_t at; (at = script.find(word)) != std::string::npos;)
            script.replace(at, std::string_view(word).size(), block);
    const auto result = test::run(script);
    for (const Diagnostic& d : result.found)
        EXPECT_EQ(d.message, "nothing is left of this body") << script;
    EXPECT_LE(result.found.size(), 1u) << script;
    return !result.found.empty();
}

TEST(EmptyBody, IsAWarningWithItsNameAtItsPlace) {
    const auto result =
        test::run("difference {\n  name \"ring\"\n  sphere { radius 1 }\n  sphere { radius 2 }\n}");
    ASSERT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_EQ(result.found[0].message, "nothing is left of this body 'ring'");
    EXPECT_THAT(result.found[0].hint, testing::HasSubstr("first part minus all others"));
    EXPECT_THAT(result.messages, testing::HasSubstr(":1:1: warning"));
}

TEST(EmptyBody, IsADifferenceWhoseCutterHoldsAll) {
    EXPECT_TRUE(is_empty("difference { CUBE } CUBE } }")) << "equal";
    EXPECT_TRUE(is_empty(
        "difference { CUBE scale 0.5 } cylinder { base [0, -1, 0] top [0, 1, 0] radius 1 } }"));
    EXPECT_TRUE(is_empty("difference { RING } FLOOR offset 1 } }"));
    EXPECT_TRUE(is_empty("difference { RING rotate_x 20 } RING rotate_x 20 } }"));
    EXPECT_TRUE(
        is_empty("difference { BALL } union { CUBE translate [9, 0, 0] } CUBE scale 2 } } }"));
    EXPECT_TRUE(is_empty("difference { intersection { CUBE } BALL } } sphere { radius 2 } }"));
    EXPECT_TRUE(
        is_empty("difference { CUBE scale 0.1 } cone { base [0, -1, 0] top [0, 1, 0] base_radius 1 "
                 "} rotate_z 30 }"));
    EXPECT_TRUE(
        is_empty("difference { cylinder { base [0, 0, 0] top [0, 1, 0] radius 0.5 } cylinder { "
                 "base [0, 0, 0] top [0, 1, 0] radius 1 } }"));
    EXPECT_FALSE(is_empty("difference { CUBE } sphere { radius 1.7 } }")) << "corners stay";
    EXPECT_FALSE(is_empty("difference { RING rotate_x 20 } RING rotate_x 21 } }"));
    EXPECT_FALSE(is_empty("difference { sphere { radius 2 } BALL } }"));
    EXPECT_FALSE(is_empty("difference { FLOOR } CUBE } }")) << "half of space";
    EXPECT_FALSE(is_empty("difference { BALL } difference { CUBE scale 2 } BALL } } }"));
}

TEST(EmptyBody, IsAnIntersectionOfWhatDoesNotMeet) {
    EXPECT_TRUE(is_empty("intersection { BALL } BALL center [2.5, 0, 0] } }"));
    EXPECT_FALSE(is_empty("intersection { CUBE } CUBE translate [2, 0, 0] } }")) << "not sure";
    EXPECT_FALSE(
        is_empty("intersection { BALL center [1e17, 0, 0] } BALL center [1e17, 0, 0] } }"));
    EXPECT_TRUE(
        is_empty("union { for x in [0, 9] { intersection { CUBE } CUBE translate [3, 0, 0] } "
                 "translate [x, 0, 0] } } }"));
    EXPECT_FALSE(is_empty("intersection { BALL } BALL center [1.5, 0, 0] } }"));
    EXPECT_FALSE(is_empty("union { BALL } intersection { CUBE } CUBE translate [3, 0, 0] } } }"));
    EXPECT_FALSE(is_empty("intersection { FLOOR } CUBE } }"));
}

TEST(EmptyBody, TellsTheCauseWhereverItLies) {
    const auto hint_of = [](const std::string& script) {
        const auto result = test::run(script);
        return result.found.size() == 1 ? result.found[0].hint : result.messages;
    };
    const std::string apart =
        "intersection { sphere { radius 1 } sphere { radius 1 center [9, 0, 0] } }";
    for (const char* outer : {"union", "difference", "intersection"})
        EXPECT_EQ(hint_of(std::string(outer) + " { " + apart + " }"),
                  "parts of the intersection have no space in common");
    EXPECT_EQ(hint_of("difference { " + apart + " sphere { radius 99 } }"),
              "parts of the intersection have no space in common");
}

}  // namespace
}  // namespace lancer
