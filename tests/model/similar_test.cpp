#include "model/similar.h"

#include <gtest/gtest.h>

namespace lancer {
namespace {

Scene one_of_each() {
    Scene scene;
    scene.cameras.push_back({"", {0, 1, 8}, {0, 1, 0}, {0, 1, 0}, PerspectiveProjection{40}, {}});
    scene.cameras.push_back({"", {0, 1, 8}, {0, 1, 0}, {0, 1, 0}, OrthographicProjection{4}, {}});
    scene.transforms.push_back({{Vec3d(2, 0, 0), Vec3d(0, 2, 0), Vec3d(0, 0, 2)}, Vec3d(1, 2, 3)});
    scene.meshes.push_back(std::make_shared<Mesh>(Mesh{
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {{0, 0, 1}}, {{0, 0, 0}}, {}, {}, {}}));
    const auto add = [&](const Shape& shape) -> Object& {
        return scene.objects.emplace_back(Object{shape, 0, 0, none, true, {}});
    };
    add(Sphere{{1, 2, 3}, 4});
    add(Plane{{0, -2, 0}, 5});
    add(Plane{{1, 1, 0}, 5});
    add(MeshRef{0, true});
    add(Sphere{{1, 2, 3}, 4}).transform = 1;
    return scene;
}

TEST(Similar, ScaledChangesEveryLength) {
    Scene scene = one_of_each();
    scene.materials[0].absorption = {1, 2, 4};
    scene.settings.tolerance = 0.5;
    scene.lights.push_back({PointLight{{1, 0, 0}, Fade{3, 2}}, {}, true, {}});
    const Scene twice = scaled(scene, 2);
    const Sphere& ball = std::get<Sphere>(twice.objects[0].shape);
    EXPECT_EQ(ball.center, Vec3d(2, 4, 6));
    EXPECT_EQ(ball.radius, 8);
    EXPECT_EQ(std::get<Plane>(twice.objects[2].shape).offset, 10);
    EXPECT_EQ(twice.cameras[0].position, Vec3d(0, 2, 16));
    EXPECT_EQ(std::get<OrthographicProjection>(twice.cameras[1].projection).height, 8);
    EXPECT_EQ(twice.materials[0].absorption, Vec3d(0.5, 1, 2));
    EXPECT_EQ(*twice.settings.tolerance, 1);
    const PointLight& lamp = std::get<PointLight>(twice.lights[0].kind);
    EXPECT_EQ(lamp.position, Vec3d(2, 0, 0));
    EXPECT_EQ(lamp.fade->distance, 6);
    EXPECT_EQ(lamp.fade->power, 2);
}

TEST(Similar, WhatHasATransformIsPutUnderAnother) {
    const Scene scene = one_of_each();
    const Scene there = moved(scaled(scene, 4), {1, 0, 0});
    const Object& ball = there.objects[4];
    EXPECT_EQ(std::get<Sphere>(ball.shape).radius, 4);
    const Affine<double>& map = there.transforms[ball.transform];
    EXPECT_EQ(map_point(map, {1, 0, 0}), Vec3d(4 * 3 + 1, 4 * 2, 4 * 3));
    EXPECT_EQ(scene.objects[4].transform, 1u) << "the given scene stays";
}

TEST(Similar, TexturedObjectsKeepTheirOwnSpace) {
    Scene scene = one_of_each();
    scene.textures.push_back({Checker{}, {}});
    scene.materials[0].texture = 0;
    const Scene twice = scaled(scene, 2);
    EXPECT_EQ(std::get<Sphere>(twice.objects[0].shape).radius, 4);
    EXPECT_EQ(largest_stretch(twice.transforms[twice.objects[0].transform]), 2);
}

TEST(Similar, PlanesAreMovedAlongTheirNormals) {
    const Scene there = moved(one_of_each(), {10, 20, 30});
    EXPECT_EQ(std::get<Plane>(there.objects[1].shape).offset, 5 - 20);
    // A plane whose normal is not along an axis keeps its numbers: adding to them would round.
    EXPECT_EQ(std::get<Plane>(there.objects[2].shape).offset, 5);
    EXPECT_EQ(there.transforms[there.objects[2].transform].shift, Vec3d(10, 20, 30));
}

TEST(Similar, ThreeRenamingsAreNone) {
    const Scene scene = one_of_each();
    const Scene once = axes_renamed(scene);
    EXPECT_EQ(std::get<Sphere>(once.objects[0].shape).center, Vec3d(3, 1, 2));
    EXPECT_EQ(once.cameras[0].up, Vec3d(0, 0, 1));
    const auto mesh_of = [](const Scene& s) {
        return *s.meshes[std::get<MeshRef>(s.objects[3].shape).mesh];
    };
    EXPECT_EQ(mesh_of(once).vertices[1], Vec3d(0, 1, 0));
    EXPECT_EQ(mesh_of(once).normals[0], Vec3d(1, 0, 0));
    const Scene thrice = axes_renamed(axes_renamed(once));
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(mesh_of(thrice).vertices[i], scene.meshes[0]->vertices[i]);
        EXPECT_EQ(thrice.transforms[thrice.objects[4].transform].rows[i],
                  scene.transforms[1].rows[i]);
    }
    EXPECT_EQ(std::get<Sphere>(axes_renamed(scene, 2).objects[0].shape).center, Vec3d(2, 3, 1));
}

TEST(Similar, FromAfarAsMuchIsSeen) {
    const Scene far = seen_from_afar(one_of_each(), 1000);
    EXPECT_EQ(far.cameras[0].position, Vec3d(0, 1, 8000));
    const double fov = std::get<PerspectiveProjection>(far.cameras[0].projection).fov;
    EXPECT_NEAR(std::tan(radians(fov / 2)) * 8000, std::tan(radians(20.0)) * 8, 1e-12);
    EXPECT_EQ(std::get<OrthographicProjection>(far.cameras[1].projection).height, 4);
}

/// A patch's own tolerance applies in its own space and in the world: the stricter one must be as
/// strict as before, relative to the patch.
TEST(Similar, APatchKeepsItsToleranceRelativeToItsSize) {
    Scene scene;
    scene.patches.push_back({});
    scene.patches[0].tolerance = 0.25;
    scene.objects.push_back({PatchRef{0}, 0, 0, none, true, {}});
    const auto strictest = [](const Scene& s) {
        const Object& object = s.objects[0];
        const double stretch = largest_stretch(s.transforms[object.transform]);
        return *s.patches[std::get<PatchRef>(object.shape).patch].tolerance /
               std::max(stretch, 1.0);
    };
    for (const double factor : {0.125, 1.0, 8.0, 1024.0})
        EXPECT_EQ(strictest(scaled(scene, factor)), 0.25) << factor;
}

}  // namespace
}  // namespace lancer
