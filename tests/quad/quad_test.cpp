// Tests that the type has its 113 bits, and that the renderer keeps them.
#include "tests/quad/quad.h"

#include <gtest/gtest.h>

#include "tests/quad/renderer.h"

namespace lancer {
namespace {

constexpr Quad epsilon = std::numeric_limits<Quad>::epsilon();

TEST(Quad, Has113Bits) {
    EXPECT_TRUE(1 + epsilon > 1);
    EXPECT_TRUE(1 + epsilon / 2 == 1);
    EXPECT_TRUE((1 + epsilon) - 1 == epsilon);
    EXPECT_EQ(ilogb(epsilon), 1 - std::numeric_limits<Quad>::digits);
}

TEST(Quad, ReachesAsFarAsItSays) {
    constexpr Quad most = std::numeric_limits<Quad>::max();
    EXPECT_TRUE(isfinite(most));
    EXPECT_FALSE(isfinite(most * (1 + epsilon)));
    EXPECT_FALSE(isfinite(std::numeric_limits<Quad>::infinity()));
    EXPECT_FALSE(isfinite(std::numeric_limits<Quad>::quiet_NaN()));
    EXPECT_EQ(ilogb(most), std::numeric_limits<Quad>::max_exponent - 1);
    EXPECT_EQ(ilogb(std::numeric_limits<Quad>::min()), std::numeric_limits<Quad>::min_exponent - 1);
}

/// True to some units of the last of 113 bits.
void expect_same(Quad a, Quad b) {
    EXPECT_LE(static_cast<double>(abs(a - b) / (epsilon * abs(b))), 4);
}

TEST(Quad, FunctionsAreTrueToTheLastBits) {
    const Quad third = Quad(1) / 3;
    constexpr Quad pi = std::numbers::pi_v<Quad>;
    expect_same(sqrt(third) * sqrt(third), third);
    EXPECT_TRUE(fma(third, 3, -1) == -epsilon / 4);  // three times the rounding error of 1/3
    // The sine of the number nearest to pi is the distance of that number from pi.
    EXPECT_LT(static_cast<double>(abs(elementary::sin(pi))), 1e-34);
    expect_same(elementary::cos(pi / 3), Quad(0.5));
    expect_same(elementary::tan(pi / 4), 1);
    expect_same(elementary::asin(Quad(0.5)), pi / 6);
    expect_same(elementary::acos(Quad(0.5)), pi / 3);
    expect_same(elementary::atan(Quad(1)), pi / 4);
    expect_same(elementary::atan2(Quad(-1), Quad(-1)), -3 * pi / 4);
    expect_same(elementary::pow(third, 3), 1 / Quad(27));
    expect_same(elementary::exp(Quad(1)) * elementary::exp(Quad(-1)), 1);
}

TEST(Quad, ExponentsAndSigns) {
    int exponent = 0;
    EXPECT_TRUE(frexp(Quad(-12), &exponent) == -0.75);
    EXPECT_EQ(exponent, 4);
    EXPECT_TRUE(ldexp(Quad(3), -2000) == 3 * ldexp(Quad(1), -2000));
    EXPECT_TRUE(ldexp(Quad(1), -2000) > 0);  // below double's range
    EXPECT_TRUE(floor(Quad(-0.5)) == -1);
    EXPECT_TRUE(abs(Quad(-2)) == 2);
    EXPECT_TRUE(copysign(Quad(2), -3) == -2);
    EXPECT_TRUE(signbit(Quad(-0.0)));
    EXPECT_FALSE(signbit(Quad(0.0)));
}

/// A red triangle 10^-28 above a blue plane, seen from 4 away. The 64 bits of `extended` end at
/// 10^-19.
TEST(QuadRenderer, TellsApartWhatNoOtherTypeDoes) {
    Scene scene;
    scene.cameras.push_back({});
    scene.cameras[0].position = {0.3, 4, 2.5};
    scene.cameras[0].look_at = {0, 0, 0};
    scene.settings.threads = 1;
    Material material;
    material.ambient = 1;
    material.diffuse = 0;
    material.color = {0, 0, 1};
    scene.materials = {material, material};
    scene.materials[1].color = {1, 0, 0};
    Object object;
    object.material = 0;
    object.shape = Plane{{0, 1, 0}, 0};
    scene.objects.push_back(object);
    object.material = 1;
    object.shape = Triangle{{Vec3d(-9, 1e-28, -9), Vec3d(9, 1e-28, -9), Vec3d(0, 1e-28, 9)}};
    scene.objects.push_back(object);
    View view;
    view.width = view.height = 5;
    Settings settings = scene.settings;
    settings.precision = Precision::extended;
    EXPECT_EQ(compile(scene, settings)->probe(view, 2.5, 2.5).object, 0u);
    EXPECT_EQ(compile_quad(scene, settings)->probe(view, 2.5, 2.5).object, 1u);
}

}  // namespace
}  // namespace lancer
