// Bodies made of bodies, seen by single rays: faces that coincide exactly, and what is inside.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/tracer/scene_kit.h"

namespace lancer {
namespace {

using namespace kit;
using Kind = Composite::Kind;

struct Part {
    Shape shape;
    std::uint32_t material;
    Affine<double> map{};
};

/// A scene with one composite of these parts; materials 1, 2, 3 glow red, green and blue.
class Bodies {
  public:
    Bodies() {
        scene.transforms = {{}};
        scene.materials = {Material{}};
        for (const Color& color : {Color(1, 0, 0), Color(0, 1, 0), Color(0, 0, 1)})
            add(scene, glowing(color));
        scene.background = {0.5, 0.5, 0.5};
    }

    Object& make(Kind kind, const std::vector<Part>& parts, std::uint32_t material = 1) {
        Composite made;
        made.nodes.push_back({kind, {}, 0, static_cast<std::uint32_t>(parts.size())});
        for (const Part& part : parts) {
            Composite::Leaf leaf;
            leaf.object.shape = part.shape;
            leaf.object.material = part.material;
            if (!(part.map == Affine<double>{})) leaf.object.transform = add(scene, part.map);
            leaf.texture_space = leaf.object.transform;
            leaf.place = {0, made.leaves.empty()};
            made.leaves.push_back(leaf);
        }
        scene.composites.push_back(made);
        return show(scene, CompositeRef{static_cast<std::uint32_t>(scene.composites.size() - 1)},
                    material);
    }

    Scene scene;
};

const Color red(1, 0, 0);
const Color green(0, 1, 0);
const Color gray(0.5, 0.5, 0.5);

TEST(Composite, AHoleWhoseCutterEndsInTheFaceIsOpen) {
    for (const double size : {1e-9, 1.0, 3e7}) {
        Bodies b;
        b.make(Kind::subtract, {{Box{Vec3d(-size, -size, -size), Vec3d(size, 0, size)}, 1},
                                {Cylinder{{0, -size, 0}, {0, 0, 0}, size / 3}, 2}});
        EXPECT_EQ(seen(b.scene, {0, 5 * size, 0}, {0, 0, 0}), gray);
        EXPECT_EQ(seen(b.scene, {0.1 * size, -5 * size, 0}, {0.1 * size, 0, 0}), gray);
        EXPECT_EQ(seen(b.scene, {0.5 * size, 5 * size, 0}, {0.5 * size, 0, 0}), red);
        EXPECT_EQ(seen(b.scene, {size, 2 * size, 0.1 * size}, {-size / 4, -size / 2, 0}), green);
    }
}

TEST(Composite, ACutterThatEndsBeforeTheFaceLeavesASkinAndOneBeyondNone) {
    for (int k = 1; k <= 15; ++k) {
        const double gap = std::ldexp(1.0, -3 * k);
        for (const double end : {-gap, 0.0, gap}) {
            Bodies b;
            b.make(Kind::subtract, {{Box{{-1, -1, -1}, {1, 0, 1}}, 1},
                                    {Cylinder{{0, -1, 0}, {0, end, 0}, 0.5}, 2}});
            EXPECT_EQ(seen(b.scene, {0.1, 3, 0.2}, {0.1, 0, 0.2}), end < 0 ? red : gray)
                << "2^-" << 3 * k << ' ' << end;
        }
    }
}

TEST(Composite, EqualBodiesSubtractToNothing) {
    const std::vector<Shape> shapes{Sphere{{0.1, 0.2, 0.3}, 0.7}, Box{{-0.3, -1, -1}, {1, 1, 0.7}},
                                    Cylinder{{0, -1, 0.1}, {0.3, 1, 0}, 0.7},
                                    Cone{{0, -1, 0}, {0.1, 1, 0}, 0.8, 0.1}};
    for (const Affine<double>& map :
         {Affine<double>{}, turn_y(33), in_turn(turn_x(17), stretched(-1, 2, 0.3)),
          shift(0.1, 0.2, 0.3)}) {
        for (const Shape& shape : shapes) {
            Bodies b;
            b.make(Kind::subtract, {{shape, 1, map}, {shape, 2, map}});
            b.scene.cameras = {camera_along({2.1, 1.7, 6}, {0, 0, 0})};
            const Image image = picture(b.scene, 24, 18);
            for (int y = 0; y < 18; ++y)
                for (int x = 0; x < 24; ++x) EXPECT_EQ(image.pixel(x, y)[0], 0.5);
        }
    }
}

TEST(Composite, ALineWithinAFaceOfTwoEqualBodiesMeetsNothing) {
    for (const Shape& other : {Shape(Box{{-1, -1, -1}, {1, 1, 1}}), Shape(Plane{{1, 0, 0}, 1})}) {
        Bodies b;
        b.make(Kind::subtract, {{Box{{-1, -1, -1}, {1, 1, 1}}, 1}, {other, 2}});
        EXPECT_EQ(seen(b.scene, {1, 0.2, 5}, {1, 0.2, 0}), gray);
        EXPECT_EQ(seen(b.scene, {5, 0.2, 0.1}, {0, 0.2, 0.1}), gray);
    }
}

TEST(Composite, GluedPartsAreOneBodyOfGlass) {
    const auto look = [](bool glued, const Affine<double>& map) {
        Bodies b;
        const std::uint32_t glass = add(b.scene, Material{.color = {0.9, 0.8, 0.7},
                                                          .ambient = 0,
                                                          .diffuse = 0,
                                                          .reflection = Color(0.2),
                                                          .filter = 0.8,
                                                          .ior = 1.5});
        show(b.scene, Box{{-9, -9, -9}, {9, 9, -8}}, glowing({0.3, 0.9, 0.4}));
        if (glued)
            b.make(Kind::unite,
                   {{Box{{-1, -1, -1}, {0.25, 1, 1}}, glass, map},
                    {Box{{0.25, -1, -1}, {1, 1, 1}}, glass, map},
                    {Box{{-0.5, -1, -1}, {0.5, 1, 0.5}}, glass, map}},
                   glass);
        else
            show(b.scene, Box{{-1, -1, -1}, {1, 1, 1}}, glass, map);
        b.scene.cameras = {camera_along({1.3, 1.7, 6}, {0, 0, 0})};
        return picture(b.scene, 40, 30);
    };
    for (const Affine<double>& map : {Affine<double>{}, turn_y(30)}) {
        const Image one = look(false, map);
        const Image three = look(true, map);
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 40; ++x)
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(one.pixel(x, y)[c], three.pixel(x, y)[c], 1e-12) << x << ' ' << y;
    }
}

TEST(Composite, TheFirstDeclaredOfTwoFacesShows) {
    const Box box{{-1, -1, -1}, {1, 1, 1}};
    const Box half{{-1, -1, -1}, {1, 0, 1}};
    for (const Kind kind : {Kind::unite, Kind::intersect}) {
        Bodies b;
        b.make(kind, {{box, 1}, {half, 2}});
        EXPECT_EQ(seen(b.scene, {0, -0.5, 5}, {0, -0.5, 0}), red);
        Bodies turned;
        turned.make(kind, {{half, 2}, {box, 1}});
        EXPECT_EQ(seen(turned.scene, {0, -0.5, 5}, {0, -0.5, 0}), green);
    }
}

TEST(Composite, AFaceThatIsNoFaceOfTheWholeNeverShows) {
    // The green box is cut away where it touches the red one.
    Bodies b;
    b.make(Kind::subtract, {{Box{{-1, -1, -1}, {1, 1, 1}}, 1}, {Box{{-1, -1, 1}, {1, 1, 2}}, 2}});
    EXPECT_EQ(seen(b.scene, {0, 0, 5}, {0, 0, 0}), red);
}

TEST(Composite, HalfSpacesMayMakeABodyWithoutAnEnd) {
    Bodies b;
    b.make(Kind::subtract, {{Plane{{0, 1, 0}, 0}, 1}, {Sphere{{0, 0, 0}, 1}, 2}});
    EXPECT_EQ(seen(b.scene, {0, 5, 0.1}, {0, 0, 0.1}), green);
    EXPECT_EQ(seen(b.scene, {0, 5, 2}, {0, 0, 2}), red);
    Bodies tilted;
    tilted.make(Kind::intersect, {{Plane{{1, 1, 0}, 0}, 1}, {Plane{{-1, 1, 0}, 0}, 2}});
    EXPECT_EQ(seen(tilted.scene, {1, 5, 0}, {1, 0, 0}), red);
    EXPECT_EQ(seen(tilted.scene, {-1, 5, 0}, {-1, 0, 0}), green);
}

TEST(Composite, ALensBringsLightTogetherWhereTheLensmakerSays) {
    // Two balls of radius R, thickness d: 1/f = (n - 1)(2/R - (n - 1) d / (n R^2)).
    constexpr double n = 1.5;
    constexpr double radius = 4;
    constexpr double d = 0.5;
    constexpr double power = (n - 1) * (2 / radius - (n - 1) * d / (n * radius * radius));
    const double f = 1 / power;
    const double principal = d / 2 - f * (n - 1) * d / (n * radius);  // from the middle
    Bodies b;
    const std::uint32_t glass =
        add(b.scene, Material{.ambient = 0, .diffuse = 0, .transmission = 1, .ior = n});
    b.make(Kind::intersect,
           {{Sphere{{0, 0, d / 2 - radius}, radius}, glass},
            {Sphere{{0, 0, radius - d / 2}, radius}, glass}},
           glass);
    // A ray at height h meets the axis at the focal point: a needle of light behind it is seen.
    const double focus = -(principal + f);
    for (const double h : {1e-4, 3e-5}) {
        const double spread = 8 * h * h * h;  // spherical aberration grows with the third power
        Scene scene = b.scene;
        show(scene, Box{{-1, -spread, focus - 1}, {1, spread, focus}}, glowing({0, 0, 1}));
        EXPECT_EQ(seen(scene, {0, h, 10}, {0, h, 0}).z, 1) << h;
    }
}

}  // namespace
}  // namespace lancer
