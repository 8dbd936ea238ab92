// Checker, gradient and image look-ups, one point at a time, against values worked out by hand.
#include <gtest/gtest.h>

#include "tracer/textures/image_map.h"
#include "tracer/textures/pattern.h"

namespace lancer {
namespace {

using V = Vec3<double>;

PatternPoint<double> at(double x, double y, double z, double bound = 0) {
    return {V(x, y, z), V(bound)};
}

const CheckerPattern<double> checker{V(1, 0, 0), V(0, 0, 1)};
const V even = checker.even;
const V odd = checker.odd;

TEST(Checker, CubeAtTheOriginIsEvenAndNeighboursAlternate) {
    EXPECT_EQ(color_at(checker, at(0.5, 0.5, 0.5)), even);
    EXPECT_EQ(color_at(checker, at(1.5, 0.5, 0.5)), odd);
    EXPECT_EQ(color_at(checker, at(1.5, 1.5, 0.5)), even);
    EXPECT_EQ(color_at(checker, at(1.5, 1.5, 1.5)), odd);
}

TEST(Checker, GoesOnBelowZeroWithoutAMirror) {
    EXPECT_EQ(color_at(checker, at(-0.5, 0.5, 0.5)), odd);
    EXPECT_EQ(color_at(checker, at(-0.5, -0.5, 0.5)), even);
    EXPECT_EQ(color_at(checker, at(-1.5, 0.5, 0.5)), even);
}

TEST(Checker, ACoordinateWithinItsBoundOfAnIntegerCountsAsThatInteger) {
    EXPECT_EQ(color_at(checker, at(0.5, -1e-13, 0.5, 1e-12)), even);
    EXPECT_EQ(color_at(checker, at(0.5, 1e-13, 0.5, 1e-12)), even);
    EXPECT_EQ(color_at(checker, at(0.5, -1e-11, 0.5, 1e-12)), odd);
}

TEST(Checker, ParityIsRightFarBeyondTheRangeOfIntegers) {
    const double large = 36893488147419103232.0;  // 2^65
    EXPECT_EQ(color_at(checker, at(large, 0.5, 0.5)), even);
    EXPECT_EQ(color_at(checker, at(9007199254740991.0, 0.5, 0.5)), odd);  // 2^53 - 1
}

GradientPattern<double> ramp() {
    return {V(0, 1, 0), {{0.25, V(1, 0, 0)}, {0.75, V(0, 1, 0)}}};
}

TEST(Gradient, IsLinearBetweenStopsAndConstantBeyondThem) {
    EXPECT_EQ(color_at(ramp(), at(7, 0.1, 3)), V(1, 0, 0));
    EXPECT_EQ(color_at(ramp(), at(7, 0.25, 3)), V(1, 0, 0));
    EXPECT_EQ(color_at(ramp(), at(7, 0.375, 3)), V(0.75, 0.25, 0));
    EXPECT_EQ(color_at(ramp(), at(7, 0.75, 3)), V(0, 1, 0));
    EXPECT_EQ(color_at(ramp(), at(7, 0.9, 3)), V(0, 1, 0));
}

TEST(Gradient, TakesTheFractionalPartOfNegativeCoordinatesToo) {
    EXPECT_EQ(color_at(ramp(), at(0, 3.5, 0)), V(0.5, 0.5, 0));
    EXPECT_EQ(color_at(ramp(), at(0, -0.5, 0)), V(0.5, 0.5, 0));
    EXPECT_EQ(color_at(ramp(), at(0, -2.625, 0)), V(0.75, 0.25, 0));
}

TEST(Gradient, TwoStopsAtOnePlaceMakeAStepWhoseUpperSideHoldsThePlace) {
    const GradientPattern<double> step{
        V(1, 0, 0), {{0, V(1, 0, 0)}, {0.5, V(1, 0, 0)}, {0.5, V(0, 0, 1)}, {1, V(0, 0, 1)}}};
    EXPECT_EQ(color_at(step, at(0.499, 0, 0)), V(1, 0, 0));
    EXPECT_EQ(color_at(step, at(0.5, 0, 0)), V(0, 0, 1));
    EXPECT_EQ(color_at(step, at(0.5 - 1e-14, 0, 0, 1e-13)), V(0, 0, 1)) << "within its bound";
}

TEST(Gradient, APlaneOnAnIntegerDoesNotFlickerBetweenTheEnds) {
    EXPECT_EQ(color_at(ramp(), at(0, 1 - 1e-14, 0, 1e-13)), V(1, 0, 0));
    EXPECT_EQ(color_at(ramp(), at(0, 1 + 1e-14, 0, 1e-13)), V(1, 0, 0));
}

/// 3 x 2, all texels different:  top row 1 2 3, bottom row 4 5 6 (red); green is a tenth of it.
Image numbers(int channels = 3) {
    Image image(3, 2, channels);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 3; ++x) {
            double* p = image.pixel(x, y);
            p[0] = 1 + x + 3 * y;
            p[1] = p[0] / 10;
            if (channels > 3) p[3] = p[0] / 6;
        }
    }
    return image;
}

using Filter = ImageTexture::Filter;
using Wrap = ImageTexture::Wrap;

TextureColor<double> looked_up(const Image& image, Filter filter, Wrap wrap, double u, double v,
                               double bound = 0) {
    const ImagePattern<double> map{&image, ImageTexture::Mapping::planar, filter, wrap, {}};
    return color_at(map, ImagePoint<double>{u, v, bound, bound});
}
double red(Filter filter, Wrap wrap, double u, double v, double bound = 0) {
    const Image image = numbers();
    return looked_up(image, filter, wrap, u, v, bound).color.x;
}

TEST(ImageMap, NearestTakesTheTexelThatHoldsThePointWithVUpwards) {
    EXPECT_EQ(red(Filter::nearest, Wrap::repeat, 0.1, 0.1), 4);
    EXPECT_EQ(red(Filter::nearest, Wrap::repeat, 0.5, 0.49), 5);
    EXPECT_EQ(red(Filter::nearest, Wrap::repeat, 0.9, 0.51), 3);
    EXPECT_EQ(red(Filter::nearest, Wrap::repeat, 0.3333, 0.9), 1);
    EXPECT_EQ(red(Filter::nearest, Wrap::repeat, 0.3334, 0.9), 2);
}

TEST(ImageMap, RepeatsInAllDirections) {
    EXPECT_EQ(red(Filter::nearest, Wrap::repeat, 7.1, -3.9), 4);
    EXPECT_EQ(red(Filter::nearest, Wrap::repeat, -0.1, 0.1), 6);
    EXPECT_EQ(red(Filter::nearest, Wrap::repeat, -0.9, 1.9), 1);
}

TEST(ImageMap, NearestCountsAPointWithinItsBoundOfAnEdgeToTheUpperTexel) {
    EXPECT_EQ(red(Filter::nearest, Wrap::repeat, 0.5, 0.5 - 1e-15, 1e-14), 2);
    EXPECT_EQ(red(Filter::nearest, Wrap::repeat, 0.5, 0.5 + 1e-15, 1e-14), 2);
}

TEST(ImageMap, BilinearHasTexelCentresAtOneHalf) {
    EXPECT_NEAR(red(Filter::bilinear, Wrap::repeat, 0.5, 0.25), 5, 1e-14);
    EXPECT_NEAR(red(Filter::bilinear, Wrap::repeat, 2.0 / 3, 0.25), 5.5, 1e-14);
    EXPECT_NEAR(red(Filter::bilinear, Wrap::repeat, 0.5, 0.5), 3.5, 1e-14);
    // A quarter of a texel to the right, a tenth upwards: 0.9 (0.75 * 5 + 0.25 * 6) + 0.1 (...)
    EXPECT_NEAR(red(Filter::bilinear, Wrap::repeat, 1.75 / 3, 0.3), 0.9 * 5.25 + 0.1 * 2.25, 1e-14);
}

TEST(ImageMap, BilinearNeighboursWrapWhenRepeatedAndAreClampedOnce) {
    EXPECT_NEAR(red(Filter::bilinear, Wrap::repeat, 0, 0.25), 5, 1e-14) << "mean of 6 and 4";
    EXPECT_NEAR(red(Filter::bilinear, Wrap::once, 0, 0.25), 4, 1e-14);
    EXPECT_NEAR(red(Filter::bilinear, Wrap::repeat, 0.5, 0), 3.5, 1e-14) << "mean of 5 and 2";
    EXPECT_NEAR(red(Filter::bilinear, Wrap::once, 0.5, 0), 5, 1e-14);
}

TEST(ImageMap, OnceIsFullyTransparentOutside) {
    const Image image = numbers();
    for (const auto& [u, v] : {std::pair(-0.01, 0.5), std::pair(1.01, 0.5), std::pair(0.5, -0.01),
                               std::pair(0.5, 1.01)}) {
        const TextureColor<double> c = looked_up(image, Filter::nearest, Wrap::once, u, v);
        EXPECT_TRUE(c.has_alpha);
        EXPECT_EQ(c.alpha, 0);
    }
    EXPECT_FALSE(looked_up(image, Filter::nearest, Wrap::once, 0.5, 0.5).has_alpha);
    EXPECT_EQ(red(Filter::nearest, Wrap::once, 1, 1), 3) << "the border belongs to the image";
    EXPECT_EQ(red(Filter::nearest, Wrap::once, -1e-15, 0.2, 1e-14), 4) << "within its bound";
}

TEST(ImageMap, AlphaIsInterpolatedLikeAColour) {
    const Image image = numbers(4);
    const TextureColor<double> c = looked_up(image, Filter::bilinear, Wrap::repeat, 2.0 / 3, 0.25);
    EXPECT_TRUE(c.has_alpha);
    EXPECT_NEAR(c.alpha, 5.5 / 6, 1e-14);
    EXPECT_NEAR(c.color.x, 5.5, 1e-14);
    EXPECT_NEAR(c.color.y, 0.55, 1e-14);
}

TEST(ImageMap, HugeAndUndefinedCoordinatesStayInTheImage) {
    for (const double u : {1e300, -1e300, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
        const double value = red(Filter::nearest, Wrap::repeat, u, u);
        EXPECT_TRUE(value >= 1 && value <= 6) << u;
    }
}

TEST(Mapping, SphericalIsLongitudeFromXTowardsZAndLatitude) {
    const auto map = [](double x, double y, double z) { return spherical(at(x, y, z)); };
    EXPECT_NEAR(map(2, 0, 0).u, 0, 1e-15);
    EXPECT_NEAR(map(0, 0, 2).u, 0.25, 1e-15);
    EXPECT_NEAR(map(-2, 0, 0).u, 0.5, 1e-15);
    EXPECT_NEAR(map(0, 0, -2).u, 0.75, 1e-15);
    EXPECT_NEAR(map(1, 0, -1e-30).u, 0, 1e-15) << "never 1";
    EXPECT_NEAR(map(1, 1, 0).v, 0.75, 1e-15);
    EXPECT_NEAR(map(0, -3, 0).v, 0, 1e-15);
    EXPECT_NEAR(map(0, 3, 0).v, 1, 1e-15);
    // asin(1/3) / pi + 1/2, asin(1/3) = 0.339836909454121937...
    EXPECT_NEAR(map(2, 1, -2).v, 0.5 + 0.339836909454121937 / pi, 1e-15);
}

TEST(Mapping, CylindricalIsLongitudeAndHeight) {
    const ImagePoint<double> p = cylindrical(at(-3, 1.75, 3));
    EXPECT_NEAR(p.u, 0.375, 1e-15);
    EXPECT_EQ(p.v, 1.75);
}

TEST(Mapping, TheCentreAndTheAxisHaveSomeCoordinates) {
    EXPECT_EQ(spherical(at(0, 0, 0)).u, 0);
    EXPECT_EQ(spherical(at(0, 0, 0)).v, 0.5);
    EXPECT_EQ(cylindrical(at(0, 1, 0)).u, 0);
}

}  // namespace
}  // namespace lancer
