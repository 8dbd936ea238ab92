// The size of a scene must not matter.
#include <gtest/gtest.h>

#include "tests/extremes/stage.h"

namespace lancer::extremes {
namespace {

TEST(Scale, PowersOfTwoAreBitIdentical) {
    const Scene scene = base_stage().scene;
    const Image reference = picture(scene);
    for (const int k : {-100, -60, -30, -20, -10, -1, 1, 12, 20, 40, 75, 100})
        EXPECT_EQ(different(picture(scaled(scene, std::ldexp(1.0, k))), reference), 0) << k;
}

TEST(Scale, PowersOfTenLoseNoPixel) {
    const Scene scene = base_stage().scene;
    const Image reference = picture(scene);
    for (const int k : {-250, -90, -30, -12, -9, -8, -7, -6, -5, -4, -3, -2, -1,
                        1,    2,   3,   4,   5,  6,  7,  8,  9,  12, 30, 90, 250})
        EXPECT_EQ(wrong(picture(scaled(scene, power10(k))), reference), 0) << k;
}

TEST(Scale, GlassMesh) {
    Stage s;
    s.look({0.5, 2.5, 5}, {0, 1, 0}, 35);
    s.lamp({4, 6, 3});
    s.scene.background = {0.1, 0.2, 0.4};
    s.add(Plane{{0, 1, 0}, 0}, s.matt({0.9, 0.9, 0.8}));
    s.add(Box{{-2, 0, -2}, {-1, 1, -1}}, s.matt({0.9, 0.2, 0.1}));
    s.add(icosphere({0, 1, 0}, 1, 2), s.glass(1.5));
    const Image exact = picture(s.scene, Precision::extended);
    for (int k = -9; k <= 9; ++k)
        EXPECT_EQ(wrong(picture(scaled(s.scene, power10(k))), exact), 0) << k;
}

TEST(Scale, AxesMayChangePlaces) {
    const Scene scene = base_stage().scene;
    const Scene yzx = axes_renamed(scene);
    const Image reference = picture(scene);
    EXPECT_EQ(wrong(picture(yzx), reference), 0);
    EXPECT_EQ(wrong(picture(axes_renamed(scene, 2)), reference), 0);
}

/// A house on a planet: 10^7 down to glass of 10^-6 in one picture. Judged by more digits.
TEST(Scale, ManySizesInOneScene) {
    for (const double x : {0.0, 500000.123}) {
        Stage s;
        const Vec3d at(x, x / 3, -x / 7);
        s.scene.background = {0.1, 0.2, 0.4};
        s.lamp(at + Vec3d(4, 6, 3));
        s.add(Sphere{at + Vec3d(0, -1e7, 0), 1e7}, s.matt({0.3, 0.8, 0.3}));
        s.add(Box{at + Vec3d(-1, 0, -1), at + Vec3d(1, 1.5, 1)}, s.matt({0.9, 0.8, 0.7}));
        s.add(Box{at + Vec3d(-0.5, 0.25, 1.25), at + Vec3d(0.5, 1, 1.25 + 1e-6)},
              s.glass(1.5, {0.5, 0.9, 0.9}));
        s.add(Sphere{at + Vec3d(1e-6, 0.5, 1.5), 2e-6}, s.matt({1, 0, 0}));
        s.add(Cylinder{at + Vec3d(1.5, 0, 1.5), at + Vec3d(1.5, 1, 1.5), 1e-2}, s.mirror());
        s.look(at + Vec3d(1, 2, 5), at + Vec3d(0, 0.75, 0), 40);
        EXPECT_EQ(wrong(picture(s.scene), picture(s.scene, Precision::extended)), 0);
        s.look(at + Vec3d(0, 0.5, 1.5 + 2e-5), at + Vec3d(0, 0.5, 1.5), 40);
        EXPECT_EQ(wrong(picture(s.scene), picture(s.scene, Precision::extended)), 0);
    }
}

}  // namespace
}  // namespace lancer::extremes
