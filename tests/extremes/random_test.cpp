// Scenes that nobody chose: every shape, material and transform, judged by more digits and by
// invariance.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/extremes/stage.h"

namespace lancer::extremes {
namespace {

Scene random_scene(unsigned seed) {
    std::mt19937 random(seed);
    // Not a standard distribution: those differ between libraries.
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    const auto between = [&](double a, double b) { return a + (b - a) * unit(); };
    const auto place = [&] { return Vec3d(between(-2, 2), between(0, 2), between(-2, 2)); };
    Stage s;
    s.scene.width = 96;
    s.scene.height = 72;
    s.scene.background = {unit(), unit(), unit()};
    s.look({between(-2, 2), between(1, 4), between(5, 8)}, {0, 0.75, 0}, 45);
    s.lamp({between(2, 5), between(4, 8), between(0, 5)});
    s.lamp({between(-5, -2), between(4, 8), between(0, 5)}, {0.4, 0.3, 0.5});
    s.add(Plane{{0, 1, 0}, -0.25}, s.matt({unit(), unit(), unit()}));
    for (int i = 0; i < 12; ++i) {
        const double pick = unit();
        std::uint32_t m = s.matt({unit(), unit(), unit()});
        if (pick < 0.2) m = s.mirror();
        if (pick > 0.7) m = s.glass(between(1.1, 2), {between(0.7, 1), between(0.7, 1), 1});
        Affine<double> map;
        if (unit() < 0.5) {
            map = compose(turn(static_cast<int>(random() % 3), between(0, 360)),
                          stretch(between(0.5, 1.5), between(0.5, 1.5), between(0.5, 1.5)));
            if (unit() < 0.3) map = turn(static_cast<int>(random() % 3), between(0, 360));
            map = compose(shift({between(-1, 1), between(0, 1), between(-1, 1)}), map);
        }
        const Vec3d p = place();
        const double size = between(0.2, 0.6);
        switch (random() % 6) {
            case 0:
                s.add(Sphere{p, size}, m, map);
                break;
            case 1:
                s.add(Box{p, p + Vec3d(size, between(0.1, 1), between(0.1, 1))}, m, map);
                break;
            case 2:
                s.add(Cylinder{p, place(), size / 2, unit() < 0.8}, m, map);
                break;
            case 3:
                s.add(Cone{p, place(), size, unit() < 0.5 ? 0 : between(0, 1), unit() < 0.8}, m,
                      map);
                break;
            case 4:
                s.add(Triangle{{p, place(), place()}}, m, map);
                break;
            default:
                s.add(icosphere(p, size, 1), m, map);
                break;
        }
    }
    return s.scene;
}

TEST(Random, DoubleAgreesWithExtended) {
    int bad = 0;
    for (unsigned seed = 1; seed <= 30; ++seed) {
        const Scene scene = random_scene(seed);
        const int here = wrong(picture(scene), picture(scene, Precision::extended));
        if (here > 0) ADD_FAILURE() << here << " pixels wrong with seed " << seed;
        bad += here;
    }
    EXPECT_LE(bad, 2);  // of 207,360
}

TEST(Random, BitIdenticalUnderPowersOfTwo) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Scene scene = random_scene(seed);
        const Image reference = picture(scene);
        for (const int k : {-100, -17, 33, 100})
            EXPECT_EQ(different(picture(under(scene, stretch(std::ldexp(1, k), std::ldexp(1, k),
                                                             std::ldexp(1, k)))),
                                reference),
                      0)
                << seed << " " << k;
    }
}

TEST(Random, PowersOfTenAndPlaces) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Scene scene = random_scene(seed);
        const Image reference = picture(scene);
        for (const int k : {-9, 9, -90, 90})
            EXPECT_LE(wrong(picture(under(scene, stretch(power10(k), power10(k), power10(k)))),
                            reference),
                      0)
                << seed << " " << k;
        EXPECT_LE(wrong(picture(under(scene, shift(Vec3d(1e6)))), reference), 0) << seed;
    }
}

}  // namespace
}  // namespace lancer::extremes
