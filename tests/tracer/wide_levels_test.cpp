// Rays side by side give the same bytes and the same counts of rays as one at a time.
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

/// Glass that touches, overlaps, contains other glass and opaque bodies, stands on the ground and
/// on other glass, with several indices, one of them that of air; balls, boxes and shapes that only
/// scalar code handles.
Scene glassware(unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double a, double b) {
        return a + (b - a) * (static_cast<double>(random()) / 4294967296.0);
    };
    Stage s;
    s.scene.width = 48;
    s.scene.height = 36;
    s.scene.background = Color(0.2, 0.3, 0.5);
    if (random() % 3 == 0)
        s.scene.sky = Gradient{{0.2, 1, 0.1}, {{0, {1, 0.8, 0.6}}, {1, {0.2, 0.3, 0.9}}}};
    s.scene.settings.max_depth = 2 + static_cast<int>(random() % 7);
    s.look({between(-2, 2), between(0.5, 3), between(6, 8)}, {0, 0.7, 0}, 45);
    s.lamp({between(2, 5), between(3, 6), between(0, 5)});
    if (random() % 2 == 0) s.lamp({between(-1, 1), between(0.2, 1.5), 0.5}, {0.3, 0.4, 0.2});
    if (random() % 2 == 0) s.sun({between(-1, 1), -1, 0}, {0.3, 0.2, 0.1});
    s.add(Plane{{0, 1, 0}, 0}, s.matt({0.6, 0.5, 0.4}));
    Material shiny;
    shiny.fresnel = true;
    shiny.reflection = Color(0.9, 0.8, 1);
    shiny.ior = 1.4;
    shiny.phong = 0.3;
    std::vector<std::uint32_t> opaque{s.matt({0.2, 0.9, 0.3}), s.mirror()};
    if (random() % 3 == 0) opaque.push_back(s.material(shiny));
    std::vector<std::uint32_t> glass{s.glass(1.5), s.glass(1.3, {0.9, 0.5, 0.7})};
    Material polished = s.scene.materials[s.glass(1.7, {0.8, 1, 1})];
    polished.fresnel = random() % 2 == 0;
    polished.reflection = Color(0.3, 0.2, 0.4);
    polished.phong = 0.5;
    polished.filter = 0.3;
    polished.transmission = 0.4;
    polished.diffuse = 0.5;
    glass.push_back(s.material(polished));
    if (random() % 3 == 0) glass.push_back(s.glass(1));
    if (random() % 3 == 0) {
        Material deep = s.scene.materials[glass[0]];
        deep.absorption = Color(0.5, 0.1, 0.2);
        glass.push_back(s.material(deep));
    }
    const auto some = [&](const std::vector<std::uint32_t>& of) {
        return of[random() % of.size()];
    };
    for (int i = 0; i < 10; ++i) {
        const Vec3d at(between(-2, 2), between(0, 1.5), between(-2, 2));
        const double radius = between(0.1, 0.6);
        switch (random() % 8) {
            case 0:  // in each other, more than are tracked side by side
                for (int k = 0; k < 7; ++k) s.add(Sphere{at, radius * (1 - 0.1 * k)}, some(glass));
                break;
            case 1:  // one holds an opaque one, which it touches
                s.add(Sphere{at, radius}, some(glass));
                s.add(Sphere{at + Vec3d(0, radius / 2, 0), radius / 2}, some(opaque));
                break;
            case 2:  // glued, and one twice
                s.add(Box{at, at + Vec3d(radius, 0.5, 0.5)}, glass[0]);
                s.add(Box{at + Vec3d(radius, 0, 0), at + Vec3d(2 * radius, 0.5, 0.5)}, glass[0]);
                s.add(Sphere{at, radius / 2}, glass[1]);
                s.add(Sphere{at, radius / 2}, glass[1]);
                break;
            case 3:
                s.add(Box{{at.x, 0, at.z}, {at.x + radius, radius, at.z + radius}}, some(glass));
                break;
            case 4:
                s.add(Cylinder{at, at + Vec3d(0.1, radius, 0), radius / 3}, some(glass));
                break;
            case 5:
                s.add(Sphere{at, radius}, some(opaque));
                break;
            default:
                s.add(Sphere{{at.x, radius, at.z}, radius}, some(glass));
                s.add(Sphere{{at.x + 2 * radius, radius, at.z}, radius}, some(glass));
        }
        if (random() % 8 == 0) s.scene.objects.back().casts_shadow = false;
    }
    return s.scene;
}

TEST(WideLevels, GlassIsTheSame) {
    int wide = 0;
    for (unsigned seed = 1; seed <= 40; ++seed)
        wide += expect_same_on_all_levels(glassware(seed), "seed " + std::to_string(seed));
    EXPECT_GE(wide, supported_wide_levels().empty() ? 0 : 35) << "too few went side by side";
}

/// More rays of a level than a wave can hold, and more sums than a tile can keep: the rest is
/// traced one by one.
TEST(WideLevels, GlassWithMoreRaysThanThereIsRoomForIsTheSame) {
    Stage s;
    s.scene.width = s.scene.height = 16;
    s.scene.settings.max_depth = 20;
    s.scene.settings.min_contribution = 0;
    s.look({0, 0.5, 6}, {0, 0.5, 0}, 20);
    s.lamp({1, 5, 2});
    Material half = s.scene.materials[s.glass(1.5)];
    half.reflection = Color(0.5);
    const std::uint32_t material = s.material(half);
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y) s.add(Sphere{{x * 1.0, 0.5 + y, 0}, 0.49}, material);
    EXPECT_TRUE(expect_same_on_all_levels(s.scene, "full") || supported_wide_levels().empty());
}

/// Mirrored rays that start next to the surface, lights on it, very large and very small bodies:
/// lanes become unsure.
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
