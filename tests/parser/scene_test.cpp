// What blocks become in the Scene.
#include <gtest/gtest.h>

#include "model/quality.h"
#include "tests/parser/script.h"

namespace lancer {
namespace {

using test::run;

template <class Shape>
Shape only_shape(const std::string& text) {
    const test::Result result = run(text);
    EXPECT_EQ(result.messages, "");
    if (result.scene.objects.size() != 1) {
        ADD_FAILURE() << result.scene.objects.size() << " objects";
        return {};
    }
    return std::get<Shape>(result.scene.objects[0].shape);
}

TEST(SceneFromScript, ASphereNeedsOnlyItsRadius) {
    const auto sphere = only_shape<Sphere>("sphere { radius 2 }");
    EXPECT_EQ(sphere.center, Vec3d(0, 0, 0));
    EXPECT_EQ(sphere.radius, 2);
}

TEST(SceneFromScript, AQualityGivesWayToWhatIsWritten) {
    const Settings fine = run("render { quality fine }").scene.settings;
    EXPECT_EQ(fine.samples, values_of(Quality::fine).samples);
    EXPECT_EQ(fine.sampling, Sampling::sobol);
    EXPECT_EQ(fine.max_depth, values_of(Quality::fine).max_depth);
    EXPECT_EQ(fine.min_contribution, values_of(Quality::fine).min_contribution);
    const auto result = run(
        "render { samples 2 sampling grid quality draft max_depth 3 min_contribution 0.5 tolerance "
        "1 }");
    EXPECT_EQ(result.messages, "");
    EXPECT_EQ(result.scene.settings.samples, 2);
    EXPECT_EQ(result.scene.settings.sampling, Sampling::grid);
    EXPECT_EQ(result.scene.settings.max_depth, 3);
    EXPECT_EQ(result.scene.settings.min_contribution, 0.5);
    EXPECT_EQ(result.scene.settings.tolerance, 1);
    EXPECT_NE(run("render { quality best }").messages.find("draft, normal, fine or exact"),
              std::string::npos);
}

TEST(SceneFromScript, PropertiesStandInAnyOrderAndBeforeParentheses) {
    const auto box = only_shape<Box>("let p = [1, 2, 3] box { max (p + p) min (p - p) }");
    EXPECT_EQ(box.min, Vec3d(0, 0, 0));
    EXPECT_EQ(box.max, Vec3d(2, 4, 6));
}

TEST(SceneFromScript, TransformsActInTheOrderWritten) {
    const auto result = run("sphere { radius 1 translate [1, 0, 0] rotate_z 90 scale [1, 3, 1] }");
    EXPECT_EQ(result.messages, "");
    const auto& m = result.scene.transforms.at(result.scene.objects.at(0).transform);
    EXPECT_EQ(map_point(m, Vec3d(0, 0, 0)), Vec3d(0, 3, 0));
}

TEST(SceneFromScript, AGroupMovesItsChildrenAndItsLightsButNoCamera) {
    const auto result =
        run("group { group { sphere { radius 1 translate [1, 0, 0] } scale 2 }"
            " light point { position [0, 0, 1] } camera { position [0, 0, 0] look_at [0, 0, -1] }"
            " translate [0, 5, 0] }");
    EXPECT_EQ(result.messages, "");
    const auto& m = result.scene.transforms.at(result.scene.objects.at(0).transform);
    EXPECT_EQ(map_point(m, Vec3d(0, 0, 0)), Vec3d(2, 5, 0));
    EXPECT_EQ(std::get<PointLight>(result.scene.lights.at(0).kind).position, Vec3d(0, 5, 1));
    EXPECT_EQ(result.scene.cameras.at(0).position, Vec3d(0, 0, 0));
}

TEST(SceneFromScript, AGroupsMaterialIsTheDefaultOfItsChildren) {
    const auto result =
        run("material red { color [1, 0, 0] } material blue { color [0, 0, 1] }"
            "group { sphere { radius 1 } sphere { radius 1 material blue } material red }"
            "sphere { radius 1 }");
    EXPECT_EQ(result.messages, "");
    const auto color = [&](std::size_t i) {
        return result.scene.materials.at(result.scene.objects.at(i).material).color;
    };
    EXPECT_EQ(color(0), Color(1, 0, 0));
    EXPECT_EQ(color(1), Color(0, 0, 1));
    EXPECT_EQ(color(2), Color(1, 1, 1));
}

TEST(SceneFromScript, AMaterialStandsInlineInAShapeAndAGroup) {
    const auto result =
        run("sphere { radius 1 material { color [0, 1, 0] } }"
            "group { material { color [0, 0, 1] } sphere { radius 1 } }");
    EXPECT_EQ(result.messages, "");
    EXPECT_EQ(result.scene.materials.at(result.scene.objects.at(0).material).color, Color(0, 1, 0));
    EXPECT_EQ(result.scene.materials.at(result.scene.objects.at(1).material).color, Color(0, 0, 1));
}

TEST(SceneFromScript, AFileIsLoadedOnceHoweverOftenItIsNamed) {
    const auto result =
        run("for i in 0..3 { mesh { file \"a.obj\" translate [i, 0, 0] } }"
            "texture a { image \"a.png\" } texture b { image \"a.png\" color_space \"linear\" }"
            "texture c { image \"a.png\" wrap once }");
    EXPECT_EQ(result.messages, "");
    EXPECT_EQ(result.scene.meshes.size(), 1u);
    EXPECT_EQ(result.scene.images.size(), 2u);
    EXPECT_EQ(result.scene.textures.size(), 3u);
}

TEST(SceneFromScript, ImagesHaveThreeChannelsOrFourWhateverTheFileHas) {
    const auto result =
        run("texture a { image \"grey.png\" } texture b { image \"layers.exr\" }"
            "texture c { image \"plain.png\" }");
    ASSERT_EQ(result.messages, "");
    ASSERT_EQ(result.scene.images.size(), 3u);
    for (const SceneImage& image : result.scene.images) {
        EXPECT_EQ(image.pixels->channels, 3) << image.path;
        EXPECT_EQ(image.pixels->data.size(), 3u) << image.path;
    }
}

TEST(SceneFromScript, TheLastHandleOfABezierOutlineMayLieOnItsFirstPoint) {
    const std::string nine =
        "[0, 0], [1, 3], [3, 3], [4, 0], [4, -1], [3, -2], [2, -2], [2, -2], [0, 0]";
    const auto outline_of = [](const std::string& points) {
        const auto result = run("prism { spline bezier bottom 0 top 1 outline [" + points + "] }");
        EXPECT_EQ(result.messages, "");
        return result.scene.prisms.at(0).outline;
    };
    const std::vector<Vec2d> outline = outline_of(nine);
    EXPECT_EQ(outline.size(), 9u);
    EXPECT_EQ(outline.back(), Vec2d(0, 0));
    // The point after 3n is the first one again.
    EXPECT_EQ(outline_of(nine + ", [0, 0]"), outline);
    EXPECT_EQ(run("prism { bottom 0 top 1 outline [[0, 0], [1, 0], [0, 1], [0, 0]] }")
                  .scene.prisms.at(0)
                  .outline.size(),
              3u);
}

TEST(SceneFromScript, APolygonBecomesTriangles) {
    const auto result =
        run("mesh { vertices [[0,0,0], [1,0,0], [1,1,0], [0,1,0]] faces [[0, 1, 2, 3]] }");
    EXPECT_EQ(result.messages, "");
    EXPECT_EQ(result.scene.meshes.at(0)->faces.size(), 2u);
}

}  // namespace
}  // namespace lancer
