// Pictures of patches on their true surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/tracer/splines/random_patch.h"
#include "tracer/render.h"

namespace lancer {
namespace {

Scene lit(const Patch& patch) {
    Scene scene;
    scene.settings.min_contribution = 0;
    scene.patches.push_back(patch);
    Object object;
    object.shape = PatchRef{0};
    scene.objects.push_back(object);
    Camera camera;
    camera.position = {0.5, 3, 2};
    camera.look_at = {0, 0, 0};
    camera.projection = PerspectiveProjection{30};
    scene.cameras.push_back(camera);
    Light light;
    light.kind = PointLight{{3, 4, 1}, {}};
    scene.lights.push_back(light);
    return scene;
}

Image picture(const Scene& scene, int size = 120) {
    RayCounts counts;
    return compile(scene, scene.settings)->render({0, size, size, {}, false}, {}, counts);
}

int different(const Image& a, const Image& b, double by) {
    int count = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i) count += std::abs(a.data[i] - b.data[i]) > by;
    return count;
}

TEST(TruePatch, ShadowsAreThoseOfLongDouble) {
    // Shadows of a patch on itself: a ray that starts on it must not meet it at its start.
    for (unsigned seed = 0; seed < 6; ++seed) {
        Scene scene = lit(random_patch(seed, 3, seed % 2 + 0.5));
        scene.lights.front().kind = PointLight{{3, 0.8, 1}, {}};
        const Image image = picture(scene);
        scene.settings.precision = Precision::extended;
        EXPECT_LE(different(image, picture(scene), 1e-6), 0) << seed;
    }
}

TEST(TruePatch, IsWhatFinerAndFinerTrianglesShow) {
    Scene scene = lit(random_patch(2, 3, 1));
    const Image truth = picture(scene);
    double before = 1;
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        scene.settings.tolerance = tolerance;
        const Image image = picture(scene);
        double sum = 0;
        for (std::size_t i = 0; i < image.data.size(); ++i)
            sum += std::pow(image.data[i] - truth.data[i], 2);
        const double rmse = std::sqrt(sum / static_cast<double>(image.data.size()));
        EXPECT_LT(rmse, before / 2) << tolerance;
        EXPECT_GT(rmse, 0);
        before = rmse;
    }
    EXPECT_LT(before, 1e-3);
}

TEST(TruePatch, ScalingChangesNothing) {
    Scene scene = lit(random_patch(2, 3, 1));
    const Image truth = picture(scene);
    for (const int exponent : {-100, -30, 30, 100}) {
        Scene other = scene;
        const double factor = std::ldexp(1.0, exponent);
        for (Vec3d& p : other.patches[0].control) p *= factor;
        other.cameras[0].position *= factor;
        other.lights[0].kind = PointLight{Vec3d(3, 4, 1) * factor, {}};
        EXPECT_EQ(picture(other).data, truth.data) << exponent;
    }
}

TEST(TruePatch, TheSameBytesForAnyNumberOfThreads) {
    Scene scene = lit(random_patch(2, 3, 1));
    scene.settings.threads = 1;
    const Image one = picture(scene);
    scene.settings.threads = 7;
    EXPECT_EQ(picture(scene).data, one.data);
}

TEST(TruePatch, AColouredPaneTintsOnce) {
    // Flat, so that everything behind it shows the same colour: at the pieces' borders too.
    Patch pane;
    for (int i = 0; i < 16; ++i) pane.control.emplace_back((i % 4) * 2 - 3, 0, (i / 4) * 2 - 3);
    // Uneven, so that it is cut into pieces.
    for (int i : {5, 6, 9, 10}) pane.control[static_cast<std::size_t>(i)] *= 0.2;
    Scene scene = lit(pane);
    scene.background = {1, 1, 1};
    Material& tinted = scene.materials[0];
    tinted.ambient = tinted.diffuse = 0;
    tinted.filter = 1;
    tinted.color = {0.5, 0.25, 0.125};
    scene.cameras[0].position = {0, 4, 0};
    scene.cameras[0].up = {0, 0, 1};
    scene.cameras[0].projection = OrthographicProjection{2};
    const Image image = picture(scene, 129);  // its middle row and column on the pieces' borders
    const double* first = image.pixel(0, 0);
    EXPECT_NEAR(first[0], 0.5, 1e-12);
    for (int y = 0; y < 129; ++y) {
        for (int x = 0; x < 129; ++x) EXPECT_EQ(image.pixel(x, y)[0], first[0]) << x << " " << y;
    }
}

TEST(TruePatch, DegeneratePatchesAreMetInFiniteTime) {
    std::mt19937 generator(8);
    std::uniform_int_distribution<int> which(0, 15);
    for (unsigned round = 0; round < 60; ++round) {
        Patch patch = random_patch(round, 3, 1);
        for (unsigned k = 0; k < round % 15; ++k)
            patch.control[static_cast<std::size_t>(which(generator))] =
                patch.control[static_cast<std::size_t>(which(generator))];
        for (const double value : picture(lit(patch), 40).data) ASSERT_TRUE(std::isfinite(value));
    }
    // Seen exactly edge-on, and along its rulings.
    for (const bool bent : {false, true}) {
        Patch sheet;
        for (int i = 0; i < 16; ++i)
            sheet.control.emplace_back(i % 4 - 1.5, bent ? (i % 4 == 0 || i % 4 == 3 ? 0 : 1) : 0,
                                       i / 4 - 1.5);
        Scene scene = lit(sheet);
        scene.cameras[0].position = {0, 0, 5};
        scene.cameras[0].projection = OrthographicProjection{3};
        for (const double value : picture(scene, 41).data) ASSERT_TRUE(std::isfinite(value));
    }
}

}  // namespace
}  // namespace lancer
