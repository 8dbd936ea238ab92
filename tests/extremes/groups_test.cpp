// The same shape, written out and under groups.
#include <gtest/gtest.h>

#include "tests/extremes/picture.h"

namespace lancer::extremes {
namespace {

TEST(Groups, TurnedAndMirrored) {
    const Scene scene = base_stage().scene;
    const Image reference = picture(scene);
    const Affine<double> turned = compose(turn(1, 37), compose(turn(0, 23), turn(2, 71)));
    EXPECT_EQ(wrong(picture(under(scene, turned)), reference), 0);
    const Image flipped = picture(under(scene, stretched(-1, 1, 1)));
    int off = 0;
    for (int y = 0; y < 96; ++y) {
        for (int x = 0; x < 128; ++x) {
            for (int c = 0; c < 3; ++c)
                off +=
                    std::abs(flipped.pixel(127 - x, y)[c] - reference.pixel(x, y)[c]) > 1.0 / 255;
        }
    }
    EXPECT_EQ(off, 0);
}

/// Ellipsoids against each other: the same one as a stretched sphere in two ways.
TEST(Groups, Ellipsoid) {
    const auto scene = [](const Shape& shape, const Affine<double>& map) {
        Stage s;
        s.look({0.4, 2, 5}, {0, 0.5, 0}, 40);
        s.lamp({3, 5, 2});
        s.add(Plane{{0, 1, 0}, 0}, s.matt({0.8, 0.8, 0.9}));
        s.add(shape, s.glass(1.5, {1, 0.8, 0.6}), map);
        return s.scene;
    };
    const Image reference = picture(scene(Sphere{{0, 0.5, 0}, 0.5}, stretched(3, 1, 1)));
    for (int k = -9; k <= 9; k += 3) {
        const double f = power10(k);
        EXPECT_EQ(wrong(picture(scene(Sphere{{0, 0.5 / f, 0}, 0.5 / f}, stretched(3 * f, f, f))),
                        reference),
                  0)
            << k;
    }
}

/// Opaque boxes whose faces lie in one plane, rotated and far away: no speckles.
TEST(Groups, FlushOpaqueBoxes) {
    for (const double angle : {0.0, 37.0}) {
        for (const double far : {0.0, 1e3, 1e9}) {
            Stage s;
            s.scene.background = {0, 1, 0};
            Material lit;
            lit.ambient = 1;
            lit.diffuse = 0;
            lit.color = {1, 0, 0};
            const std::uint32_t red = s.material(lit);
            lit.color = {0, 0, 1};
            const std::uint32_t blue = s.material(lit);
            const Affine<double> map =
                compose(shift(Vec3d(far)), compose(turn(2, angle), turn(0, angle)));
            // The red box is declared first and shares its top with the larger blue one.
            s.add(Box{{-1, 0, -1}, {1, 1, 1}}, red, map);
            s.add(Box{{-2, 0.5, -2}, {2, 1, 2}}, blue, map);
            s.look(map_point(map, {0.2, 4, 0.9}), map_point(map, {0, 1, 0}), 20,
                   map_vector(map, {0, 0, 1}));
            EXPECT_EQ(wrong(picture(s.scene), Color(1, 0, 0)), 0) << angle << " " << far;
        }
    }
}

/// Glass that stands on a plane, both turned and far away: the floor shows, no gap opens.
TEST(Groups, RestingGlassFarAway) {
    for (const double angle : {0.0, 37.0}) {
        const Affine<double> map = compose(turn(2, angle), turn(0, angle));
        const auto scene = [&](double far) {
            Stage s;
            s.scene.background = {0, 1, 0};
            s.add(Plane{{0, 1, 0}, 0}, s.matt({0.9, 0.8, 0.7}));
            s.add(Box{{-1, 0, -1}, {0.5, 1, 1}}, s.glass(1.5));
            s.add(Cylinder{{1, 0, 0}, {1, 1, 0}, 0.375}, s.glass(1.5));
            s.lamp({2, 6, 3});
            s.look({0.5, 3, 5}, {0, 0.5, 0}, 35);
            return under(s.scene, compose(shift(Vec3d(far)), map));
        };
        const Image reference = picture(scene(0), Precision::extended);
        for (const double far : {0.0, 1e3, 1e6, 1e9})
            EXPECT_EQ(wrong(picture(scene(far)), reference), 0) << angle << " " << far;
    }
}

}  // namespace
}  // namespace lancer::extremes
