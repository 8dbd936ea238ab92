// Glass at extremes: indices next to 1, shells in shells, the critical angle.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/extremes/picture.h"
#include "tracer/shading/optics.h"

namespace lancer::extremes {
namespace {

Stage striped() {
    Stage s;
    s.look({0.4, 2, 5}, {0, 0.5, 0}, 40);
    s.lamp({3, 5, 2});
    s.scene.background = {0.1, 0.2, 0.4};
    s.scene.settings.max_depth = 300;
    s.add(Plane{{0, 1, 0}, -0.5}, s.matt({0.8, 0.8, 0.9}));
    s.add(Box{{-2, -0.5, -2}, {-0.3, 2, -1.5}}, s.matt({0.9, 0.2, 0.1}));
    return s;
}

TEST(Refraction, AnyIndex) {
    std::vector<double> indices = {0.1, 0.5, 0.9, 1.1, 1.5, 2, 10, 100};
    for (int k = 2; k <= 16; ++k) indices.insert(indices.end(), {1 + power10(-k), 1 - power10(-k)});
    for (const double ior : indices) {
        Stage s = striped();
        s.add(Sphere{{0, 0.5, 0}, 0.9}, s.glass(ior));
        const Scene scene = half_size(s.scene);
        EXPECT_EQ(wrong(picture(scene), quad_picture(scene)), 0) << ior;
    }
}

TEST(Refraction, DeflectionByAlmostNothing) {
    // Through one face at 45 degrees the ray turns by d tan 45 = d for an index 1 + d.
    for (int k = 1; k <= 12; ++k) {
        const double d = power10(-k);
        const Vec3d in = normalize(Vec3d(1, -1, 0));
        Vec3d out;
        ASSERT_TRUE(refracted(in, Vec3d(0, 1, 0), 1 / (1 + d), out));
        const double turned = cross(out, in).z;
        const double exact =
            std::sin(std::asin(std::sqrt(0.5)) - std::asin(std::sqrt(0.5) / (1 + d)));
        if (k <= 6) {
            EXPECT_NEAR(turned / exact, 1, 1e-9) << k;
        }
        EXPECT_NEAR(turned / d, 1, k == 1 ? 0.2 : 0.02) << k;
    }
}

TEST(Refraction, CriticalAngleTakesTheRightBranch) {
    // From index 2 into 1 the critical angle is 30 degrees.
    const long double critical = std::asin(0.5L);
    for (int k = 1; k <= 15; ++k) {
        for (const int sign : {-1, 1}) {
            const long double angle = critical + sign * std::pow(10.0L, -k);
            const Vec3<double> in(static_cast<double>(std::sin(angle)),
                                  static_cast<double>(-std::cos(angle)), 0);
            Vec3<double> out;
            EXPECT_EQ(refracted(in, Vec3d(0, 1, 0), 2.0, out), sign < 0) << k;
        }
    }
}

TEST(Refraction, CoincidentSpheresAreOne) {
    for (const int n : {2, 3}) {
        Stage s = striped();
        for (int i = 0; i < n; ++i) s.add(Sphere{{0, 0.5, 0}, 0.9}, s.glass(1.5));
        Stage one = striped();
        one.add(Sphere{{0, 0.5, 0}, 0.9}, one.glass(1.5));
        EXPECT_EQ(wrong(picture(s.scene), picture(one.scene)), 0) << n;
    }
}

TEST(Refraction, TwoMirrors) {
    for (const int depth : {10, 50, 200}) {
        Stage s = striped();
        s.scene.settings.max_depth = depth;
        s.add(Box{{-3, -0.5, -3.1}, {3, 3, -3}}, s.mirror());
        s.add(Box{{-3, -0.5, 5.5}, {3, 3, 5.6}}, s.mirror());
        const Scene scene = half_size(s.scene);
        EXPECT_EQ(wrong(picture(scene), quad_picture(scene)), 0) << depth;
    }
}

}  // namespace
}  // namespace lancer::extremes
