// The compiled world carries what the scene requires, and `lancer info` says the same.
#include "tests/tracer/scene_kit.h"
#include "tracer/compile/compile.h"

namespace lancer {
namespace {

using namespace kit;

/// A scene of a ball of this material beside an opaque one.
Scene ball_of(const Material& material) {
    Scene scene;
    scene.transforms = {{}};
    scene.materials = {Material{}};
    show(scene, Sphere{{3, 0, 0}, 1});
    show(scene, Sphere{{0, 0, 0}, 1}, material);
    return scene;
}

void expect_agreement(const Scene& scene) {
    const Requirements asked = requirements_of(scene, scene.settings);
    const auto world = compile_world<double>(scene, scene.settings);
    EXPECT_EQ(world->has_media, asked.needs(Feature::media));
    EXPECT_EQ(world->has_transmission, asked.needs(Feature::transmission));
    EXPECT_EQ(world->has_smooth_media, asked.needs(Feature::smooth_media));
    EXPECT_EQ(world->has_textures, asked.needs(Feature::textures));
    bool transmits = false;
    bool lists = false;
    for (const Primitive<double>& p : world->primitives) {
        transmits |= p.transmissive;
        lists |= p.medium && (p.transmissive || world->finishes[p.material].absorbs);
    }
    EXPECT_EQ(world->has_transmission, transmits);
    EXPECT_EQ(world->has_media, lists);
}

TEST(World, CarriesWhatTheSceneRequires) {
    expect_agreement(ball_of({}));
    expect_agreement(ball_of({.transmission = 1}));
    expect_agreement(ball_of({.transmission = 1, .ior = 1.5}));
    expect_agreement(ball_of({.ior = 1.5}));
    expect_agreement(ball_of({.absorption = {1, 0, 0}}));
    Scene sheet = ball_of({.filter = 0.5});
    sheet.objects[1].shape = Triangle{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
    expect_agreement(sheet);
}

TEST(World, AClearBodyOfIndexOneIsInTheListOfMedia) {
    const Scene scene = ball_of({.transmission = 1});
    EXPECT_TRUE(compile_world<double>(scene, scene.settings)->has_media);
    EXPECT_TRUE(requirements_of(scene, scene.settings).needs(Feature::media));
}

}  // namespace
}  // namespace lancer
