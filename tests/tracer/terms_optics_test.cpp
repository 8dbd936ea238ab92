// Mirrors and glass, term by term, compared with colours computed by hand: docs/shading.md.
#include "tests/tracer/scene_kit.h"

namespace lancer {
namespace {

using namespace kit;

constexpr double exact = 1e-12;

Material dark() {
    Material m;
    m.ambient = 0;
    m.diffuse = 0;
    return m;
}
Material mirror(const Color& reflection) {
    Material m = dark();
    m.reflection = reflection;
    return m;
}
Material glass(double ior, double transmission = 1, double filter = 0,
               const Color& color = Color(1)) {
    Material m = dark();
    m.ior = ior;
    m.transmission = transmission;
    m.filter = filter;
    m.color = color;
    return m;
}
Scene empty_scene() {
    Scene scene;
    scene.settings.min_contribution = 0;
    scene.settings.max_depth = 20;
    scene.background = {0.25, 0.5, 1};
    return scene;
}
const Color sky(0.25, 0.5, 1);

/// Unpolarised reflectance by Fresnel's equations in the textbook form, not in the tracer's form.
double fresnel(double cosine, double from, double to) {
    const double sine = from / to * std::sqrt(1 - cosine * cosine);
    if (sine >= 1) return 1;
    const double bent = std::sqrt(1 - sine * sine);
    const double s = (from * cosine - to * bent) / (from * cosine + to * bent);
    const double p = (from * bent - to * cosine) / (from * bent + to * cosine);
    return (s * s + p * p) / 2;
}

TEST(Mirror, ReflectsTheShareOfItsNumberOrColour) {
    Scene scene = empty_scene();
    show(scene, Plane{{0, 1, 0}, 0}, mirror({0.5, 0.25, 1}));
    show(scene, Sphere{{3, 4, 0}, 1}, glowing({0.5, 1, 0.5}));
    EXPECT_COLOR_NEAR(seen(scene, {-3, 4, 0}, {0, 0, 0}), Color(0.25, 0.25, 0.5), exact);
    EXPECT_COLOR_NEAR(seen(scene, {-4, 3, 0}, {0, 0, 0}), Color(0.5, 0.25, 1) * sky, exact);
}

TEST(Mirror, IsAddedToTheLocalColourAndNotScaledByOpacity) {
    Material m = mirror(Color(0.5));
    m.emission = Color(0.1);
    m.transmission = 0.75;
    Scene scene = empty_scene();
    show(scene, Triangle{{Vec3d(-9, 0, -9), Vec3d(9, 0, -9), Vec3d(0, 0, 9)}}, m);
    EXPECT_COLOR_NEAR(seen(scene, {1, 2, 0}, {0, 0, 0}), Color(0.025) + 0.5 * sky + 0.75 * sky,
                      exact);
}

TEST(Mirror, FresnelWeighsItByTheAngle) {
    Material m = mirror({1, 0.5, 0.25});
    m.fresnel = true;
    m.ior = 1.5;
    Scene scene = empty_scene();
    show(scene, Box{{-9, -9, -9}, {9, 0, 9}}, m);
    EXPECT_COLOR_NEAR(seen(scene, {0, 5, 0}, {0, 0, 0}), 0.04 * m.reflection * sky, exact);
    EXPECT_COLOR_NEAR(seen(scene, {3, 4, 0}, {0, 0, 0}), fresnel(0.8, 1, 1.5) * m.reflection * sky,
                      exact);
    EXPECT_COLOR_NEAR(seen(scene, {5, 0.01, 0}, {0, 0, 0}),
                      fresnel(0.01 / std::hypot(5, 0.01), 1, 1.5) * m.reflection * sky, exact);
}

TEST(Glass, TransmissionAndFilterMakeTheShareThatPasses) {
    Scene scene = empty_scene();
    const Material m = glass(1.5, 0.3, 0.6, {1, 0.5, 0.25});
    show(scene, Sphere{{0, 0, 0}, 1}, m);
    const Color t = Color(0.3) + 0.6 * m.color;
    EXPECT_COLOR_NEAR(seen(scene, {0, 0, 5}, {0, 0, 0}), t * t * sky, exact);
}

TEST(Glass, SheetsAreCrossedStraightAndTintOnce) {
    Scene scene = empty_scene();
    show(scene, Triangle{{Vec3d(-9, 0, -9), Vec3d(9, 0, -9), Vec3d(0, 0, 9)}},
         glass(2, 0.3, 0.6, {1, 0.5, 0.25}));
    show(scene, Sphere{{-3, -4, 0}, 0.001}, glowing(Color(1)));
    EXPECT_COLOR_NEAR(seen(scene, {3, 4, 0}, {0, 0, 0}), Color(0.9, 0.6, 0.45), exact);
}

/// Looks through the surface y = 0 of a half space of glass at a bead on the refracted ray.
TEST(Glass, BendsByTheRatioOfTheIndicesBeforeAndAfter) {
    Scene scene = empty_scene();
    show(scene, Plane{{0, 1, 0}, 0}, glass(1.5));
    const double s = 0.6 / 1.5;
    const Vec3d bent(s, -std::sqrt(1 - s * s), 0);
    show(scene, Sphere{1000.0 * bent, 1e-6}, glowing(Color(1)));
    EXPECT_COLOR_NEAR(seen(scene, {-3, 4, 0}, {0, 0, 0}), Color(1), exact);
    // And back again.
    scene.objects[1].shape = Sphere{{-3000, 4000, 0}, 1e-6};
    EXPECT_COLOR_NEAR(seen(scene, bent, {0, 0, 0}), Color(1), exact);
}

TEST(Glass, FresnelTakesFromWhatPassesWhatItMirrors) {
    Material m = glass(1.5, 0.8);
    m.reflection = {1, 0.5, 0.25};
    m.fresnel = true;
    Scene scene = empty_scene();
    show(scene, Plane{{0, 1, 0}, 0}, m);
    const Color k = fresnel(0.8, 1, 1.5) * m.reflection;
    // The ray into the half space ends in black: what passes is absorbed.
    m.absorption = Color(1);
    scene.materials[1] = m;
    EXPECT_COLOR_NEAR(seen(scene, {3, 4, 0}, {0, 0, 0}), k * sky, exact);
    scene.materials[1].absorption = Color(0);
    EXPECT_COLOR_NEAR(seen(scene, {3, 4, 0}, {0, 0, 0}), k * sky + 0.8 * (Color(1) - k) * sky,
                      exact);
}

TEST(Glass, WithoutFresnelTheMirrorTakesNothing) {
    Material m = glass(1.5, 0.8);
    m.reflection = Color(0.5);
    Scene scene = empty_scene();
    show(scene, Plane{{0, 1, 0}, 0}, m);
    EXPECT_COLOR_NEAR(seen(scene, {3, 4, 0}, {0, 0, 0}), 1.3 * sky, exact);
}

TEST(Glass, LeavingUsesTheInverseRatioInFresnelToo) {
    Material m = glass(1.5, 0.8);
    m.reflection = Color(1);
    m.fresnel = true;
    Scene scene = empty_scene();
    scene.settings.max_depth = 2;
    show(scene, Plane{{0, 1, 0}, 0}, m);
    const double sine = 0.3;
    const double k = fresnel(std::sqrt(1 - sine * sine), 1.5, 1);
    // The mirrored ray leaves through nothing: inside the half space it sees the sky too.
    EXPECT_COLOR_NEAR(seen(scene, {sine, -std::sqrt(1 - sine * sine), 0}, {0, 0, 0}),
                      k * sky + 0.8 * (1 - k) * sky, exact);
}

TEST(TotalReflection, IsTintedNeitherByTNorByFresnelAndReplacesTheMirror) {
    Material m = glass(1.5, 0.3, 0.2, {1, 0.5, 0.25});
    m.reflection = Color(0.9);
    for (const bool with_fresnel : {false, true}) {
        m.fresnel = with_fresnel;
        Scene scene = empty_scene();
        show(scene, Plane{{0, 1, 0}, 0}, m);
        EXPECT_COLOR_NEAR(seen(scene, {-4, -3, 0}, {0, 0, 0}), sky, exact);
    }
}

TEST(TotalReflection, ItsWeightIsTheLargestChannelOfT) {
    Material m = glass(1.5, 0.1, 0.2, {1, 0.5, 0.25});  // T = 0.3, 0.2, 0.15
    Scene scene = empty_scene();
    show(scene, Plane{{0, 1, 0}, 0}, m);
    scene.settings.min_contribution = 0.29;
    EXPECT_COLOR_NEAR(seen(scene, {-4, -3, 0}, {0, 0, 0}), sky, exact);
    scene.settings.min_contribution = 0.31;
    EXPECT_COLOR_NEAR(seen(scene, {-4, -3, 0}, {0, 0, 0}), Color(0), exact);
}

TEST(Absorption, WeakensByTheLengthOfTheWayInside) {
    Material m = glass(1.5);
    m.absorption = {0.5, 1, 0};
    Scene scene = empty_scene();
    show(scene, Sphere{{0, 0, 0}, 1.5}, m);
    EXPECT_COLOR_NEAR(seen(scene, {0, 0, 5}, {0, 0, 0}),
                      Color(std::exp(-1.5), std::exp(-3.0), 1) * sky, exact);
}

TEST(Absorption, WeakensTheLocalAndTheMirroredColourAtTheEndOfTheWayToo) {
    Material water = glass(1.5);
    water.absorption = {0.5, 1, 2};
    Scene scene = empty_scene();
    show(scene, Plane{{0, 1, 0}, 0}, water);
    Material floor = mirror(Color(0.5));
    floor.emission = Color(0.25);
    show(scene, Plane{{0, 1, 0}, -0.5}, floor);
    // Down 0.5, the floor's own light; mirrored up 0.5 again and out.
    Color expected;
    for (int i = 0; i < 3; ++i) {
        const double once = std::exp(-water.absorption[i] * 0.5);
        expected[i] = once * 0.25 + once * once * 0.5 * sky[i];
    }
    EXPECT_COLOR_NEAR(seen(scene, {0, 3, 0}, {0, 0, 0}), expected, exact);
}

TEST(Absorption, IsThatOfTheBodyEnteredLast) {
    Material outer = glass(1);
    outer.absorption = {1, 0, 0};
    Material inner = glass(1);
    inner.absorption = {0, 1, 0};
    Scene scene = empty_scene();
    show(scene, Sphere{{0, 0, 0}, 1}, outer);
    show(scene, Sphere{{0, 0, 0}, 0.25}, inner);
    EXPECT_COLOR_NEAR(seen(scene, {0, 0, 5}, {0, 0, 0}),
                      Color(std::exp(-1.5), std::exp(-0.5), 1) * sky, exact);
}

TEST(Depth, OneTracesPrimaryRaysOnly) {
    Scene scene = empty_scene();
    Material m = mirror(Color(0.5));
    m.emission = Color(0.25);
    show(scene, Plane{{0, 1, 0}, 0}, m);
    scene.settings.max_depth = 1;
    EXPECT_COLOR_NEAR(seen(scene, {3, 4, 0}, {0, 0, 0}), Color(0.25), exact);
    scene.settings.max_depth = 2;
    EXPECT_COLOR_NEAR(seen(scene, {3, 4, 0}, {0, 0, 0}), Color(0.25) + 0.5 * sky, exact);
}

TEST(Depth, ABendCountsAndAStraightPassDoesNot) {
    Scene scene = empty_scene();
    for (int i = 0; i < 5; ++i) {
        const double y = -i;
        show(scene, Triangle{{Vec3d(-9, y, -9), Vec3d(9, y, -9), Vec3d(0, y, 9)}}, glass(1, 0.9));
    }
    scene.settings.max_depth = 1;
    EXPECT_COLOR_NEAR(seen(scene, {0, 5, 0}, {0, 0, 0}), std::pow(0.9, 5) * sky, exact);
    show(scene, Sphere{{0, -9, 0}, 1}, glass(1.5));  // bends twice
    scene.settings.max_depth = 2;
    EXPECT_COLOR_NEAR(seen(scene, {0, 5, 0}, {0, 0, 0}), Color(0), exact);
    scene.settings.max_depth = 3;
    EXPECT_COLOR_NEAR(seen(scene, {0, 5, 0}, {0, 0, 0}), std::pow(0.9, 5) * sky, exact);
}

TEST(Depth, AStraightRayPassesThousandSheetsAndNoMore) {
    for (const int sheets : {1000, 1001}) {
        Scene scene = empty_scene();
        for (int i = 0; i < sheets; ++i) {
            const double y = -i;
            show(scene, Triangle{{Vec3d(-9, y, -9), Vec3d(9, y, -9), Vec3d(0, y, 9)}}, glass(1, 1));
        }
        EXPECT_COLOR_NEAR(seen(scene, {0, 5, 0}, {0, 0, 0}), sheets == 1000 ? sky : Color(0),
                          exact);
    }
}

TEST(MinContribution, IsTheProductOfTheLargestChannelsAlongTheWay) {
    Scene scene = empty_scene();
    show(scene, Plane{{0, 1, 0}, 0}, mirror({0.1, 0.5, 0.2}));
    show(scene, Plane{{-1, 0, 0}, -3}, mirror({0.4, 0.1, 0.2}));
    // Two reflections: 0.5 * 0.4, although no channel brings more than 0.05.
    const Color twice = Color(0.1 * 0.4, 0.5 * 0.1, 0.2 * 0.2) * sky;
    scene.settings.min_contribution = 0.2 * (1 - 1e-12);
    EXPECT_COLOR_NEAR(seen(scene, {-3, 4, 0}, {0, 0, 0}), twice, exact);
    scene.settings.min_contribution = 0.2 * (1 + 1e-12);
    EXPECT_COLOR_NEAR(seen(scene, {-3, 4, 0}, {0, 0, 0}), Color(0), exact);
}

TEST(MinContribution, CountsWhatPassesToo) {
    Scene scene = empty_scene();
    show(scene, Sphere{{0, 0, 0}, 1}, glass(1, 0.1, 0.4, {1, 0, 0}));
    scene.settings.min_contribution = 0.24;
    EXPECT_COLOR_NEAR(seen(scene, {0, 5, 0}, {0, 0, 0}), Color(0.25, 0.01, 0.01) * sky, exact);
    scene.settings.min_contribution = 0.26;
    EXPECT_COLOR_NEAR(seen(scene, {0, 5, 0}, {0, 0, 0}), Color(0), exact);
}

TEST(Alpha, AnImagesAlphaReplacesFilterAndTransmission) {
    auto image = std::make_shared<Image>(1, 1, 4);
    image->data = {0.8, 0.4, 0.2, 0.25};
    Scene scene = empty_scene();
    scene.images.push_back({"one texel", false, image});
    scene.textures.push_back({ImageTexture{}, {}});
    Material m = glowing(Color(1));
    m.texture = 0;
    m.transmission = 0.5;  // ignored
    m.filter = 0.5;
    show(scene, Plane{{0, 1, 0}, 0}, m);
    show(scene, Plane{{0, 1, 0}, -1}, glowing({0, 1, 0}));
    EXPECT_COLOR_NEAR(seen(scene, {0, 5, 0}, {0, 0, 0}),
                      0.25 * Color(0.8, 0.4, 0.2) + 0.75 * Color(0, 1, 0), exact);
}

TEST(Alpha, OutsideOfAnImageShownOnceEverythingPasses) {
    auto image = std::make_shared<Image>(1, 1, 3);
    image->data = {0.8, 0.4, 0.2};
    Scene scene = empty_scene();
    scene.images.push_back({"one texel", false, image});
    ImageTexture once;
    once.wrap = ImageTexture::Wrap::once;
    scene.textures.push_back({once, {}});
    Material m = glowing(Color(1));
    m.texture = 0;
    show(scene, Plane{{0, 0, 1}, 0}, m);
    show(scene, Plane{{0, 0, 1}, -1}, glowing({0, 1, 0}));
    EXPECT_COLOR_NEAR(seen(scene, {0.5, 0.5, 5}, {0.5, 0.5, 0}), Color(0.8, 0.4, 0.2), exact);
    EXPECT_COLOR_NEAR(seen(scene, {1.5, 0.5, 5}, {1.5, 0.5, 0}), Color(0, 1, 0), exact);
}

}  // namespace
}  // namespace lancer
