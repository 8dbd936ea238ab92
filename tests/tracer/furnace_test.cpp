// What clear bodies must not do: an object that is none changes no bit, and nothing is brighter
// than what surrounds it.
#include <algorithm>
#include <random>

#include "tests/tracer/media_kit.h"
// After GoogleTest, which it does not include.
#include <rapidcheck/gtest.h>

namespace lancer {
namespace {

using namespace kit;

double number(std::mt19937& random, double from, double to) {
    return from + (to - from) * (static_cast<double>(random()) / 4294967296.0);
}
Vec3d place(std::mt19937& random, double reach) {
    const double x = number(random, -reach, reach);
    const double y = number(random, -reach, reach);
    return {x, y, number(random, -reach, reach)};
}

/// A body of any kind near the origin.
Shape any_body(std::mt19937& random) {
    const Vec3d p = place(random, 1.5);
    const double r = number(random, 0.2, 1.2);
    switch (random() % 4) {
        case 0:
            return Sphere{p, r};
        case 1:
            return Box{p - Vec3d(r), p + Vec3d(r, 0.5 * r, 2 * r)};
        case 2:
            return Cylinder{p, p + place(random, 1) + Vec3d(0.1), r, true};
        default:
            return Cone{p, p + place(random, 1) + Vec3d(0.1), r, 0.3 * r, true};
    }
}

TEST(NoObject, IndexOneAndFullTransmissionChangeNoBit) {
    std::mt19937 random(11);
    for (int round = 0; round < 12; ++round) {
        Scene scene;
        surround(scene);
        Light light;
        light.kind = PointLight{{3, 7, 5}, {}};
        scene.lights.push_back(light);
        Material matt;
        Material shiny = matt;
        shiny.reflection = Color(0.3);
        for (int i = 0; i < 4; ++i) show(scene, any_body(random), i % 2 == 0 ? matt : shiny);
        // The air is out of reach of the other bodies: air inside glass would be a bubble.
        show(scene, any_body(random), clear(1.5), shift(6, 0, 0));
        scene.settings.max_depth = 6;
        scene.cameras = {camera_along({2, 5, 9}, {0, 0, 0})};
        const Image plain = without_losses(scene, 24, 18);
        const Material air = clear(1);
        const Affine<double> turned = in_turn(stretched(1, 2, 0.7), turn_x(33), turn_y(12));
        show(scene, any_body(random), air);
        show(scene, any_body(random), air, turned);
        // Among the others: every order of declaration.
        std::rotate(scene.objects.begin(), scene.objects.end() - 1, scene.objects.end());
        const Image with_air = without_losses(scene, 24, 18);
        EXPECT_EQ(pixels_apart(plain, with_air, 0), 0) << "round " << round;
    }
}

/// In a white furnace nothing may look brighter than white if no surface gives more than it gets.
RC_GTEST_PROP(Furnace, NothingIsBrighterThanItsSurroundings, (std::uint32_t seed)) {
    std::mt19937 random(seed);
    Scene scene;
    scene.background = Color(1);
    scene.settings.min_contribution = 0;
    scene.settings.max_depth = 5;
    for (int i = 0; i < 5; ++i) {
        Material m;
        m.ambient = 0;
        m.diffuse = 0;
        m.color = absolute(place(random, 1));
        m.ior = number(random, 1, 2);
        m.fresnel = random() % 2 == 0;
        const double share = number(random, 0, 1);
        const double filter = number(random, 0, 1);
        // With Fresnel, reflection reduces the transmitted light; without it, the two are
        // independent.
        m.transmission = share * (1 - filter);
        m.filter = share * filter;
        m.reflection = Color(m.fresnel ? 1 : 1 - share);
        if (m.fresnel && share == 0) m.reflection = Color(1);
        m.absorption = random() % 2 == 0 ? Color(0) : absolute(place(random, 0.3));
        show(scene, any_body(random), m);
    }
    scene.cameras = {camera_along({2, 5, 9}, {0, 0, 0})};
    const Image image = without_losses(scene, 16, 12);
    for (const double value : image.data) {
        RC_ASSERT(value <= 1 + 1e-12);
        RC_ASSERT(value >= 0);
    }
}

TEST(Furnace, AClearGlassBallIsInvisibleWithFresnelToo) {
    Material m = clear(1.5);
    m.fresnel = true;
    m.reflection = Color(1);
    Scene scene;
    scene.background = Color(1);
    scene.settings.min_contribution = 0;
    scene.settings.max_depth = 14;
    show(scene, Sphere{{0, 0, 0}, 1}, m);
    // The light still inside after 14 levels is lost; near the centre this is reflectance^13.
    EXPECT_COLOR_NEAR(seen(scene, {0.2, 0.1, 9}, {0.2, 0.1, 0}), Color(1), 1e-12);
}

}  // namespace
}  // namespace lancer
