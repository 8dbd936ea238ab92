// Materials and textures in place, where a value stands; colours by name; templates called like
// blocks.
#include <gtest/gtest.h>

#include <string>

#include "parser/css_colors.h"
#include "tests/parser/script.h"

namespace lancer {
namespace {

using test::run;
using test::value_of;

const Material& material_of(const Scene& scene, std::size_t object) {
    return scene.materials.at(scene.objects.at(object).material);
}

TEST(InPlace, MaterialsAndTexturesAreValues) {
    const auto result =
        run("let red = material { color [1, 0, 0] }\n"
            "def ball(m = material { color [0, 0, 1] }) { sphere { radius 1 material m } }\n"
            "ball() ball(red) ball(m: material { phong 0.5 })\n"
            "let all = [for i in 0..3: material { color [i / 2, 0, 0] }]\n"
            "sphere { radius 1 material true ? all[2] : red }\n"
            "func grey(x) = material { color [x, x, x] }\n"
            "sphere { radius 1 material grey(0.25) }\n"
            "sphere { radius 1 material { color texture { checker [[1, 1, 1], [0, 0, 0]] } } }");
    ASSERT_EQ(result.messages, "");
    EXPECT_EQ(material_of(result.scene, 0).color, Color(0, 0, 1));
    EXPECT_EQ(material_of(result.scene, 1).color, Color(1, 0, 0));
    EXPECT_EQ(material_of(result.scene, 2).phong, 0.5);
    EXPECT_EQ(material_of(result.scene, 3).color, Color(1, 0, 0));
    EXPECT_EQ(material_of(result.scene, 4).color, Color(0.25, 0.25, 0.25));
    EXPECT_EQ(material_of(result.scene, 5).texture, 0u);
}

TEST(InPlace, TheirWordsAreNamesAsBefore) {
    const auto result = run(
        "let material = true let texture = [1] if material { print 1 } for x in texture { print x }"
        " sphere { radius material ? 2 : 1 } if (material) { print texture }");
    EXPECT_EQ(result.messages, "");
    EXPECT_EQ(result.printed, (std::vector<std::string>{"1", "1", "[1]"}));
}

TEST(InPlace, ThatNothingReachesAreChecked) {
    const auto result = run(
        "def t() { let a = material { colour [1, 0, 0] color texture { checker b mapping uv } } }");
    ASSERT_EQ(result.found.size(), 2u) << result.messages;
    EXPECT_EQ(result.found.at(0).message, "'colour' is not a property of a material");
    EXPECT_EQ(result.found.at(1).message, "'b' is not defined");
}

TEST(InPlace, AfterASyntaxErrorReadingGoesOn) {
    for (const char* text : {"let a = material { color x phong } + print 2",
                             "let a = [material { color [1, 2 }] print 2",
                             "let a = material { color texture { checker } } ? print 2",
                             "if material { let a = 2 } else if + { } print 2",
                             "let a = f(m: material { color texture { g(1) } }, ) print 2"}) {
        const auto result = run(text);
        EXPECT_GE(result.found.size(), 1u) << text;
        EXPECT_EQ(result.printed, std::vector<std::string>{"2"}) << text << '\n' << result.messages;
    }
}

TEST(InPlace, CallsThatHaveNoPlaceInOneAreNotArgumentsOfWhatIsAround) {
    for (const char* text :
         {"func f(x) = texture { g(1) } let a = f(1)", "def f(x, y = material { g(1) }) { } f(2)",
          "def f(x) { } f(material { g(1, 2) })", "print 1, material { g(1) }"}) {
        const auto result = run(text);
        ASSERT_EQ(result.found.size(), 1u) << text << '\n' << result.messages;
        EXPECT_EQ(result.found.at(0).message.find("'g' is not a property"), 0u);
    }
}

TEST(InPlace, WithinThemselvesForEverIsAnError) {
    const auto result =
        run("func f(x) = texture { gradient [0, 1, 0] stops [[0, texture { gradient [0, 1, f(x)]"
            " stops [] }]] } let a = f(1)");
    ASSERT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_EQ(result.found.at(0).message, "the nesting is more than 512 levels deep");
}

TEST(ColorsOfTheWeb, AreOfOneTableInOrder) {
    ASSERT_EQ(css_colors().size(), 148u);
    for (const CssColor& color : css_colors()) EXPECT_EQ(css_color(color.name), &color);
    EXPECT_EQ(css_color("tomat"), nullptr);
    EXPECT_EQ(css_color("zebra"), nullptr);
    EXPECT_EQ(value_of("css(\"tomato\") == #ff6347 && css(\"RebeccaPurple\") == #663399"), "true");
}

TEST(Templates, MayBeCalledLikeABlock) {
    const auto result =
        run("def cone(r) { sphere { radius r } } cone(0.5)"
            " cone { base [0, 0, 0] top [0, 1, 0] base_radius 1 }");
    EXPECT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_EQ(result.found.at(0).severity, Severity::warning);
    EXPECT_EQ(result.scene.objects.size(), 2u);
}

}  // namespace
}  // namespace lancer
