// The terms that a lamp contributes at a surface, each compared with its formula computed by hand:
// docs/shading.md.
#include "tests/tracer/scene_kit.h"

namespace lancer {
namespace {

using namespace kit;

constexpr double exact = 1e-12;

/// Black except for the terms that a test sets.
Material matt(const Color& color, double diffuse) {
    Material m;
    m.color = color;
    m.ambient = 0;
    m.diffuse = diffuse;
    return m;
}

Light lamp(const Vec3d& position, const Color& color = Color(1)) {
    Light light;
    light.kind = PointLight{position, {}};
    light.color = color;
    return light;
}

/// The floor y = 0 of this material, lit from (3, 4, 0): at the origin L = (0.6, 0.8, 0).
Scene floor_of(const Material& material) {
    Scene scene;
    scene.settings.min_contribution = 0;
    show(scene, Plane{{0, 1, 0}, 0}, material);
    scene.lights.push_back(lamp({3, 4, 0}));
    return scene;
}
const Vec3d from_above(0, 5, 0);
const Vec3d origin(0, 0, 0);
/// d = (-0.6, -0.8, 0) mirrored is (-0.6, 0.8, 0).
const Vec3d from_right(6, 8, 0);
/// d = (0.6, -0.8, 0) mirrored is L.
const Vec3d from_left(-6, 8, 0);

TEST(Terms, AmbientIsTheColourTimesTheScenesAmbientLight) {
    Material m = matt({0.5, 0.25, 1}, 0);
    m.ambient = 0.3;
    Scene scene = floor_of(m);
    scene.ambient = {1, 2, 0.5};
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.15, 0.15, 0.15), exact);
}

TEST(Terms, EmissionIsTimesTheColourAndKnowsNoAmbientLight) {
    Material m = matt({0.5, 0.25, 1}, 0);
    m.emission = {0.2, 4, 1};
    Scene scene = floor_of(m);
    scene.ambient = Color(0);
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.1, 1, 1), exact);
}

TEST(Terms, DiffuseIsTheCosine) {
    Scene scene = floor_of(matt({0.5, 0.25, 1}, 0.7));
    scene.lights[0].color = {1, 2, 3};
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), 0.7 * 0.8 * Color(0.5, 0.5, 3), exact);
}

TEST(Terms, OpacityScalesAmbientEmissionAndDiffuse) {
    Material m = matt({0.5, 0.25, 1}, 0.7);
    m.ambient = 0.3;
    m.emission = Color(0.2);
    m.filter = 0.2;
    m.transmission = 0.3;
    const double local = 0.5 * (0.3 + 0.2 + 0.7 * 0.8);
    EXPECT_COLOR_NEAR(seen(floor_of(m), from_above, origin), local * m.color, exact);
}

TEST(Terms, LampsAddUp) {
    Scene scene = floor_of(matt(Color(1), 1));
    scene.lights.push_back(lamp({-4, 3, 0}, {0, 1, 0}));
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.8, 0.8 + 0.6, 0.8), exact);
}

TEST(Terms, DirectionalLightTravelsAlongItsDirection) {
    Scene scene = floor_of(matt(Color(1), 1));
    scene.lights[0].kind = DirectionalLight{{-3, -4, 0}};
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.8), exact);
    scene.lights[0].kind = DirectionalLight{{-3, 4, 0}};
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0), exact);
}

TEST(Terms, PhongIsTheCosineBetweenMirrorRayAndLampToThePowerOfShininess) {
    Material m = matt({0.2, 0.3, 0.4}, 0);
    m.phong = 0.5;
    m.shininess = 10;
    // From above R = (0, 1, 0), R·L = 0.8; from the left R·L = 1; from the right 0.28.
    EXPECT_COLOR_NEAR(seen(floor_of(m), from_above, origin), Color(0.5 * std::pow(0.8, 10)), exact);
    EXPECT_COLOR_NEAR(seen(floor_of(m), from_left, origin), Color(0.5), exact);
    EXPECT_COLOR_NEAR(seen(floor_of(m), from_right, origin), Color(0.5 * std::pow(0.28, 10)),
                      exact);
}

TEST(Terms, BlinnIsTheCosineOfTheHalfVectorToOneOverRoughness) {
    Material m = matt({0.2, 0.3, 0.4}, 0);
    m.blinn = 0.5;
    m.roughness = 0.1;
    // From above -d = (0, 1, 0): H = (0.6, 1.8, 0) / |..|, N·H = 1.8 / sqrt(3.6).
    EXPECT_COLOR_NEAR(seen(floor_of(m), from_above, origin),
                      Color(0.5 * std::pow(1.8 / std::sqrt(3.6), 10)), exact);
    EXPECT_COLOR_NEAR(seen(floor_of(m), from_left, origin), Color(0.5), exact);
}

TEST(Terms, HighlightsAreScaledNeitherByColourNorByOpacity) {
    Material m = matt(Color(0), 0);
    m.phong = 0.3;
    m.blinn = 0.2;
    m.transmission = 1;
    EXPECT_COLOR_NEAR(seen(floor_of(m), from_left, origin), Color(0.5), exact);
}

TEST(Terms, PhongAndDiffuseAddUp) {
    Material m = matt({0.5, 0.25, 1}, 0.7);
    m.phong = 0.3;
    m.shininess = 5;
    EXPECT_COLOR_NEAR(seen(floor_of(m), from_above, origin),
                      0.7 * 0.8 * m.color + Color(0.3 * std::pow(0.8, 5)), exact);
}

/// POV-Ray's approximation of Fresnel's equations for `metallic`.
double metallic_share(double cosine) {
    const double x = std::acos(cosine) / (pi / 2);
    return std::clamp(0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903, 0.0, 1.0);
}

TEST(Terms, MetallicDrawsTheHighlightToTheSurfacesColour) {
    Material m = matt({0.5, 0.25, 1}, 0);
    m.phong = 1;
    m.shininess = 3;
    for (const double metallic : {0.4, 1.0}) {
        m.metallic = metallic;
        const double amount = metallic * (1 - metallic_share(0.8));
        const Color tint = Color(1) + amount * (m.color - Color(1));
        EXPECT_COLOR_NEAR(seen(floor_of(m), from_left, origin), tint, exact);
    }
}

TEST(Terms, FadeIsTwoOverOnePlusThePowerOfTheDistance) {
    Scene scene = floor_of(matt(Color(1), 1));
    scene.lights[0].kind = PointLight{{3, 4, 0}, Fade{2, 3}};
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.8 * 2 / (1 + std::pow(2.5, 3))),
                      exact);
    scene.lights[0].kind = PointLight{{3, 4, 0}, Fade{5, 1.5}};
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.8), exact);
}

TEST(Terms, ANegativeLightTakesLightAway) {
    Scene scene = floor_of(matt(Color(1), 0.5));
    scene.lights[0].kind = DirectionalLight{{0, -1, 0}};
    scene.lights.push_back(scene.lights[0]);
    scene.lights[1].color = Color(-0.5, -0.25, 0);
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.25, 0.375, 0.5), exact);
    // So do its shadows: where it does not come, nothing is taken.
    scene.lights[1].kind = PointLight{{0, 8, 0}, {}};
    show(scene, Sphere{{0, 7, 0}, 0.5}, matt(Color(1), 1));
    scene.lights[0].shadows = false;
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.5), exact);
}

Scene spot(double radius, double falloff, double tightness, const Vec3d& look_at) {
    Scene scene = floor_of(matt(Color(1), 1));
    SpotLight light;
    light.position = {0, 4, 0};
    light.look_at = look_at;
    light.radius = radius;
    light.falloff = falloff;
    light.tightness = tightness;
    scene.lights[0].kind = light;
    return scene;
}

TEST(Terms, SpotIsFullInsideItsRadiusAndSmoothToNothingAtItsFalloff) {
    // The axis to (4, 0, 0) is 45 degrees off the way to the origin.
    const Vec3d aside(4, 0, 0);
    EXPECT_COLOR_NEAR(seen(spot(46, 50, 0, aside), from_above, origin), Color(1), exact);
    EXPECT_COLOR_NEAR(seen(spot(30, 44, 0, aside), from_above, origin), Color(0), exact);
    const double s = std::sqrt(0.5);
    const double outer = std::cos(radians(60));
    const double inner = std::cos(radians(30));
    const double x = (s - outer) / (inner - outer);
    EXPECT_COLOR_NEAR(seen(spot(30, 60, 0, aside), from_above, origin), Color(x * x * (3 - 2 * x)),
                      exact);
    EXPECT_COLOR_NEAR(seen(spot(50, 60, 7, aside), from_above, origin), Color(std::pow(s, 7)),
                      exact);
    EXPECT_COLOR_NEAR(seen(spot(30, 60, 2, aside), from_above, origin),
                      Color(std::pow(s, 2) * x * x * (3 - 2 * x)), exact);
    EXPECT_COLOR_NEAR(seen(spot(80, 90, 0, {0, 8, 0}), from_above, origin), Color(0), exact);
}

TEST(Terms, AFillLightHasNeitherShadowsNorHighlights) {
    Material m = matt(Color(1), 0.5);
    m.phong = 1;
    m.blinn = 1;
    Scene scene = floor_of(m);
    show(scene, Sphere{{1.5, 2, 0}, 0.5}, matt(Color(1), 1));  // on the way to the lamp
    EXPECT_COLOR_NEAR(seen(scene, from_left, origin), Color(0), exact);
    scene.lights[0].shadows = false;
    EXPECT_COLOR_NEAR(seen(scene, from_left, origin), Color(0.4), exact);
}

TEST(Terms, ShadowsOffKeepsTheHighlights) {
    Material m = matt(Color(1), 0.5);
    m.phong = 1;
    Scene scene = floor_of(m);
    show(scene, Sphere{{1.5, 2, 0}, 0.5}, matt(Color(1), 1));
    scene.settings.shadows = false;
    EXPECT_COLOR_NEAR(seen(scene, from_left, origin), Color(1.4), exact);
}

TEST(Terms, AnObjectWithoutShadowCastsNone) {
    Scene scene = floor_of(matt(Color(1), 1));
    show(scene, Sphere{{1.5, 2, 0}, 0.5}, matt(Color(1), 1)).casts_shadow = false;
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.8), exact);
}

TEST(Terms, WhatStandsBehindTheLampCastsNoShadow) {
    Scene scene = floor_of(matt(Color(1), 1));
    show(scene, Sphere{{6, 8, 0}, 0.5}, matt(Color(1), 1));
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.8), exact);
}

TEST(Shadows, AreTheProductOfWhatEverySurfaceOnTheWayLetsPass) {
    Material glass = matt({1, 0.5, 0.25}, 0.6);
    glass.filter = 0.6;
    glass.transmission = 0.3;
    glass.ior = 1.5;
    Scene scene = floor_of(matt(Color(1), 1));
    show(scene, Sphere{{1.5, 2, 0}, 0.5}, glass);  // entered and left: T twice
    Color t = 0.6 * glass.color + Color(0.3);
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), 0.8 * t * t, exact);
    // A sheet besides.
    show(scene, Triangle{{Vec3d(-9, 3, -9), Vec3d(9, 3, -9), Vec3d(0, 3, 9)}}, glass);
    EXPECT_COLOR_NEAR(seen(scene, {0, 2.9, 0}, origin), 0.8 * t * t * t, exact);
}

TEST(Shadows, AbsorptionInsideBodiesWeakensTheLight) {
    Material glass = matt(Color(1), 0);
    glass.transmission = 0.9;
    glass.absorption = {0.5, 1, 2};
    Scene scene = floor_of(matt(Color(1), 1));
    show(scene, Sphere{{1.5, 2, 0}, 0.5}, glass);  // a way of 1 through its middle
    const Color inside(std::exp(-0.5), std::exp(-1.0), std::exp(-2.0));
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), 0.8 * 0.81 * inside, exact);
}

TEST(Shadows, OfALampInsideABodyEndAtTheLamp) {
    Material glass = matt(Color(1), 0);
    glass.transmission = 0.9;
    glass.absorption = Color(1);
    Scene scene = floor_of(matt(Color(1), 1));
    show(scene, Sphere{{3, 4, 0}, 0.5}, glass);
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.8 * 0.9 * std::exp(-0.5)), exact);
}

TEST(Shadows, AnOpaqueFloorInsideAbsorbingWaterIsLitThroughIt) {
    Material water = matt(Color(1), 0);
    water.transmission = 1;
    water.ior = 1.33;
    water.absorption = {0.1, 0.2, 0.3};
    Scene scene = floor_of(matt(Color(1), 1));
    show(scene, Plane{{0, 1, 0}, 2}, water);  // the floor lies 2 below the surface
    const Vec3d down(0.1, 0.2, 0.3);
    for (const bool casts : {true, false}) {
        scene.objects[1].casts_shadow = casts;
        Color expected;
        for (int i = 0; i < 3; ++i) {
            // Lit along 2 / 0.8 in water, seen along 2 straight down.
            const double lit = casts ? std::exp(-down[i] * 2.5) : 1.0;
            expected[i] = 0.8 * lit * std::exp(-down[i] * 2);
        }
        EXPECT_COLOR_NEAR(seen(scene, from_above, origin), expected, exact);
    }
}

TEST(Shadows, AMeshPaneTintsOnceOnItsDiagonalToo) {
    Mesh pane;
    pane.vertices = {{-4, 1, -4}, {4, 1, -4}, {4, 1, 4}, {-4, 1, 4}};
    pane.faces = {{0, 1, 2}, {0, 2, 3}};
    Material tinted = matt(Color(0.5), 0);
    tinted.filter = 1;
    Scene scene = floor_of(matt(Color(1), 1));
    scene.meshes.push_back(std::make_shared<Mesh>(pane));
    show(scene, MeshRef{0, false}, tinted);
    scene.lights[0].kind = PointLight{{0, 4, 0}, {}};
    EXPECT_COLOR_NEAR(seen(scene, {1, 0.5, 0}, origin), Color(0.5), exact);
    EXPECT_COLOR_NEAR(seen(scene, {0, 5, 0}, origin), Color(0.25), exact);
}

/// A pane y = 0 lit from below by (3, -4, 0) and seen from above.
Scene pane_lit_from_below(const Material& material) {
    Scene scene;
    scene.settings.min_contribution = 0;
    show(scene, Triangle{{Vec3d(-9, 0, -9), Vec3d(9, 0, -9), Vec3d(0, 0, 9)}}, material);
    scene.lights.push_back(lamp({3, -4, 0}));
    return scene;
}

TEST(LightFromBehind, DiffuseTransmissionIsTheCosineOnTheOtherSide) {
    Material m = matt({0.5, 0.25, 1}, 0.9);
    m.diffuse_transmission = 0.4;
    EXPECT_COLOR_NEAR(seen(pane_lit_from_below(m), from_above, origin), 0.4 * 0.8 * m.color, exact);
    m.transmission = 0.3;
    EXPECT_COLOR_NEAR(seen(pane_lit_from_below(m), from_above, origin), 0.7 * 0.4 * 0.8 * m.color,
                      exact);
}

TEST(LightFromBehind, PhongTransmissionIsAHighlightAroundTheRayThatGoesOn) {
    Material m = matt({0.5, 0.25, 1}, 0);
    m.phong_transmission = 0.6;
    m.shininess = 4;
    // Straight on: T̂ = (0, -1, 0), T̂·L = 0.8; along (0.6, -0.8, 0) it is 1.
    EXPECT_COLOR_NEAR(seen(pane_lit_from_below(m), from_above, origin),
                      Color(0.6 * std::pow(0.8, 4)), exact);
    EXPECT_COLOR_NEAR(seen(pane_lit_from_below(m), from_left, origin), Color(0.6), exact);
    m.metallic = 1;
    const Color found = seen(pane_lit_from_below(m), from_left, origin);
    EXPECT_LT(found.y, found.x) << "tinted by the colour";
}

TEST(LightFromBehind, PhongTransmissionFollowsTheRefractedRay) {
    Material m = matt(Color(1), 0);
    m.phong_transmission = 1;
    m.shininess = 6;
    m.transmission = 1;
    m.ior = 1.5;
    Scene scene;
    scene.settings.min_contribution = 0;
    show(scene, Plane{{0, 1, 0}, 0}, m);
    scene.lights.push_back(lamp({3, -4, 0}));
    // d = (0.6, -0.8, 0) bends to sin = 0.4.
    const double s = 0.4;
    const double c = std::sqrt(1 - s * s);
    EXPECT_COLOR_NEAR(seen(scene, from_left, origin), Color(std::pow(s * 0.6 + c * 0.8, 6)), exact);
}

TEST(LightFromBehind, FillLightsGiveNoHighlightFromBehind) {
    Material m = matt(Color(1), 0);
    m.phong_transmission = 1;
    m.diffuse_transmission = 0.5;
    Scene scene = pane_lit_from_below(m);
    scene.lights[0].shadows = false;
    EXPECT_COLOR_NEAR(seen(scene, from_above, origin), Color(0.4), exact);
}

}  // namespace
}  // namespace lancer
