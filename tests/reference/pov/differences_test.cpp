// The differences from POV-Ray that the export of a scene names. known_differences_test.cpp tests
// that they are real.
#include "reference/pov/differences.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "reference/pov/export.h"
#include "tests/reference/pov/pair_scenes.h"
#include "tests/reference/pov/scene_kit.h"

namespace lancer::reference {
namespace {

using testing::HasSubstr;
using Rule = KnownDifference::Rule;

constexpr ExportView small_view{0, 160, 120};

std::string exported(const Scene& scene) {
    return export_pov(scene, small_view, {.keep_lengths = true}).text;
}

/// The objects for which a rule is known to differ.
std::vector<std::uint32_t> known(const Scene& scene, Rule rule) {
    for (const KnownDifference& d : export_pov(scene, small_view).known_differences)
        if (d.rule == rule) return d.objects;
    return {};
}

TEST(KnownDifferences, AreNoneInPlainScenes) {
    EXPECT_TRUE(export_pov(solids_scene(), small_view).known_differences.empty());
}

TEST(KnownDifferences, NameBodiesWhoseAbsorptionPovRayApproximates) {
    Scene scene = empty_scene();
    Material glass;
    glass.transmission = 1;
    glass.absorption = {1, 0, 0};
    add_object(scene, Sphere{}, add_material(scene, glass));
    EXPECT_TRUE(known(scene, Rule::absorption_inside).empty()) << "clear glass";
    EXPECT_TRUE(known(scene, Rule::absorption_nested).empty());
    scene.materials.back().phong = 0.5;
    EXPECT_THAT(known(scene, Rule::absorption_inside), testing::ElementsAre(0));
    add_object(scene, Sphere{{0.3, 0, 0}, 0.1});
    EXPECT_THAT(known(scene, Rule::absorption_nested), testing::ElementsAre(0));
    scene.objects[1].shape = Plane{{0, 0.5, 0}, -1.1};
    EXPECT_TRUE(known(scene, Rule::absorption_nested).empty()) << "a plane below";
    scene.objects[1].shape = Plane{{0, 0.5, 0}, 0.9};
    EXPECT_THAT(known(scene, Rule::absorption_nested), testing::ElementsAre(0));
    scene.materials.back().diffuse_transmission = 0.5;
    EXPECT_THAT(known(scene, Rule::light_from_behind), testing::ElementsAre(0));
    scene.materials.back().transmission = 0;
    EXPECT_TRUE(export_pov(scene, small_view).known_differences.empty()) << "nothing gets in";
}

TEST(KnownDifferences, NameAbsorbingMeshesWithInterpolatedNormals) {
    Scene scene = empty_scene();
    Material glass;
    glass.transmission = 1;
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh->faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    scene.meshes.push_back(mesh);
    add_object(scene, MeshRef{0, true}, add_material(scene, glass));
    EXPECT_TRUE(known(scene, Rule::absorption_smooth).empty()) << "nothing absorbs";
    scene.materials.back().absorption = Color(1);
    EXPECT_THAT(known(scene, Rule::absorption_smooth), testing::ElementsAre(0));
    scene.settings.smooth = false;
    EXPECT_TRUE(known(scene, Rule::absorption_smooth).empty());
}

TEST(KnownDifferences, NameSheetsInsideBodies) {
    Scene scene = empty_scene();
    Material glass;
    glass.transmission = 1;
    glass.ior = 1.5;
    const std::uint32_t material = add_material(scene, glass);
    const std::array<Vec3d, 3> corners{Vec3d(0, 0, 0), Vec3d(0.1, 0, 0), Vec3d(0, 0.1, 0)};
    add_object(scene, Sphere{{3, 0, 0}, 1}, material);
    add_object(scene, Triangle{corners}, material);
    EXPECT_TRUE(known(scene, Rule::sheet_in_medium).empty());
    add_object(scene, Sphere{}, material);
    EXPECT_THAT(known(scene, Rule::sheet_in_medium), testing::ElementsAre(1));
}

TEST(KnownDifferences, NameGlassWithFresnelInsideAnother) {
    Scene scene = empty_scene();
    Material glass;
    glass.transmission = 1;
    glass.ior = 1.5;
    glass.reflection = Color(1);
    glass.fresnel = true;
    Material water;
    water.transmission = 1;
    water.ior = 1.33;
    add_object(scene, Sphere{{0, 0, 0}, 0.5}, add_material(scene, glass));
    add_object(scene, Sphere{{0.2, 0, 0}, 0.9});
    EXPECT_TRUE(known(scene, Rule::fresnel_nested).empty()) << "an opaque one";
    scene.objects[1].material = add_material(scene, water);
    EXPECT_THAT(known(scene, Rule::fresnel_nested), testing::ElementsAre(0));
}

TEST(KnownDifferences, NameIndicesThatSinglePrecisionRounds) {
    Scene scene = empty_scene();
    Material glass;
    glass.transmission = 1;
    glass.ior = 1.5;
    Material water = glass;
    water.ior = 1.25;
    add_object(scene, Sphere{{0, 0, 0}, 0.5}, add_material(scene, glass));
    add_object(scene, Sphere{{3, 0, 0}, 0.5}, add_material(scene, water));
    EXPECT_TRUE(known(scene, Rule::index_single).empty()) << "exact, and apart";
    scene.objects[1].shape = Sphere{{0.2, 0, 0}, 0.9};
    EXPECT_THAT(known(scene, Rule::index_single), testing::ElementsAre(0, 1)) << "their ratio";
    scene.materials.back().ior = 1.33;
    scene.objects[1].shape = Sphere{{3, 0, 0}, 0.5};
    EXPECT_THAT(known(scene, Rule::index_single), testing::ElementsAre(1));
}

TEST(KnownDifferences, NamePatchesAndSayHowTheyAreHalved) {
    Scene scene = empty_scene();
    Patch patch;
    for (int i = 0; i < 16; ++i) patch.control.push_back(Vec3d(i % 4, i / 4, i % 3));
    scene.patches = {patch};
    add_object(scene, Sphere{});
    add_object(scene, PatchRef{0});
    scene.materials.emplace_back();
    EXPECT_THAT(known(scene, Rule::patch_facets), testing::ElementsAre(1));
    const ExportResult result = export_pov(scene, small_view);
    EXPECT_THAT(result.text, HasSubstr("u_steps " + std::to_string(result.patch_halvings[0])));
    EXPECT_EQ(result.unit * result.factor, 1);
}

TEST(KnownDifferences, NameWhatPassesStraightWhereLevelsRunOut) {
    Scene scene = empty_scene();
    Material pane;
    pane.transmission = 1;
    const std::array<Vec3d, 3> corners{Vec3d(0, 0, 0), Vec3d(0.1, 0, 0), Vec3d(0, 0.1, 0)};
    add_object(scene, Triangle{corners}, add_material(scene, pane));
    EXPECT_TRUE(known(scene, Rule::depth_limit).empty()) << "nothing takes a level";
    Material mirror;
    mirror.reflection = Color(0.5);
    add_object(scene, Sphere{{3, 0, 0}, 1}, add_material(scene, mirror));
    EXPECT_THAT(known(scene, Rule::depth_limit), testing::ElementsAre(0));
}

TEST(KnownDifferences, NameTheLimitsOfDepthAndContribution) {
    Scene scene = empty_scene();
    Material mirror;
    mirror.reflection = Color(0.5);
    add_object(scene, Sphere{}, add_material(scene, mirror));
    scene.settings.max_depth = 300;
    EXPECT_THAT(known(scene, Rule::depth_limit), testing::ElementsAre(0));
    EXPECT_THAT(exported(scene), HasSubstr("max_trace_level 256"));
    scene.settings.max_depth = 1;
    EXPECT_TRUE(known(scene, Rule::depth_limit).empty()) << "a mirror is black in both";
    scene.materials.back().transmission = 0.1;
    EXPECT_THAT(known(scene, Rule::depth_limit), testing::ElementsAre(0));
    scene.settings.min_contribution = 0.01;
    EXPECT_THAT(known(scene, Rule::contribution), testing::ElementsAre(0));
}

TEST(KnownDifferences, NameThinAndFarBodies) {
    Scene scene = empty_scene();
    add_object(scene, Box{{0, 0, 0}, {1, 1, 0.001}});
    add_object(scene, Sphere{{1, 1, 1}, 1});
    add_object(scene, Sphere{{2e7, 0, 0}, 1});
    ASSERT_EQ(export_pov(scene, small_view).factor, 1);
    EXPECT_THAT(known(scene, Rule::small_features), testing::ElementsAre(0));
    EXPECT_THAT(known(scene, Rule::far_away), testing::ElementsAre(2));
}

TEST(KnownDifferences, NameFacesInOnePlace) {
    Scene scene = empty_scene();
    add_object(scene, Plane{{0, 2, 0}, -1});
    add_object(scene, Box{{-1, -1, -1}, {0, 0.5, 1}});
    add_object(scene, Box{{0, -0.9, -1}, {1, 0.6, 1}});
    add_object(scene, Sphere{{0, 0, 0}, 1});
    EXPECT_THAT(known(scene, Rule::coincident_surfaces), testing::ElementsAre(0, 1, 2));
    scene.objects.erase(scene.objects.begin() + 1);
    EXPECT_TRUE(known(scene, Rule::coincident_surfaces).empty());
    // A cylinder standing on a tilted box: turned together, the faces still meet.
    Affine<double> turn;
    turn.rows = {Vec3d(0.8, -0.6, 0), Vec3d(0.6, 0.8, 0), Vec3d(0, 0, 1)};
    scene.objects[1].transform = add_transform(scene, turn);
    add_object(scene, Cylinder{{0.5, 0.6, 0}, {0.5, 1, 0}, 0.2}).transform =
        scene.objects[1].transform;
    EXPECT_THAT(known(scene, Rule::coincident_surfaces), testing::ElementsAre(1, 3));
}

TEST(KnownDifferences, HaveNamesOfTheirOwn) {
    std::vector<std::string> names;
    for (int rule = 0; rule <= static_cast<int>(Rule::index_single); ++rule)
        names.push_back(rule_name(static_cast<Rule>(rule)));
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
    EXPECT_NE(names.front(), "");
}
}  // namespace
}  // namespace lancer::reference
