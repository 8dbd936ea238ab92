#include "accuracy/cut_bound.h"

#include <gtest/gtest.h>
#include <cmath>

#include "tests/tracer/scene_kit.h"

namespace lancer::accuracy {
namespace {

constexpr View one_pixel{0, 1, 1, {}, false};

/// A camera between two mirrors that face each other, in a dim light.
Scene two_mirrors(double reflection) {
    Scene scene;
    Material mirror;
    mirror.color = Color(0.5);
    mirror.ambient = 0.2;
    mirror.diffuse = 0;
    mirror.reflection = Color(reflection);
    const std::uint32_t material = kit::add(scene, mirror);
    kit::show(scene, Plane{{0, 0, 1}, -1}, material);
    kit::show(scene, Plane{{0, 0, -1}, -1}, material);
    scene.cameras = {kit::camera_along({0, 0, 0}, {0, 0, -1})};
    scene.settings.max_depth = 64;
    scene.settings.min_contribution = 0;
    return scene;
}

Color share_cut(const Scene& scene, const TraceLimits& limits) {
    const PicturePoint centre{0.5, 0.5};
    Color share;
    compile(scene, scene.settings)->cut_shares(one_pixel, {&centre, 1}, limits, {&share, 1}, {});
    return share;
}

TEST(MostLight, IsWhatMirrorsGatherInTheLimit) {
    // 0.1 at each surface, half of it kept: 0.1 + 0.05 + 0.025 ...
    EXPECT_NEAR(most_light(two_mirrors(0.5), 256).x, 0.2, 1e-15);
    EXPECT_NEAR(most_light(two_mirrors(0.5), 2).x, 0.15, 1e-15);
    EXPECT_NEAR(most_light(two_mirrors(1), 256).x, 25.6, 1e-12);
    EXPECT_TRUE(std::isinf(most_light(two_mirrors(100), 256).x));
}

TEST(MostLight, IsWhatIsBehindWhereNothingSendsMore) {
    Scene scene = two_mirrors(0.5);
    scene.background = {3, 0, 1};
    EXPECT_EQ(most_light(scene, 256).x, 3);
    EXPECT_NEAR(most_light(scene, 256).y, 0.2, 1e-15);
    scene.sky = Gradient{{0, 1, 0}, {{-1, {0, 7, 0}}, {1, {0, 0, 0}}}};
    EXPECT_EQ(most_light(scene, 256).y, 7);
}

TEST(MostLight, CountsLightsThatFadeTwice) {
    Scene scene;
    Material matt;
    matt.ambient = 0;
    matt.diffuse = 1;
    kit::show(scene, Sphere{}, matt);
    scene.lights.push_back({PointLight{{0, 5, 0}, {}}, Color(1), true, {}});
    EXPECT_EQ(most_light(scene, 256).x, 1);
    scene.lights.push_back({PointLight{{0, 5, 0}, Fade{}}, Color(1), true, {}});
    EXPECT_EQ(most_light(scene, 256).x, 3);
}

TEST(MostLight, KnowsNothingOfMaterialsThatNothingWears) {
    Scene scene = two_mirrors(0.5);
    Material bright;
    bright.emission = Color(100);
    kit::add(scene, bright);
    EXPECT_NEAR(most_light(scene, 256).x, 0.2, 1e-15);
}

TEST(CutShares, AreTheFactorsOfWhatIsNotFollowed) {
    const Scene scene = two_mirrors(0.5);
    EXPECT_EQ(share_cut(scene, {1, 0}).x, 0.5);
    EXPECT_EQ(share_cut(scene, {4, 0}).x, 0.0625);
    EXPECT_EQ(share_cut(scene, {64, 0.1}).x, 0.0625);  // 0.125 is followed
}

TEST(CutShares, AreNothingWhereNothingGoesOn) {
    EXPECT_EQ(share_cut(two_mirrors(0), {1, 0}).x, 0);
}

/// A plate of green glass in which a ray from inside is totally reflected: its weight is tinted,
/// its light is not.
TEST(CutShares, AreNotTintedByTotalReflection) {
    Scene scene;
    Material glass;
    glass.filter = 1;
    glass.color = {0.25, 0.5, 0.25};
    glass.ior = 1.5;
    kit::show(scene, Box{{-100, -1, -100}, {100, 1, 100}}, glass);
    scene.cameras = {kit::camera_along({0, 0, 0}, {1, 0.1, 0})};
    scene.settings.max_depth = 64;
    const Color share = share_cut(scene, {4, 0});
    EXPECT_EQ(share.x, 1);
    EXPECT_EQ(share.y, 1);
}

TEST(HasBranches, WhereAnythingMirrorsOrLetsPass) {
    EXPECT_FALSE(has_branches(two_mirrors(0)));
    EXPECT_TRUE(has_branches(two_mirrors(0.1)));
    Scene scene = two_mirrors(0);
    scene.materials[scene.objects[0].material].filter = 0.1;
    EXPECT_TRUE(has_branches(scene));
}

TEST(BoundOfCut, IsAllLightWhereTheCamerasRayIsCut) {
    const Scene scene = two_mirrors(0);
    const auto renderer = compile(scene, scene.settings);
    const auto points = [&](int x, int y) { return renderer->samples(x, y); };
    EXPECT_EQ(bound_of_cut(*renderer, scene, one_pixel, {64, 1}, points, {}).largest, 0);
    EXPECT_NEAR(bound_of_cut(*renderer, scene, one_pixel, {64, 2}, points, {}).largest, 0.1, 1e-15);
}

TEST(BoundOfCut, IsShareTimesLightOverThePicture) {
    Scene scene = two_mirrors(0.5);
    scene.settings.max_depth = 4;
    const auto renderer = compile(scene, scene.settings);
    const CutBound bound = bound_of_cut(*renderer, scene, one_pixel, {4, 0},
                                        [&](int x, int y) { return renderer->samples(x, y); }, {});
    EXPECT_NEAR(bound.largest, 0.0625 * 0.2, 1e-16);
    EXPECT_NEAR(bound.rmse, 0.0625 * 0.2, 1e-16);
}

}  // namespace
}  // namespace lancer::accuracy
