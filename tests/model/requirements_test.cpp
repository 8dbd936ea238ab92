#include "model/requirements.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lancer {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A scene of one sphere with this material, and no light.
Scene sphere_of(const Material& material) {
    Scene scene;
    scene.materials.push_back(material);
    Object object{.shape = Sphere{}, .material = 1};
    object.place = {0, 10, 6};
    scene.objects = {Object{.shape = Sphere{}}, object};
    return scene;
}

std::vector<Feature> features(const Scene& scene) {
    const Requirements found = requirements_of(scene, scene.settings);
    std::vector<Feature> needed;
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (found.needs(static_cast<Feature>(i))) needed.push_back(static_cast<Feature>(i));
    }
    return needed;
}

TEST(Requirements, APlainSphereAsksForNothing) {
    EXPECT_THAT(features(sphere_of({})), IsEmpty());
}

TEST(Requirements, ALightAsksForShadowsUnlessTheyAreOff) {
    Scene scene = sphere_of({});
    scene.lights.push_back({.kind = PointLight{}});
    EXPECT_THAT(features(scene), ElementsAre(Feature::shadows));
    scene.settings.shadows = false;
    EXPECT_THAT(features(scene), IsEmpty());
    scene.settings.shadows = true;
    scene.lights[0].shadows = false;
    EXPECT_THAT(features(scene), IsEmpty());
}

TEST(Requirements, GlassAsksForBodiesBendingAndFilteredShadows) {
    Scene scene = sphere_of({.transmission = 0.9, .ior = 1.5});
    scene.lights.push_back({.kind = PointLight{}});
    EXPECT_THAT(features(scene),
                ElementsAre(Feature::shadows, Feature::filtered_shadows, Feature::transmission,
                            Feature::media, Feature::refraction));
    scene.objects[1].casts_shadow = false;
    EXPECT_THAT(features(scene), ElementsAre(Feature::shadows, Feature::transmission,
                                             Feature::media, Feature::refraction));
}

TEST(Requirements, ASheetIsNeverInsideOfAnything) {
    Scene scene = sphere_of({.filter = 0.5, .ior = 1.5, .absorption = {1, 0, 0}});
    EXPECT_THAT(features(scene), ElementsAre(Feature::transmission, Feature::media,
                                             Feature::refraction, Feature::absorption));
    scene.objects[1].shape = Cylinder{.capped = false};
    EXPECT_THAT(features(scene), ElementsAre(Feature::transmission));
}

TEST(Requirements, AClearBodyOfTheSurroundingIndexNeedsTheList) {
    EXPECT_THAT(features(sphere_of({.transmission = 1})),
                ElementsAre(Feature::transmission, Feature::media))
        << "which of its crossings count follows from where the ray is";
    EXPECT_THAT(features(sphere_of({.ior = 1.5})), IsEmpty()) << "opaque";
    EXPECT_THAT(features(sphere_of({.absorption = {0, 0, 1}})),
                ElementsAre(Feature::media, Feature::absorption))
        << "opaque, but the camera may stand inside";
}

TEST(Requirements, MirrorsNeedASecondLevel) {
    Scene scene = sphere_of({.reflection = {0, 0.5, 0}, .fresnel = true});
    EXPECT_THAT(features(scene), ElementsAre(Feature::reflection, Feature::fresnel));
    scene.settings.max_depth = 1;
    EXPECT_THAT(features(scene), IsEmpty());
}

TEST(Requirements, AnImageWithAlphaLetsLightThrough) {
    Scene scene = sphere_of({.texture = 0});
    scene.textures.push_back({.pattern = ImageTexture{}, .to_object = {}});
    scene.images.push_back({"opaque.png", true, std::make_shared<Image>(1, 1, 3)});
    scene.images.push_back({"alpha.png", true, std::make_shared<Image>(1, 1, 4)});
    EXPECT_THAT(features(scene), ElementsAre(Feature::textures, Feature::image_textures));
    std::get<ImageTexture>(scene.textures[0].pattern).image = 1;
    EXPECT_THAT(features(scene), ElementsAre(Feature::textures, Feature::image_textures,
                                             Feature::transmission, Feature::media));
    scene.settings.textures = false;
    EXPECT_THAT(features(scene), IsEmpty());
}

TEST(Requirements, TheFirstThatAsksIsNamed) {
    Scene scene = sphere_of({.reflection = {1, 1, 1}});
    scene.objects.push_back(scene.objects[1]);
    const auto demand = requirements_of(scene, scene.settings).demand(Feature::reflection);
    ASSERT_TRUE(demand);
    EXPECT_EQ(demand->object, 1u);
    EXPECT_EQ(demand->place, (SourceSpan{0, 10, 6}));
}

}  // namespace
}  // namespace lancer
