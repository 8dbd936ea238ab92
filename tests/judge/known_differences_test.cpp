// POV-Ray's differing rules: a scene for each. Our renderer with that rule must have POV-Ray's
// value in every pixel that differs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/judge/validate_fixture.h"
#include "tests/reference/pov/scene_kit.h"

namespace lancer::judge {
namespace {

using Rule = reference::KnownDifference::Rule;

class ByRule : public Validate {
  protected:
    /// At least `least` pixels differ, and all of them because of the rule.
    void expect_known(const Scene& scene, Rule rule, std::size_t least) {
        const Validation v = validate(scene);
        EXPECT_EQ(v.verdict, Verdict::agrees) << said(v);
        EXPECT_GE(v.judgement.count(PixelClass::known), least);
        EXPECT_EQ(v.judgement.count(PixelClass::unexplained), 0u);
        EXPECT_TRUE(std::ranges::any_of(
            v.known_differences,
            [&](const reference::KnownDifference& k) { return k.rule == rule; }))
            << reference::rule_name(rule);
    }
};

Material glass(double ior, double transmission = 0.9) {
    Material m;
    m.ambient = m.diffuse = 0;
    m.transmission = transmission;
    m.ior = ior;
    return m;
}

/// A wall of stripes behind the origin whose brightness changes everywhere by `slope` per unit.
void add_wall(Scene& scene, double slope = 0.5, double distance = 4) {
    Texture texture;
    texture.pattern = Gradient{
        {1, 0.4, 0}, {{0, {0.05, 0.1, 0.2}}, {0.5, {0.9, 0.7, 0.5}}, {1, {0.05, 0.1, 0.2}}}};
    const double period = 1 / slope;
    for (std::size_t i = 0; i < 3; ++i) texture.to_object.rows[i] *= period;
    const std::uint32_t material = add_texture(scene, texture);
    scene.materials[material].ambient = 0.9;
    add_object(scene, Plane{{0, 0, 1}, -distance}, material);
}

Scene wall_scene() {
    Scene scene = empty_scene();
    add_wall(scene);
    scene.settings.max_depth = 8;
    return scene;
}

TEST_F(ByRule, AbsorptionInsideIsKnownAndNothingElseIs) {
    Scene scene = wall_scene();
    Material milky = glass(1.3, 0.4);
    milky.diffuse = 0.5;
    milky.absorption = {0.5, 0.3, 0.1};
    add_object(scene, Sphere{}, add_material(scene, milky));
    expect_known(scene, Rule::absorption_inside, 1000);
    expect_caught(
        scene, [](Scene& ours) { ours.materials.back().absorption.x += 0.01; }, 100);
}

TEST_F(ByRule, AbsorptionNestedIsKnown) {
    Scene scene = wall_scene();
    Material tinted = glass(1.3);
    tinted.absorption = {0.5, 0.3, 0.1};
    add_object(scene, Sphere{}, add_material(scene, tinted));
    Material matt;
    add_object(scene, Sphere{{0.2, 0.1, 0}, 0.4}, add_material(scene, matt));
    expect_known(scene, Rule::absorption_nested, 500);
}

/// A ball of a few facets with the normals of a true one.
Mesh faceted_ball(std::uint32_t rings, std::uint32_t slices) {
    Mesh mesh;
    mesh.vertices.push_back({0, 1, 0});
    for (std::uint32_t i = 1; i < rings; ++i) {
        for (std::uint32_t j = 0; j < slices; ++j) {
            const double polar = 0.5 * tau * i / rings;
            const double around = tau * j / slices;
            mesh.vertices.push_back({std::sin(polar) * std::cos(around), std::cos(polar),
                                     std::sin(polar) * std::sin(around)});
        }
    }
    mesh.vertices.push_back({0, -1, 0});
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
        if (i == 0) return 0U;
        return i == rings ? 1 + (rings - 1) * slices : 1 + (i - 1) * slices + j % slices;
    };
    for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < slices; ++j) {
            if (i + 1 < rings) mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
            if (i > 0) mesh.faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    }
    mesh.normals = mesh.vertices;
    return mesh;
}

TEST_F(ByRule, AbsorptionInSmoothMeshesIsKnown) {
    Scene scene = wall_scene();
    scene.meshes.push_back(std::make_shared<Mesh>(faceted_ball(6, 8)));
    Material tinted = glass(1.5);
    tinted.absorption = {0.5, 0.3, 0.1};
    add_object(scene, MeshRef{0, true}, add_material(scene, tinted));
    expect_known(scene, Rule::absorption_smooth, 50);
}

TEST_F(ByRule, LightFromBehindIsKnown) {
    Scene scene = wall_scene();
    Material paper = glass(1, 0.3);
    paper.diffuse = 0.3;
    paper.diffuse_transmission = 0.6;
    paper.absorption = {0.6, 0.4, 0.2};
    add_object(scene, Sphere{}, add_material(scene, paper));
    scene.lights[0].kind = PointLight{{-3, 2, -3}, {}};
    expect_known(scene, Rule::light_from_behind, 1000);
}

TEST_F(ByRule, FresnelNestedIsKnown) {
    Scene scene = wall_scene();
    Material inner = glass(1.7);
    inner.fresnel = true;
    inner.reflection = Color(1);
    add_object(scene, Sphere{{0, 0, 0}, 1}, add_material(scene, glass(1.33)));
    add_object(scene, Box{{-0.4, -0.4, -0.4}, {0.5, 0.4, 0.4}}, add_material(scene, inner));
    expect_known(scene, Rule::fresnel_nested, 500);
}

TEST_F(ByRule, ASheetInAMediumIsKnown) {
    Scene scene = wall_scene();
    add_object(scene, Sphere{}, add_material(scene, glass(1.5)));
    const std::array<Vec3d, 3> corners{Vec3d(-0.5, -0.4, 0.2), Vec3d(0.6, -0.3, -0.3),
                                       Vec3d(0, 0.7, 0)};
    add_object(scene, Triangle{corners}, add_material(scene, glass(1)));
    expect_known(scene, Rule::sheet_in_medium, 300);
}

TEST_F(ByRule, WhatAdcBailoutDropsByGreyValueIsKnown) {
    Scene scene = wall_scene();
    scene.settings.min_contribution = 0.12;
    Material blue = glass(1, 0);
    blue.color = {0, 0, 1};
    blue.filter = 0.95;  // its grey value is 0.108, its largest channel 0.95
    add_object(scene, Sphere{}, add_material(scene, blue));
    expect_known(scene, Rule::contribution, 1000);
}

TEST_F(ByRule, AStraightPassOnTheLastLevelIsKnown) {
    for (const int depth : {1, 3}) {
        SCOPED_TRACE(depth);
        Scene scene = wall_scene();
        scene.settings.max_depth = depth;
        const std::array<Vec3d, 3> corners{Vec3d(-2, -2, -2), Vec3d(2, -2, -2), Vec3d(0, 3, -2)};
        if (depth > 1) add_object(scene, Sphere{}, add_material(scene, glass(1.5)));
        add_object(scene, Triangle{corners}, add_material(scene, glass(1)));
        expect_known(scene, Rule::depth_limit, 1000);
    }
}

TEST_F(ByRule, HitsAndShadowsTooNearAreKnown) {
    // The pane's faces are too near each other for a second hit, and the disc is too near to the
    // pane for a shadow.
    Scene scene = wall_scene();
    const double unit = 1 / reference::export_pov(scene, {0, 160, 120}).factor;
    add_object(scene, Box{{-1, -1, 0}, {0, 1, 5e-5 * unit}}, add_material(scene, glass(1.5, 0.5)));
    Material matt;
    const std::uint32_t paper = add_material(scene, matt);
    add_object(scene, Box{{0.2, -1, -0.5}, {1.2, 1, 0}}, paper);
    Material filter = glass(1, 0.5);
    const std::array<Vec3d, 3> corners{Vec3d(0.3, -0.8, 4e-4 * unit), Vec3d(1.1, -0.8, 4e-4 * unit),
                                       Vec3d(0.7, 0.8, 4e-4 * unit)};
    add_object(scene, Triangle{corners}, add_material(scene, filter));
    ASSERT_EQ(1 / reference::export_pov(scene, {0, 160, 120}).factor, unit);
    expect_known(scene, Rule::small_features, 1000);
}

TEST_F(ByRule, WhatIsTooFarAwayIsKnown) {
    Scene scene = wall_scene();
    scene.objects.clear();
    for (int i = 0; i < 3; ++i) add_object(scene, Sphere{{0.5 * i - 0.5, -0.5, 0}, 0.2});
    add_object(scene, Sphere{{0, 0, -3e7}, 1e7});
    expect_known(scene, Rule::far_away, 1000);
}

TEST_F(ByRule, PatchFacetsAreKnown) {
    Scene scene = wall_scene();
    Patch patch;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            patch.control.push_back({-0.9 + 0.6 * j, -0.9 + 0.6 * i, 1.5 * ((i * j) % 3) - 1});
    scene.patches.push_back(patch);
    Material china;
    china.phong = 0.8;
    china.shininess = 150;
    china.reflection = Color(0.3);
    Object& object = add_object(scene, PatchRef{0}, add_material(scene, china));
    Affine<double> uneven;
    uneven.rows = {Vec3d(1, 0.3, 0), Vec3d(0, 1.2, 0), Vec3d(0, 0.2, 0.7)};
    object.transform = add_transform(scene, uneven);
    expect_known(scene, Rule::patch_facets, 50);
}

TEST_F(ByRule, IndicesInSinglePrecisionAreKnown) {
    // Stripes so fine that the seventh digit of the index shows.
    Scene scene = empty_scene();
    scene.settings.max_depth = 8;
    add_wall(scene, 400);
    add_object(scene, Sphere{}, add_material(scene, glass(1.34)));
    expect_known(scene, Rule::index_single, 100);
}

/// A glass ball over a matt floor, which POV-Ray renders as we do.
Scene ball_on_floor() {
    Scene scene = wall_scene();
    add_object(scene, Plane{{0, 1, 0}, -1.2});
    Material tinted = glass(1.5, 0.4);
    tinted.filter = 0.5;
    tinted.color = {0.9, 0.6, 0.3};
    add_object(scene, Sphere{}, add_material(scene, tinted));
    return scene;
}

TEST_F(ByRule, AFaultOfOurRecursionAloneIsUnexplained) {
    // POV-Ray's rules give its values, but they do not cause the difference.
    const Scene scene = ball_on_floor();
    EXPECT_EQ(validate(scene).verdict, Verdict::agrees);
    const Fault brighter = [](Scene& ours) { ours.materials.back().transmission += 0.01; };
    const Validation v = validate(scene, brighter, {}, true);
    EXPECT_EQ(v.verdict, Verdict::differs);
    EXPECT_EQ(v.judgement.count(PixelClass::known), 0u);
    EXPECT_GE(v.judgement.count(PixelClass::unexplained), 1000u);
}

TEST_F(ByRule, AFaultOfOurRecursionIsUnexplainedWhereARuleCountsToo) {
    Scene scene = ball_on_floor();
    scene.materials.back().absorption = {0.5, 0.3, 0.1};
    scene.materials.back().diffuse = 0.4;
    EXPECT_GE(validate(scene).judgement.count(PixelClass::known), 1000u);
    const Fault brighter = [](Scene& ours) { ours.materials.back().transmission += 0.01; };
    const Validation v = validate(scene, brighter, {}, true);
    EXPECT_EQ(v.verdict, Verdict::differs);
    EXPECT_EQ(v.judgement.count(PixelClass::known), 0u);
    EXPECT_GE(v.judgement.count(PixelClass::unexplained), 1000u);
}

/// Balls and boxes of glass that overlap, each of its own matter, by a fixed seed.
Scene random_glass(unsigned seed) {
    std::mt19937 random(seed);
    // The standard's distributions differ from library to library.
    const auto from = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    const auto one_in = [&](unsigned n) { return random() % n == 0; };
    Scene scene = wall_scene();
    scene.settings.max_depth = 3 + static_cast<int>(seed % 4);
    for (unsigned i = 0; i < 3 + seed % 5; ++i) {
        Material m = glass(std::array{1.0, 1.2, 1.33, 1.5, 1.7}[random() % 5], from(0.1, 0.35));
        m.color = {from(0.5, 1), from(0.5, 1), from(0.5, 1)};
        m.filter = from(0.3, 0.6);
        m.diffuse = from(0, 0.2);
        if (one_in(3)) {
            m.reflection = Color(from(0.05, 0.6));
            m.fresnel = one_in(2);
        }
        if (one_in(4)) m.absorption = {from(0, 0.6), from(0, 0.6), from(0, 0.6)};
        const std::uint32_t material = add_material(scene, m);
        const Vec3d middle{from(-1, 1), from(-0.8, 0.8), from(-1, 1)};
        const Vec3d half{from(0.2, 0.8), from(0.2, 0.8), from(0.2, 0.8)};
        if (one_in(2))
            add_object(scene, Sphere{middle, from(0.3, 1)}, material);
        else
            add_object(scene, Box{middle - half, middle + half}, material);
    }
    return scene;
}

TEST_F(ByRule, RandomGlassAtLowDepthsIsExplainedToTheLastPixel) {
    std::size_t known = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        const Validation v = validate(random_glass(seed));
        EXPECT_EQ(v.verdict, Verdict::agrees) << said(v);
        EXPECT_EQ(v.judgement.count(PixelClass::unexplained), 0u);
        known += v.judgement.count(PixelClass::known);
    }
    EXPECT_GT(known, 10000u);
}

}  // namespace
}  // namespace lancer::judge
