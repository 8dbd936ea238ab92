// What holds for pictures as a whole.
#include "tracer/render.h"

#include <gtest/gtest.h>

#include "model/sobol.h"
#include "tests/reference/pov/pair_scenes.h"

namespace lancer {
namespace {

Image render_with(const Scene& scene, int threads, std::optional<Crop> crop, RayCounts& counts) {
    Settings settings = scene.settings;
    settings.threads = threads;
    return compile(scene, settings)->render({0, 61, 47, crop, false}, {}, counts);
}

TEST(Render, MakesTheSameBytesAndCountsForAnyNumberOfThreads) {
    const Scene scene = reference::glass_nested_scene();
    RayCounts counts[3];
    const Image one = render_with(scene, 1, {}, counts[0]);
    const Image two = render_with(scene, 2, {}, counts[1]);
    const Image seven = render_with(scene, 7, {}, counts[2]);
    EXPECT_EQ(one.data, two.data);
    EXPECT_EQ(one.data, seven.data);
    EXPECT_EQ(counts[0].primary, 61u * 47u);
    EXPECT_EQ(counts[0].shadow, counts[2].shadow);
    EXPECT_EQ(counts[0].transmitted, counts[2].transmitted);
    EXPECT_GT(counts[0].transmitted, 0u);
    EXPECT_EQ(counts[0].media_lost, 0u);
}

TEST(Render, ACropIsThatPartOfThePicture) {
    const Scene scene = reference::solids_scene();
    RayCounts counts;
    const Image whole = render_with(scene, 1, {}, counts);
    const Image part = render_with(scene, 1, Crop{13, 9, 30, 21}, counts);
    ASSERT_EQ(part.width, 30);
    ASSERT_EQ(part.height, 21);
    for (int y = 0; y < 21; ++y) {
        for (int x = 0; x < 30; ++x) {
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(part.pixel(x, y)[c], whole.pixel(x + 13, y + 9)[c]);
        }
    }
}

TEST(Render, AProbeAtAPixelsCentreIsThePixel) {
    const Scene scene = reference::solids_scene();
    const auto renderer = compile(scene, scene.settings);
    RayCounts counts;
    const View view{0, 61, 47, {}, false};
    const Image whole = renderer->render(view, {}, counts);
    for (const auto& [x, y] : {std::pair{5, 40}, {30, 20}, {44, 31}}) {
        const Probe probe = renderer->probe(view, x + 0.5, y + 0.5);
        EXPECT_EQ(probe.color.x, whole.pixel(x, y)[0]);
        EXPECT_EQ(probe.color.y, whole.pixel(x, y)[1]);
    }
    EXPECT_EQ(renderer->probe(view, 1.5, 1.5).object, 0u) << "the ground is declared first";
}

/// Looks along -z at the origin from a distance.
Scene little_scene() {
    Scene scene;
    Camera camera;
    camera.position = {0, 0, 5};
    camera.look_at = {0, 0, 0};
    camera.projection = OrthographicProjection{2};
    scene.cameras.push_back(camera);
    scene.background = {0.25, 0.5, 0.75};
    return scene;
}

TEST(Render, ASkyIsSeenByDirectionAndInMirrors) {
    Scene scene = little_scene();
    scene.cameras[0].projection = PerspectiveProjection{90};
    scene.sky =
        Gradient{{0, 3, 0}, {{-0.5, {1, 0, 0}}, {0, {0, 1, 0}}, {0, {0, 0, 1}}, {1, {0, 0, 0}}}};
    const auto renderer = compile(scene, scene.settings);
    const View view{0, 8, 8, {}, false};
    const auto seen = [&](double y) { return renderer->probe(view, 4, y).color; };
    EXPECT_EQ(seen(4), Color(0, 0, 1)) << "the upper side of a step holds it";
    const double down = std::sin(std::atan(0.25));
    EXPECT_NEAR(seen(5).x, down / 0.5, 1e-14);
    EXPECT_NEAR(seen(5).y, 1 - down / 0.5, 1e-14);
    EXPECT_EQ(seen(8), Color(1, 0, 0)) << "beyond the last stop its colour goes on";
    EXPECT_NEAR(seen(3).z, 1 - down, 1e-14);

    Material mirror;
    mirror.ambient = mirror.diffuse = 0;
    mirror.reflection = {1, 1, 1};
    scene.materials.push_back(mirror);
    Object wall;
    wall.shape = Plane{{0, 1, 1}, 0};
    wall.material = 1;
    scene.objects.push_back(wall);
    RayCounts counts[2];
    Image pictures[2];
    int i = 0;
    for (const Level level : {Level::scalar, best_level()}) {
        pictures[i] = compile(scene, scene.settings, level)->render(view, {}, counts[i]);
        ++i;
    }
    EXPECT_EQ(pictures[0].data, pictures[1].data);
    const Color up = compile(scene, scene.settings)->probe(view, 4, 4).color;
    EXPECT_NEAR(up.z, 0, 1e-12) << "straight up";
}

TEST(Render, WhatHitsNothingIsTransparentAndGlassAsFarAsLightPasses) {
    Scene scene = little_scene();
    Material sheet;
    sheet.color = {1, 0.5, 0};
    sheet.ambient = sheet.diffuse = 0;
    sheet.emission = {0.5, 0.5, 0.5};
    sheet.filter = 0.6;
    Material solid;
    solid.emission = {1, 1, 1};
    solid.ambient = solid.diffuse = 0;
    Material ball = sheet;
    ball.emission = {0, 0, 0};
    ball.ior = 1.5;
    scene.materials = {Material{}, sheet, solid, ball};
    const auto put = [&](const Shape& shape, std::uint32_t material) {
        Object object;
        object.shape = shape;
        object.material = material;
        scene.objects.push_back(object);
    };
    const auto look = [&] {
        RayCounts counts;
        View view{0, 4, 4, {}, false};
        view.alpha = true;
        return compile(scene, scene.settings)->render(view, {}, counts);
    };
    put(Box{{0, -1, -1}, {1, 0, -0.5}}, 2);  // the lower right quarter
    Image image = look();
    ASSERT_EQ(image.channels, 4);
    EXPECT_EQ(image.pixel(0, 0)[3], 0) << "opaque worlds have a recursion of their own";
    EXPECT_EQ(image.pixel(0, 0)[0], 0) << "the background is left out";
    EXPECT_EQ(image.pixel(3, 3)[3], 1);
    EXPECT_EQ(image.pixel(3, 3)[0], 1);
    put(Triangle{{Vec3d(-9, -9, 1), Vec3d(9, -9, 1), Vec3d(0, 18, 1)}}, 1);
    image = look();
    const double passes = 0.6 * (1 + 0.5 + 0) / 3;
    EXPECT_NEAR(image.pixel(0, 0)[3], 1 - passes, 1e-14);
    EXPECT_NEAR(image.pixel(0, 0)[0], 0.5 * 0.4 / (1 - passes), 1e-14) << "not multiplied by alpha";
    EXPECT_EQ(image.pixel(3, 3)[3], 1);
    scene.objects.clear();
    put(Sphere{{0, 0, 0}, 0.9}, 3);
    image = look();
    EXPECT_EQ(image.pixel(0, 0)[3], 0);
    EXPECT_NEAR(image.pixel(1, 1)[3], 1 - 0.36 * (1 + 0.25) / 3, 1e-14) << "bent light counts";
}

TEST(Render, ColorsOfVerticesAreInterpolatedOnEveryLevel) {
    Scene scene = little_scene();
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
    mesh->faces = {{0, 1, 2}};
    mesh->colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 4}};
    scene.meshes.push_back(mesh);
    scene.textures.push_back({VertexColors{}, {}});
    Material painted;
    painted.texture = 0;
    painted.ambient = painted.diffuse = 0;
    painted.emission = {1, 1, 1};
    scene.materials = {painted};
    Object object;
    object.shape = MeshRef{0, false};
    scene.objects.push_back(object);
    const View view{0, 8, 8, {}, false};
    RayCounts counts;
    const Image scalar = compile(scene, scene.settings, Level::scalar)->render(view, {}, counts);
    const Image wide = compile(scene, scene.settings, best_level())->render(view, {}, counts);
    EXPECT_EQ(scalar.data, wide.data);
    const double* p = scalar.pixel(2, 3);  // at (-0.375, 0.125)
    EXPECT_NEAR(p[0], 1 - 0.625 / 4 - 1.125 / 4, 1e-14);
    EXPECT_NEAR(p[1], 0.625 / 4, 1e-14);
    EXPECT_NEAR(p[2], 4 * 1.125 / 4, 1e-14);
}

TEST(Render, TracedPointsAreThoseOfThePictureForAnyNumberOfThreads) {
    const Scene scene = reference::glass_nested_scene();
    const View view{0, 61, 47, {}, false};
    RayCounts counts;
    Settings settings = scene.settings;
    const Image whole = compile(scene, settings)->render(view, {}, counts);
    std::vector<PicturePoint> points;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) points.push_back({x + 0.5, y + 0.5});
    for (const int threads : {1, 7}) {
        settings.threads = threads;
        std::vector<Color> colors(points.size());
        RayCounts traced;
        compile(scene, settings)
            ->trace(view, points, {settings.max_depth, settings.min_contribution}, colors, {},
                    traced);
        for (std::size_t i = 0; i < points.size(); ++i)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(colors[i][c], whole.data[3 * i + static_cast<std::size_t>(c)]);
        EXPECT_EQ(traced.rays(), counts.rays());
    }
}

TEST(Render, TracedPointsKeepToTheirLimits) {
    const Scene scene = reference::glass_nested_scene();
    const View view{0, 61, 47, {}, false};
    Settings shallow = scene.settings;
    shallow.max_depth = 2;
    const auto renderer = compile(scene, scene.settings);
    const auto of_two_levels = compile(scene, shallow);
    int changed = 0;
    for (double y = 0.5; y < view.height; ++y) {
        for (double x = 0.5; x < view.width; ++x) {
            const PicturePoint point{x, y};
            Color color;
            RayCounts counts;
            renderer->trace(view, {&point, 1}, {2, shallow.min_contribution}, {&color, 1}, {},
                            counts);
            ASSERT_EQ(color, of_two_levels->probe(view, x, y).color);
            changed += color != renderer->probe(view, x, y).color;
        }
    }
    EXPECT_GT(changed, 50);
}

TEST(Render, SobolPointsAreThoseOfTheirPixelInAnyPart) {
    const Scene scene = reference::solids_scene();
    Settings settings = scene.settings;
    settings.samples = 3;
    settings.sampling = Sampling::sobol;
    const auto picture = [&](const std::optional<Crop>& crop) {
        RayCounts counts;
        return compile(scene, settings)->render({0, 61, 47, crop, false}, {}, counts);
    };
    const Image whole = picture({});
    const Image part = picture(Crop{13, 9, 30, 21});
    EXPECT_EQ(part.pixel(4, 5)[0], whole.pixel(17, 14)[0]);

    RayCounts counts;
    std::vector<PicturePoint> points;
    const SobolPoints sequence(pixel_key(0, 17, 14));
    for (std::uint32_t i = 0; i < 9; ++i)
        points.push_back({17 + sequence[i].x, 14 + sequence[i].y});
    std::vector<Color> colors(9);
    compile(scene, settings)
        ->trace({0, 61, 47, {}, false}, points, {settings.max_depth, settings.min_contribution},
                colors, {}, counts);
    Color sum{0, 0, 0};
    for (const Color& color : colors) sum += color;
    for (int c = 0; c < 3; ++c) EXPECT_EQ(whole.pixel(17, 14)[c], sum[c] / 9);

    settings.seed = 1;
    EXPECT_NE(picture({}).data, whole.data);
    settings.samples = 1;  // through the centre, whatever the seed
    const Image center = picture({});
    settings.sampling = Sampling::grid;
    EXPECT_EQ(picture({}).data, center.data);
}

TEST(Render, ThePrecisionsAgreeOffTheEdges) {
    const Scene scene = reference::solids_scene();
    RayCounts counts;
    const View view{0, 61, 47, {}, false};
    const auto picture = [&](Precision precision) {
        Settings settings = scene.settings;
        settings.precision = precision;
        return compile(scene, settings)->render(view, {}, counts);
    };
    const Image single = picture(Precision::single);
    const Image twofold = picture(Precision::double_);
    const Image extended = picture(Precision::extended);
    int single_off = 0;
    for (std::size_t i = 0; i < twofold.data.size(); ++i) {
        EXPECT_NEAR(twofold.data[i], extended.data[i], 1e-12);
        single_off += std::abs(twofold.data[i] - single.data[i]) > 1e-4;
    }
    EXPECT_LE(single_off, 6) << "only where an edge runs through a pixel's centre";
}

}  // namespace
}  // namespace lancer
