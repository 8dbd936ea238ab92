// Rays side by side bring the same bytes, and count the same rays, as one at a time.
#include <gtest/gtest.h>

#include <random>

#include "tests/extremes/random_scene.h"
#include "tests/extremes/stage.h"
#include "tests/tracer/supported_levels.h"

namespace lancer {
namespace {

using namespace extremes;

Scene opaque(Scene scene) {
    for (Material& m : scene.materials) {
        m.filter = m.transmission = 0;
        m.ior = m.fresnel ? m.ior : 1;
        m.absorption = Color(0);
    }
    return scene;
}

/// Balls that touch, mirror each other and stand in each other, on planes that meet.
Scene crowd(unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double a, double b) {
        return a + (b - a) * (static_cast<double>(random()) / 4294967296.0);
    };
    Stage s;
    s.scene.width = 80;
    s.scene.height = 60;
    s.look({between(-3, 3), between(1, 4), between(4, 9)}, {0, 0.7, 0}, 50);
    s.lamp({between(2, 5), between(4, 8), between(0, 5)});
    if (random() % 2 == 0) s.sun({between(-1, 1), -1, 0}, {0.4, 0.3, 0.5});
    s.add(Plane{{0, 1, 0}, 0}, s.matt({0.6, 0.5, 0.4}));
    if (random() % 2 == 0) s.add(Plane{{0, 0, 1}, -3}, s.mirror());
    std::vector<std::uint32_t> materials{s.mirror(), s.matt({0.2, 0.9, 0.3})};
    Material glossy;
    glossy.phong = 0.4;
    glossy.blinn = 0.3;
    glossy.reflection = Color(0.3, 0.6, 0.2);
    materials.push_back(s.material(glossy));
    double x = -2;
    for (int i = 0; i < 40; ++i) {
        const double radius = std::ldexp(1.0, -static_cast<int>(random() % 5)) * 0.5;
        const std::uint32_t material = materials[random() % materials.size()];
        if (i < 6) {  // in a row, each on the plane, each touching the next
            s.add(Sphere{{x, 0.25, 1}, 0.25}, material);
            x += 0.5;
        } else {
            s.add(
                Sphere{{between(-3, 3), random() % 2 == 0 ? radius : between(0, 2), between(-3, 3)},
                       radius},
                material);
        }
    }
    if (random() % 4 == 0) s.add(Sphere{{0, 0, 0}, 50}, s.matt({0.3, 0.4, 0.9}));
    return s.scene;
}

TEST(WideLevels, RandomScenesAreTheSame) {
    int wide = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        for (const Scene& scene : {opaque(random_anything(seed)), random_anything(seed),
                                   random_scene(seed), crowd(seed)})
            wide += expect_same_on_all_levels(scene, "seed " + std::to_string(seed));
    }
    EXPECT_GE(wide, supported_wide_levels().empty() ? 0 : 200) << "too few went side by side";
}

TEST(WideLevels, SamplesCropsAndExtraChannelsAreTheSame) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        Scene scene = seed % 2 == 0 ? crowd(seed) : opaque(random_anything(seed));
        scene.settings.samples = 1 + static_cast<int>(seed % 4);
        if (seed % 3 == 0) scene.settings.sampling = Sampling::sobol;
        scene.settings.max_depth = 1 + static_cast<int>(seed % 5);
        scene.settings.shadows = seed % 5 != 0;
        View view{0, scene.width, scene.height, Crop{5, 7, 37, 21}, seed % 4 == 0};
        expect_same_on_all_levels(scene, "seed " + std::to_string(seed), view);
    }
}

TEST(WideLevels, AProbeAndAPointTellWhatThePictureShows) {
    for (const Level level : supported_wide_levels()) {
        const Scene scene = crowd(3);
        const auto renderer = compile(scene, scene.settings, level);
        const View view{0, scene.width, scene.height, {}, false};
        RayCounts counts;
        const Image image = renderer->render(view, {}, counts);
        RayCounts counts_of_points;
        const TraceLimits limits{scene.settings.max_depth, scene.settings.min_contribution};
        std::vector<PicturePoint> points;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) points.push_back({x + 0.5, y + 0.5});
        std::vector<Color> colors(points.size());
        renderer->trace(view, points, limits, colors, {}, counts_of_points);
        EXPECT_EQ(counts_of_points.rays(), counts.rays());
        std::uint64_t rays = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Probe probe = renderer->probe(view, points[i].x, points[i].y);
            const double* pixel = image.data.data() + 3 * i;
            const Color shown(pixel[0], pixel[1], pixel[2]);
            EXPECT_EQ(probe.color, shown) << name_of(level) << " " << i;
            EXPECT_EQ(colors[i], shown) << name_of(level) << " " << i;
            rays += probe.rays;
        }
        EXPECT_EQ(rays, counts.rays());
    }
}

/// Seen from outside and inside, mirrored in themselves, through frames that turn and squeeze.
TEST(WideLevels, MeshesAreTheSame) {
    for (int i = 0; i < 6; ++i) {
        Stage s;
        s.look(i % 3 == 2 ? Vec3d(0.1, 0.9, 0.2) : Vec3d(1, 2, 5), {0, 0.8, 0}, 60);
        s.lamp({3, 5, 2});
        s.lamp({0.2, 1.1, 0.1}, {0.3, 0.3, 0.4});
        s.add(Plane{{0, 1, 0}, -0.25}, s.matt({0.5, 0.6, 0.4}));
        Material glossy;
        glossy.reflection = Color(0.5);
        glossy.phong = 0.5;
        const Affine<double> map =
            i == 0 ? Affine<double>{}
                   : compose(shift({0.1 * i, 0, 0}),
                             compose(turn(i % 3, 31.0 * i), stretched(1, i < 3 ? 1 : 0.3, 2)));
        s.add(icosphere({0, 1, 0}, 0.75, 4), s.material(glossy), map);
        s.add(cube({-2, 0, -1}, {-1, 1, 0.5}), s.mirror(), map);
        for (Object& object : s.scene.objects)
            if (auto* mesh = std::get_if<MeshRef>(&object.shape)) mesh->smooth = i % 2 == 1;
        EXPECT_TRUE(expect_same_on_all_levels(s.scene, std::to_string(i)) ||
                    supported_wide_levels().empty());
    }
}

/// Starts of mirrored rays next to the surface, lights in it, giants and specks: lanes are unsure.
TEST(WideLevels, WhatIsUnsureIsTheSame) {
    for (const double size : {1e-9, 1e-4, 1.0, 1e5}) {
        Stage s;
        s.look({0, 1.5, 6}, {0, 0.5, 0}, 45);
        s.lamp({1, 1, 1});
        s.lamp({0, 0, 2}, {0.3, 0.2, 0.1});  // on the plane
        s.add(Plane{{0, 1, 0}, 0}, s.mirror());
        s.add(Sphere{{0, -1e6, 0}, 1e6}, s.matt({1, 0, 0}));  // touches it from below
        s.add(Sphere{{1, 1, 1}, 0.5}, s.mirror());            // around the light
        s.add(Sphere{{-1, size, 0}, size}, s.mirror());
        s.add(Sphere{{-1, size, 0}, size}, s.matt({0, 1, 0}));  // twice
        expect_same_on_all_levels(s.scene, "size " + std::to_string(size));
    }
}

}  // namespace
}  // namespace lancer
