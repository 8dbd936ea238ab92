// Bodies in bodies, glued, touching, around the camera: what the list of media must get right in
// every pixel and in every order of declaration.
#include <algorithm>
#include <numeric>
#include <random>

#include "tests/tracer/media_kit.h"

namespace lancer {
namespace {

using namespace kit;

/// A ray straight through the centre of concentric shells is not bent, so its colour is known for
/// any number of shells: the sky behind, times T for every surface.
TEST(NestedShells, AStraightRayCrossesEachTwice) {
    for (const int shells : {1, 2, 5, 20, 50}) {
        Scene scene;
        scene.background = Color(1);
        scene.settings.min_contribution = 0;
        scene.settings.max_depth = 2 * shells + 1;
        for (int i = 0; i < shells; ++i) {
            Material m = clear(i % 2 == 0 ? 1.5 : 1.0);
            m.transmission = 0.99;
            show(scene, Sphere{{0, 0, 0}, 1.0 - 0.015 * i}, m);
        }
        EXPECT_COLOR_NEAR(seen(scene, {1, 2, 3}, {0, 0, 0}), Color(std::pow(0.99, 2 * shells)),
                          1e-12);
    }
}

/// Off the centre: after Bouguer's law n r sin(angle) is the same at every spherical shell, so the
/// angle by which the ray is turned is a sum of arcsines.
TEST(NestedShells, ARayIsTurnedByTheSumOfItsBends) {
    for (const int shells : {1, 2, 5, 20, 50}) {
        const double height = 0.1;
        double turned = 0;
        double outside = 1;
        Scene scene;
        scene.settings.min_contribution = 0;
        scene.settings.max_depth = 2 * shells + 2;
        for (int i = 0; i < shells; ++i) {
            const double index = i % 2 == 0 ? 1.5 : 1.0;
            const double radius = 1.0 - 0.015 * i;
            turned +=
                2 * (std::asin(height / (outside * radius)) - std::asin(height / (index * radius)));
            outside = index;
            show(scene, Sphere{{0, 0, 0}, radius}, clear(index));
        }
        // The ray comes down at x = 0.1 and leaves turned towards -x, its line still at distance
        // 0.1 from the centre. A bead far along it is met.
        const Vec3d direction(-std::sin(turned), -std::cos(turned), 0);
        const Vec3d aside(std::cos(turned), -std::sin(turned), 0);
        show(scene, Sphere{height * aside + 50.0 * direction, 1e-6}, glowing(Color(1)));
        EXPECT_COLOR_NEAR(seen(scene, {0.1, 9, 0}, {0.1, 0, 0}), Color(1), 1e-12);
    }
}

TEST(NestedShells, LoseNoCrossingInAnyPixelAndAnyOrder) {
    std::vector<int> order(20);
    std::iota(order.begin(), order.end(), 0);
    std::mt19937 random(1);
    Image first;
    for (int round = 0; round < 3; ++round) {
        Scene scene;
        surround(scene);
        for (const int i : order)
            show(scene, Sphere{{0, 0, 0}, 3.0 - 0.1 * i}, clear(i % 2 == 0 ? 1.5 : 1.0));
        scene.cameras = {camera_along({2, 5, 9}, {0, 0, 0})};
        const Image image = without_losses(scene);
        if (round == 0) first = image;
        EXPECT_EQ(largest_difference(image, first), 0);
        std::shuffle(order.begin(), order.end(), random);
    }
}

TEST(Mirrors, TwoThatFaceEachOtherReflectTwoHundredTimes) {
    Material m = clear(1);
    m.transmission = 0;
    m.reflection = Color(0.99);
    m.emission = Color(0.01);
    Scene scene;
    scene.settings.min_contribution = 0;
    scene.settings.max_depth = 201;
    show(scene, Plane{{0, 1, 0}, 0}, m);
    show(scene, Plane{{0, -1, 0}, -1}, m);
    // 0.01 (1 + 0.99 + ... + 0.99^200), the first surface and 200 reflections.
    EXPECT_COLOR_NEAR(seen(scene, {0, 0.5, 0}, {0.3, 0, 0.2}), Color(1 - std::pow(0.99, 201)),
                      1e-12);
}

/// A block [-2, 2] x [-1, 1] x [-1, 1] cut across x into slabs.
Scene slabs(int count, const std::vector<int>& order, const Material& material) {
    Scene scene;
    surround(scene);
    const std::uint32_t id = add(scene, material);
    for (const int i : order) {
        const double from = -2 + 4.0 * i / count;
        const double to = -2 + 4.0 * (i + 1) / count;
        show(scene, Box{{from, -1, -1}, {to, 1, 1}}, id);
    }
    return scene;
}

TEST(GluedSlabs, EqualOneBlockInEveryOrderThroughEverySide) {
    std::vector<int> order(32);
    std::iota(order.begin(), order.end(), 0);
    std::mt19937 random(7);
    Material shiny = clear(1.5);
    shiny.fresnel = true;
    shiny.reflection = Color(0.9);
    Material tinted = clear(1.5);
    tinted.transmission = 0.5;
    tinted.filter = 0.3;
    tinted.color = {1, 0.5, 0.2};
    tinted.phong = 0.5;
    for (const Material& material : {clear(1.5), shiny, tinted}) {
        for (const Vec3d& eye : {Vec3d(9, 2, 1), Vec3d(-9, -2, 3), Vec3d(1, 9, 2), Vec3d(2, -9, 1),
                                 Vec3d(1, 2, 9), Vec3d(0.5, 1, -9), Vec3d(9, 0, 0)}) {
            const auto view = [&](Scene scene) {
                scene.settings.max_depth = 8;
                Light light;
                light.kind = PointLight{{3, 7, 5}, {}};
                scene.lights.push_back(light);
                scene.cameras = {camera_along(eye, {0.013, 0.007, 0.021})};
                return without_losses(scene, 24, 18);
            };
            const Image block = view(slabs(1, {0}, material));
            std::shuffle(order.begin(), order.end(), random);
            const Image glued = view(slabs(32, order, material));
            EXPECT_EQ(pixels_apart(block, glued, 1e-9), 0);
        }
    }
}

TEST(GlassOnATable, ShowsTheTableInEveryOrder) {
    Material table;
    table.color = {0.9, 0.5, 0.1};
    table.ambient = 1;
    table.diffuse = 0;
    for (const bool glass_first : {true, false}) {
        for (const bool box : {true, false}) {
            Scene scene;
            scene.background = {0, 0, 1};
            scene.settings.min_contribution = 0;
            const auto put_glass = [&] {
                if (box)
                    show(scene, Box{{-1, 0, -1}, {1, 0.2, 1}}, clear(1.5));
                else
                    show(scene, Cylinder{{0, 0, 0}, {0, 0.2, 0}, 1, true}, clear(1.5));
            };
            if (glass_first) put_glass();
            show(scene, Plane{{0, 1, 0}, 0}, table);
            if (!glass_first) put_glass();
            scene.cameras = {camera_along({0, 3, 0.1}, {0, 0, 0})};
            scene.cameras[0].projection = PerspectiveProjection{25};
            const Image image = without_losses(scene);
            for (std::size_t i = 0; i < image.data.size(); i += 3) {
                EXPECT_EQ(image.data[i], 0.9);
                EXPECT_EQ(image.data[i + 2], 0.1);
            }
        }
    }
}

TEST(Bubble, InGlassInWaterIsCrossedSixTimes) {
    Scene scene;
    scene.background = Color(1);
    scene.settings.min_contribution = 0;
    scene.settings.max_depth = 20;
    const auto body = [&](double radius, double ior, double absorption) {
        Material m = clear(ior);
        m.transmission = 0.9;
        m.absorption = Color(absorption);
        show(scene, Sphere{{0, 0, 0}, radius}, m);
    };
    body(0.5, 1, 0);      // the bubble, declared first
    body(2, 1.33, 0.25);  // water
    body(1, 1.5, 0.5);    // glass
    EXPECT_COLOR_NEAR(seen(scene, {3, 4, 12}, {0, 0, 0}),
                      Color(std::pow(0.9, 6) * std::exp(-2 * 0.25 - 1 * 0.5)), 1e-12);
}

TEST(OverlappingBodies, LeavingOneThatIsNotTheLastGoesStraightOn) {
    Scene scene;
    scene.background = Color(1);
    scene.settings.min_contribution = 0;
    Material first = clear(1.5);
    first.absorption = Color(1);
    Material second = clear(1.8);
    second.absorption = Color(0.5);
    show(scene, Sphere{{0, 0, 0}, 1}, first);
    show(scene, Sphere{{0, 0, -1}, 1}, second);
    // z from 1 to 0 in the first, then 2 in the second, whose matter counts from its entry on.
    EXPECT_COLOR_NEAR(seen(scene, {0, 0, 9}, {0, 0, 0}), Color(std::exp(-1.0 - 0.5 * 2)), 1e-12);
}

TEST(CameraInside, StartsInTheBodiesThatHoldIt) {
    Mesh tetrahedron;
    tetrahedron.vertices = {{3, 3, 3}, {-3, -3, 3}, {-3, 3, -3}, {3, -3, -3}};
    tetrahedron.faces = {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}};
    const std::vector<Shape> shapes{Sphere{{0, 0, 0}, 1},
                                    Box{{-1, -1, -1}, {1, 1, 1}},
                                    Cylinder{{0, 0, -1}, {0, 0, 1}, 2, true},
                                    Cone{{0, 0, -1}, {0, 0, 1}, 2, 1, true},
                                    Plane{{0, 0, 1}, 1},
                                    MeshRef{0, false}};
    for (const Shape& shape : shapes) {
        Material m = clear(1.5);
        m.absorption = Color(0.5);
        Scene scene;
        scene.background = Color(1);
        scene.settings.min_contribution = 0;
        scene.meshes.push_back(std::make_shared<Mesh>(tetrahedron));
        show(scene, shape, m);
        const bool mesh = std::holds_alternative<MeshRef>(shape);
        // Along z the way out is 1, in the tetrahedron against the diagonal (1, 1, 1) it is √3.
        const Vec3d at = mesh ? Vec3d(-1, -1, -1) : Vec3d(0, 0, 1);
        const double way = mesh ? std::sqrt(3.0) : 1;
        SCOPED_TRACE(shape.index());
        EXPECT_COLOR_NEAR(seen(scene, {0, 0, 0}, at), Color(std::exp(-0.5 * way)), 1e-12);
    }
}

TEST(MeshWithAGap, IsABodyWhereItsAuthorSaysSo) {
    // A tetrahedron without the face towards (1, 1, 1).
    Mesh open;
    open.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
    open.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}};
    Material m = clear(1);
    m.absorption = Color(0.5);
    const auto through = [&](Inside inside, const Vec3d& from, const Vec3d& at) {
        Scene scene;
        scene.background = Color(1);
        scene.settings.min_contribution = 0;
        scene.meshes.push_back(std::make_shared<Mesh>(open));
        show(scene, MeshRef{0, false, inside}, m);
        return seen(scene, from, at);
    };
    // In by x = 0 and out by y = 0, a way of sqrt(0.5).
    const Vec3d from(-1, 1.5, 0.5);
    const Vec3d at(1, -0.5, 0.5);
    EXPECT_COLOR_NEAR(through(Inside::if_closed, from, at), Color(1), 1e-12);
    EXPECT_COLOR_NEAR(through(Inside::never, from, at), Color(1), 1e-12);
    EXPECT_COLOR_NEAR(through(Inside::always, from, at), Color(std::exp(-0.5 * std::sqrt(0.5))),
                      1e-12);
    // The ray enters through the gap, so nothing shows that it is inside.
    EXPECT_COLOR_NEAR(through(Inside::always, {0.5, 5, 0.5}, {0.5, 0, 0.5}), Color(1), 1e-12);
}

TEST(CameraOnAFace, BelongsToTheSideThatItsRayGoesTo) {
    Material m = clear(1.5);
    m.absorption = Color(0.5);
    const std::vector<Shape> shapes{Sphere{{0, 0, 0}, 1}, Box{{-1, -1, -1}, {1, 1, 1}},
                                    Cylinder{{0, 0, -1}, {0, 0, 1}, 2, true}};
    for (const Shape& shape : shapes) {
        Scene scene;
        scene.background = Color(1);
        scene.settings.min_contribution = 0;
        show(scene, shape, m);
        EXPECT_COLOR_NEAR(seen(scene, {0, 0, 1}, {0, 0, 0}), Color(std::exp(-0.5 * 2)), 1e-12);
        EXPECT_COLOR_NEAR(seen(scene, {0, 0, 1}, {0, 0, 2}), Color(1), 1e-12);
    }
}

}  // namespace
}  // namespace lancer
