// Long, thin and pointed shapes.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/extremes/stage.h"

namespace lancer::extremes {
namespace {

Stage lit() {
    Stage s;
    s.scene.background = {0.1, 0.2, 0.4};
    s.sun({-1, -2, -3}, {0.7, 0.7, 0.7});
    s.sun({2, -1, -1}, {0.5, 0.4, 0.3});
    return s;
}

/// A rod of radius r and length 2 l about the origin along `along`, its middle filling the picture.
Scene rod(const Vec3d& along, double r, double l, bool cone) {
    Stage s = lit();
    const std::uint32_t m = s.matt({0.9, 0.8, 0.7});
    if (cone)
        s.add(Cone{-along * l, along * l, r, r / 2}, m);
    else
        s.add(Cylinder{-along * l, along * l, r}, m);
    const Vec3d aside = normalize(cross(along, Vec3d(0.3, -0.2, 1)));
    const Vec3d from = normalize(cross(aside, along) + 0.4 * aside);
    s.look(from * (4 * r), Vec3d(0.0), 45, along);
    return s.scene;
}

TEST(Rods, RadiusTenToMinusKLengthTenToK) {
    for (const bool cone : {false, true}) {
        const Vec3d axis(0, 1, 0);
        const Image reference = picture(rod(axis, 1, 1e6, cone));
        for (int k = 3; k <= 10; ++k)
            EXPECT_EQ(wrong(picture(rod(axis, power10(-k), power10(k), cone)), reference), 0)
                << cone << " " << k;
        const Vec3d tilted = normalize(Vec3d(1, 2, -0.7));
        const Image tilted_reference = picture(rod(tilted, 1, 1e6, cone));
        for (int k = 3; k <= 5; ++k)
            EXPECT_EQ(wrong(picture(rod(tilted, power10(-k), power10(k), cone)), tilted_reference),
                      0)
                << cone << " tilted " << k;
    }
}

TEST(Rods, ThinWithLengthTwo) {
    for (const Vec3d& axis : {Vec3d(0, 1, 0), normalize(Vec3d(1, 2, -0.7))}) {
        const Image reference = picture(rod(axis, 1e-5, 1, false));
        for (int k = 6; k <= 12; ++k)
            EXPECT_EQ(wrong(picture(rod(axis, power10(-k), 1, false)), reference), 0) << k;
    }
}

/// A cone's apex is alike at every zoom.
TEST(Cones, ApexAtAnyZoom) {
    for (const double angle : {0.0, 37.0}) {
        for (const double side : {0.3, 0.9}) {
            const auto scene = [&](int k) {
                Stage s = lit();
                const Affine<double> map = compose(turn(0, angle), turn(1, angle));
                s.add(Cone{map_point(map, {0, -1, 0}), {0, 0, 0}, 0.75, 0},
                      s.matt({0.9, 0.8, 0.7}));
                const double f = power10(-k);
                s.look(map_point(map, Vec3d(0.3, side, 0.7) * f * 3.0), {0, 0, 0}, 30,
                       map_vector(map, {0, 0, 1}));
                return s.scene;
            };
            const Image reference = picture(scene(3));
            for (int k = 4; k <= 14; ++k)
                EXPECT_EQ(wrong(picture(scene(k)), reference), 0)
                    << angle << " " << side << " " << k;
        }
    }
}

TEST(Cones, ApexFromAfar) {
    // The camera stays, the picture shrinks: to where the start's own rounding is a pixel's part.
    const auto scene = [&](int k) {
        Stage s = lit();
        s.add(Cone{{0, -1, 0}, {0, 0, 0}, 0.75, 0}, s.matt({0.9, 0.8, 0.7}));
        s.look_parallel(Vec3d(0.3, 0.9, 0.7) * 2.0, {0, 0, 0}, 0.5 * power10(-k), {0, 0, 1});
        return s.scene;
    };
    const Image reference = picture(scene(1));
    for (int k = 2; k <= 10; ++k) EXPECT_EQ(wrong(picture(scene(k)), reference), 0) << k;
}

TEST(Cones, AlmostCylinders) {
    for (int k = 1; k <= 16; ++k) {
        Stage s = lit();
        s.add(Cone{{0, -1, 0}, {0, 1, 0}, 1, 1 - power10(-k)}, s.matt({0.9, 0.8, 0.7}));
        s.look({1, 2, 5}, {0, 0, 0}, 40);
        EXPECT_EQ(wrong(picture(s.scene), picture(s.scene, Precision::extended)), 0) << k;
    }
}

}  // namespace
}  // namespace lancer::extremes
