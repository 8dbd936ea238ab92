// Random scenes with every shape, material, texture, light and transform, tested by changes that
// must not change their pictures. rows_test.cpp and last_digits_test.cpp compare with more digits.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/extremes/picture.h"
#include "tests/extremes/random_scene.h"

namespace lancer::extremes {
namespace {

constexpr unsigned scenes = 40;

TEST(Random, BitIdenticalUnderPowersOfTwo) {
    for (unsigned seed = 1; seed <= scenes; ++seed) {
        const Scene scene = random_anything(seed);
        const Image reference = picture(scene);
        for (const int k : {-100, -17, 1, 33, 100}) {
            const double f = std::ldexp(1, k);
            EXPECT_EQ(different(picture(scaled(scene, f)), reference), 0) << seed << " " << k;
        }
    }
}

TEST(Random, BitIdenticalUnderAGroupThatScales) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Scene scene = random_scene(seed);
        const Image reference = picture(scene);
        for (const int k : {-100, -17, 33, 100}) {
            const double f = std::ldexp(1, k);
            EXPECT_EQ(different(picture(under(scene, stretched(f, f, f))), reference), 0)
                << seed << " " << k;
        }
    }
}

/// A constant tolerance, or one relative to the scene's extent, would now be larger in proportion
/// to the scene.
TEST(Random, WhatNobodySeesFarAwayChangesNoBit) {
    for (unsigned seed = 1; seed <= scenes; ++seed) {
        const Scene scene = random_anything(seed);
        const Image reference = picture(scene);
        for (const int k : {10, 25, 40}) {
            Stage s;
            s.scene = scene;
            s.add(Sphere{{0, 0, std::ldexp(1, k)}, 0.5}, 0).casts_shadow = false;
            EXPECT_EQ(different(picture(s.scene), reference), 0) << seed << " " << k;
        }
    }
}

TEST(Random, PowersOfTenPlacesAndAxes) {
    for (unsigned seed = 1; seed <= scenes; ++seed) {
        const Scene scene = random_anything(seed);
        const Image reference = picture(scene);
        for (const int k : {-90, -9, 9, 90})
            EXPECT_EQ(wrong(picture(scaled(scene, power10(k))), reference), 0) << seed << " " << k;
        EXPECT_EQ(wrong(picture(moved(scene, Vec3d(1e6))), reference), 0) << seed;
        EXPECT_EQ(wrong(picture(axes_renamed(scene)), reference), 0) << seed;
    }
}

/// A camera far away sees what 113 bits see from there.
TEST(Random, AnyDistance) {
    for (unsigned seed = 1; seed <= scenes; ++seed) {
        for (const int k : {3, 9, 15}) {
            const Scene scene = half_size(seen_from_afar(random_anything(seed), power10(k)));
            EXPECT_EQ(wrong(picture(scene), quad_picture(scene)), 0) << seed << " " << k;
        }
    }
}

}  // namespace
}  // namespace lancer::extremes
