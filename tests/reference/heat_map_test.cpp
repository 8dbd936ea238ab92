#include "reference/compare/heat_map.h"

#include <gtest/gtest.h>

#include <limits>

#include "reference/compare/color_map.h"
#include "reference/compare/numerals.h"

namespace lancer::reference {
namespace {

double luminance(const Color& c) {
    return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

Color color_at(const Image& image, int x, int y) {
    const double* p = image.pixel(x, y);
    return {p[0], p[1], p[2]};
}

TEST(Magma, GrowsLighterAllTheWay) {
    for (int i = 0; i < 200; ++i) {
        EXPECT_LT(luminance(magma(i / 200.0)), luminance(magma((i + 1) / 200.0))) << i;
    }
}

TEST(Magma, IsClamped) {
    EXPECT_EQ(magma(-3), magma(0));
    EXPECT_EQ(magma(7), magma(1));
}

TEST(HeatMap, MapsDecadesToEqualStepsOfTheColourMap) {
    const std::vector<double> differences = {0, 1e-6, 1e-3, 1, 5};
    const Image map = heat_map(differences, 5, false);
    EXPECT_EQ(map.width, 5);
    EXPECT_EQ(map.height, 1);
    EXPECT_EQ(color_at(map, 0, 0), magma(0));
    EXPECT_EQ(color_at(map, 1, 0), magma(0));
    EXPECT_NEAR(luminance(color_at(map, 2, 0)), luminance(magma(0.5)), 1e-9);
    EXPECT_EQ(color_at(map, 3, 0), magma(1));
    EXPECT_EQ(color_at(map, 4, 0), magma(1));
}

TEST(HeatMap, ShowsWhatIsNotFiniteInWhite) {
    const Image map = heat_map({std::numeric_limits<double>::quiet_NaN(), 0}, 2, false);
    EXPECT_EQ(color_at(map, 0, 0), Color(1, 1, 1));
}

TEST(HeatMap, HasAScaleFromDarkToLightBelow) {
    const Image map = heat_map(std::vector<double>(200 * 3, 0.0), 200);
    EXPECT_EQ(map.width, 200);
    ASSERT_GT(map.height, 3 + numeral_height);
    EXPECT_LT(luminance(color_at(map, 12, 10)), luminance(color_at(map, 187, 10)));
}

TEST(HeatMap, WidensANarrowPictureForTheScale) {
    const Image map = heat_map({1, 1}, 1);
    EXPECT_GT(map.width, 7 * numerals_width("1e-6"));
    EXPECT_EQ(color_at(map, 0, 1), magma(1));
    EXPECT_EQ(color_at(map, 1, 1), Color(0, 0, 0));
}

TEST(Numerals, AreCutOffAtTheBorder) {
    Image image(5, 5);
    draw_numerals(image, -2, -2, "888", {1, 1, 1});
    draw_numerals(image, 3, 3, "888", {1, 1, 1});
    EXPECT_EQ(image.pixel(4, 4)[0], 0.0) << "inside the upper ring of the 8";
    EXPECT_EQ(image.pixel(3, 3)[0], 1.0);
}

}  // namespace
}  // namespace lancer::reference
