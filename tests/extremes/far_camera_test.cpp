// A camera so far away that its rays begin near the scene: this must change nothing else.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/extremes/picture.h"

namespace lancer::extremes {
namespace {

/// A ball of radius 1 at the origin, seen along -z.
Stage far_ball(double distance) {
    Stage s;
    s.add(Sphere{{0, 0, 0}, 1}, s.matt({1, 0, 0}));
    s.lamp({0, 5, 5});
    s.look({0, 0, distance}, {0, 0, 0}, degrees(2 * std::atan(2 / distance)));
    return s;
}

Probe middle(const Scene& scene) {
    return compile(scene, scene.settings)->probe({0, 128, 96, {}, false}, 64, 48);
}

TEST(FarCamera, DepthIsCountedFromTheCamera) {
    for (const double distance : {10.0, 1e3, 1e9}) {
        Stage s = far_ball(distance);
        EXPECT_EQ(middle(s.scene).object, 0u);
        EXPECT_DOUBLE_EQ(middle(s.scene).depth, distance - 1);
        s.look_parallel({0, 0, distance}, {0, 0, 0}, 4);
        EXPECT_DOUBLE_EQ(middle(s.scene).depth, distance - 1);
    }
}

TEST(FarCamera, APlaneOnTheWayHidesTheScene) {
    for (const double at : {5.0, 1e3, 0.9e9}) {
        Stage s = far_ball(1e9);
        s.add(Plane{{0, 0, 1}, at}, s.matt({0, 1, 0}));
        EXPECT_EQ(middle(s.scene).object, 1u) << at;
        EXPECT_NEAR(middle(s.scene).depth / (1e9 - at), 1, 1e-12) << at;
    }
    Stage s = far_ball(1e9);
    s.add(Plane{{0, 0, 1}, 1e9 + 1}, s.matt({0, 1, 0}));
    EXPECT_EQ(middle(s.scene).object, 0u) << "behind the camera";
}

/// The camera is in unbounded water, which dims the light over the whole distance to the ball.
TEST(FarCamera, TheWholeWayThroughAMediumCounts) {
    const auto light_of = [](double distance) {
        Stage s = far_ball(distance);
        s.scene.objects[0].material = 0;
        Material glow;
        glow.ambient = 0;
        glow.diffuse = 0;
        glow.emission = {1, 1, 1};
        s.scene.objects[0].material = s.material(glow);
        Material water = s.scene.materials[s.glass(1)];
        water.absorption = Color(1 / distance);
        s.add(Plane{{0, 0, 1}, 2 * distance}, s.material(water));
        return picture(s.scene).pixel(64, 48)[0];
    };
    EXPECT_NEAR(light_of(8), std::exp(-7.0 / 8), 2e-3);
    EXPECT_NEAR(light_of(1e6), std::exp(-1.0), 1e-5);
}

}  // namespace
}  // namespace lancer::extremes
