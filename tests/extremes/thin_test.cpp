// Long, thin and pointed shapes.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/extremes/picture.h"

namespace lancer::extremes {
namespace {

Stage lit() {
    Stage s;
    s.scene.background = {0.1, 0.2, 0.4};
    s.sun({-1, -2, -3}, {0.7, 0.7, 0.7});
    s.sun({2, -1, -1}, {0.5, 0.4, 0.3});
    return s;
}

TEST(Cones, ApexFromAfar) {
    // The camera stays and the picture shrinks, until the rounding of the ray's start is a part of
    // a pixel.
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
