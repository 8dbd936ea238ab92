// Thin things, small gaps, and no gap at all.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/extremes/picture.h"

namespace lancer::extremes {
namespace {

const Color floor_color{0.9, 0.8, 0.7};

Stage lit_floor() {
    Stage s;
    s.look({0.3, 3.2, 4.1}, {0, 0, 0}, 40);
    s.lamp({2, 5, 3});
    s.scene.background = {0.1, 0.2, 0.4};
    return s;
}

TEST(Thin, SlabOfNoThicknessIsStillThere) {
    Stage s = lit_floor();
    s.add(Plane{{0, 1, 0}, 0}, s.matt(floor_color));
    s.add(Box{{-0.75, 1, -0.75}, {0.75, 1, 0.75}}, s.matt({0.9, 0.1, 0.1}));
    Stage thick = lit_floor();
    thick.add(Plane{{0, 1, 0}, 0}, thick.matt(floor_color));
    thick.add(Box{{-0.75, 1, -0.75}, {0.75, 1 + 1e-9, 0.75}}, thick.matt({0.9, 0.1, 0.1}));
    EXPECT_EQ(wrong(picture(s.scene), picture(thick.scene)), 0);
}

/// A receiver seen from behind, lit through: its picture is the shadow on its other side, where an
/// occluder floats 10^-k above it.
TEST(Gap, ContactShadow) {
    const auto scene = [](const std::string& floor, double gap) {
        Stage s;
        Material m;
        m.ambient = 0;
        m.diffuse = 0;
        m.diffuse_transmission = 1;
        const std::uint32_t paper = s.material(m);
        if (floor == "plane") s.add(Plane{{0, 1, 0}, 0}, paper);
        if (floor == "box") s.add(Box{{-9, -1, -9}, {9, 0, 9}}, paper);
        if (floor == "cylinder") s.add(Cylinder{{0, -1, 0}, {0, 0, 0}, 9}, paper);
        if (floor == "mesh") s.add(cube({-9, -1, -9}, {9, 0, 9}), paper);
        if (floor == "triangle")
            s.add(Triangle{{Vec3d(-30, 0, -30), Vec3d(30, 0, -30), Vec3d(0, 0, 40)}}, paper);
        if (floor == "sphere") {
            s.add(Sphere{{0, -1, 0}, 1}, paper);
            if (gap > 0) s.add(Sphere{{0, -1, 0}, 1 + gap}, paper);
        } else if (gap > 0) {
            s.add(Box{{-9, gap, -9}, {9, gap + 0.5, 9}}, paper);
        }
        s.lamp({0.5, 4, 1});
        s.look({0.1, -0.75, 0.2}, {0, 0, 0.1}, 20, {0, 0, 1});
        return s.scene;
    };
    for (const char* floor : {"plane", "box", "cylinder", "mesh", "triangle", "sphere"}) {
        EXPECT_GT(wrong(picture(scene(floor, 0)), Color(0, 0, 0)), 12000) << floor;
        for (int k = 1; k <= 14; ++k)
            EXPECT_EQ(wrong(picture(scene(floor, power10(-k))), Color(0, 0, 0)), 0)
                << floor << " " << k;
    }
}

/// Every order of the objects gives the same picture.
void expect_any_order(Scene scene, const char* what) {
    std::vector<std::size_t> order(scene.objects.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const std::vector<Object> objects = scene.objects;
    const Image reference = picture(scene);
    while (std::next_permutation(order.begin(), order.end())) {
        for (std::size_t i = 0; i < order.size(); ++i) scene.objects[i] = objects[order[i]];
        EXPECT_EQ(wrong(picture(scene), reference), 0) << what;
    }
}

TEST(NoGap, GluedGlassIsOneBlock) {
    for (const double angle : {0.0, 37.0}) {
        const Affine<double> map = compose(turn(1, angle), turn(0, angle / 2));
        Stage one = lit_floor();
        one.add(Plane{{0, 1, 0}, -1}, one.matt(floor_color));
        one.add(Sphere{{0.2, -0.6, -0.4}, 0.4}, one.matt({0.9, 0.2, 0.1}));
        const Stage empty = one;
        one.add(Box{{-1, 0, -1}, {1, 0.5, 1}}, one.glass(1.5, {0.8, 1, 0.9}), map);
        const Image reference = picture(one.scene);
        for (const int n : {2, 3, 8, 32}) {
            Stage s = empty;
            for (int i = 0; i < n; ++i) {
                // The tint of the whole block, distributed over its outer surfaces; the inner ones
                // have none.
                const std::uint32_t m = s.glass(1.5, {1, 1, 1});
                s.add(Box{{-1, 0.5 * i / n, -1}, {1, 0.5 * (i + 1) / n, 1}}, m, map);
            }
            Stage clear = empty;
            clear.add(Box{{-1, 0, -1}, {1, 0.5, 1}}, clear.glass(1.5), map);
            EXPECT_EQ(wrong(picture(s.scene), picture(clear.scene)), 0) << n << " at " << angle;
        }
        EXPECT_GT(wrong(reference, picture(empty.scene)), 1000);
    }
}

TEST(NoGap, GluedAndRestingSolidsInEveryOrder) {
    for (const double angle : {0.0, 37.0}) {
        const Affine<double> map = compose(turn(1, angle), turn(2, angle / 3));
        for (const char* solid : {"box", "mesh", "cylinder"}) {
            Stage s = lit_floor();
            s.scene.width = 64;
            s.scene.height = 48;
            const std::uint32_t ground = s.matt(floor_color);
            const std::uint32_t glass = s.glass(1.5);
            s.add(Plane{{0, 1, 0}, 0}, ground, map);
            const std::string name = solid;
            const auto put = [&](double x) {
                if (name == "box") s.add(Box{{x, 0, -0.5}, {x + 0.75, 0.5, 0.5}}, glass, map);
                if (name == "mesh") s.add(cube({x, 0, -0.5}, {x + 0.75, 0.5, 0.5}), glass, map);
                if (name == "cylinder") s.add(Cylinder{{x, 0, 0}, {x, 0.5, 0}, 0.375}, glass, map);
            };
            put(-0.75);
            put(0);
            expect_any_order(s.scene, solid);
            // The floor shows through the glass in almost every pixel: no pixel is the sky's.
            const Image image = picture(s.scene);
            const Image extended = picture(s.scene, Precision::extended);
            EXPECT_EQ(wrong(image, extended), 0) << solid << " " << angle;
            // A tiny gap causes total reflection; touching surfaces must not.
            Stage sunk = s;
            for (std::size_t i = 1; i < 3; ++i) {
                const Affine<double> down = compose(map, shift({0, -1e-9, 0}));
                sunk.scene.objects[i].transform =
                    static_cast<std::uint32_t>(sunk.scene.transforms.size());
                sunk.scene.transforms.push_back(down);
            }
            EXPECT_EQ(wrong(picture(sunk.scene), image), 0) << solid << " sunk " << angle;
        }
    }
}

}  // namespace
}  // namespace lancer::extremes
