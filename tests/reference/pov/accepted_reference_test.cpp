// POV-Ray accepts everything that the exporter can write without a warning.
#include <gmock/gmock.h>

#include "tests/reference/pov/povray_fixture.h"
#include "tests/reference/pov/scene_kit.h"

namespace lancer::reference {
namespace {

class Accepted : public WithPovRay {
  protected:
    void expect_accepted(const Scene& scene) const {
        const ExportView view{0, 32, 24};
        const ExportResult result = exported(scene, view);
        const PovJob job{"accepted", result.text, result.assets, view.width, view.height};
        try {
            // POV-Ray calls `diffuse F, B` experimental wherever it stands.
            for (const std::string& warning : run_povray(povray_, job).warnings)
                EXPECT_THAT(warning, testing::HasSubstr("backside illumination")) << result.text;
        } catch (const FileError& error) {
            ADD_FAILURE() << error.what() << "\n" << result.text;
        }
    }

    /// All shapes side by side in this material; `uv`: only those that have texture coordinates.
    static void show_all(Scene& scene, std::uint32_t material, bool uv = false) {
        double x = -8;
        for (const Shape& shape : all_shapes(scene)) {
            if (uv && std::holds_alternative<PrismRef>(shape)) continue;
            Affine<double> place;
            place.rows = {Vec3d(0.9, 0.1, 0), Vec3d(-0.1, 0.8, 0), Vec3d(0, 0, 1.1)};
            place.shift = {x += 0.7, 0, -3};
            add_object(scene, shape, material).transform = add_transform(scene, place);
            add_object(scene, shape, material);
        }
    }
};

TEST_F(Accepted, EveryShapeInAPlainMaterial) {
    Scene scene = empty_scene();
    show_all(scene, 0);
    expect_accepted(scene);
}

TEST_F(Accepted, EveryTermOfAMaterialOnEveryShape) {
    Scene scene = empty_scene();
    scene.settings.max_depth = 3;
    Material all;
    all.color = {0.9, 0.8, 0.7};
    all.emission = {0.1, 0.2, 0};
    all.phong = 0.4;
    all.blinn = 0.3;
    all.metallic = 0.5;
    all.reflection = {0.2, 0.3, 0.1};
    all.fresnel = true;
    all.transmission = 0.3;
    all.filter = 0.4;
    all.ior = 1.4;
    all.absorption = {0.5, 0, 0.2};
    all.diffuse_transmission = 0.3;
    show_all(scene, add_material(scene, all));
    scene.objects.back().casts_shadow = false;
    expect_accepted(scene);
}

TEST_F(Accepted, EveryLight) {
    Scene scene = empty_scene();
    add_object(scene, Sphere{});
    const std::vector<LightKind> kinds{PointLight{{1, 2, 3}, Fade{4, 2}},
                                       DirectionalLight{{1, -2, 0.5}},
                                       SpotLight{{1, 2, 3}, {0, 0, 0}, 20, 30, 2, Fade{3, 1.5}},
                                       SpotLight{{1, 2, 3}, {0, 0, 0}, 20, 20, 0, {}}};
    for (const LightKind& kind : kinds)
        for (const bool shadows : {true, false})
            if (shadows || !std::holds_alternative<SpotLight>(kind))  // refused: no cone
                scene.lights.push_back({kind, {1, 0, 2}, shadows, {}});
    expect_accepted(scene);
}

TEST_F(Accepted, CheckerAndGradientOnEveryShape) {
    Scene scene = empty_scene();
    Affine<double> turned;
    turned.rows = {Vec3d(0, -0.5, 0), Vec3d(0.5, 0, 0), Vec3d(0, 0, 0.5)};
    show_all(scene, add_texture(scene, {Checker{}, turned}));
    Gradient gradient;
    gradient.axis = {1, 2, 0};
    gradient.stops = {{0, {1, 0, 0}}, {0.5, {0, 1, 0}}, {0.5, {0, 0, 1}}, {1, {1, 1, 1}}};
    show_all(scene, add_texture(scene, {gradient, turned}));
    scene.materials.back().transmission = 0.5;
    expect_accepted(scene);
}

TEST_F(Accepted, EveryMappingOfImagesOnEveryShape) {
    for (const bool alpha : {false, true}) {
        Scene scene = empty_scene();
        scene.settings.max_depth = 2;
        using T = ImageTexture;
        for (const auto mapping :
             {T::Mapping::planar, T::Mapping::spherical, T::Mapping::cylindrical, T::Mapping::uv})
            for (const auto filter : {T::Filter::nearest, T::Filter::bilinear})
                for (const auto wrap : {T::Wrap::repeat, T::Wrap::once}) {
                    const T image{add_image(scene, alpha), mapping, filter, wrap};
                    const std::uint32_t material = add_texture(scene, {image, {}});
                    scene.materials[material].transmission = 0.25;
                    scene.materials[material].filter = 0.25;
                    show_all(scene, material, mapping == T::Mapping::uv);
                }
        expect_accepted(scene);
    }
}

TEST_F(Accepted, OrthographicAndManyStops) {
    Scene scene = empty_scene();
    scene.cameras[0].projection = OrthographicProjection{3};
    Gradient gradient;
    for (int i = 0; i < 256; ++i) gradient.stops.push_back({i / 255.0, Color(i % 2)});
    add_object(scene, Sphere{}, add_texture(scene, {gradient, {}}));
    gradient.stops.resize(1);
    add_object(scene, Box{}, add_texture(scene, {gradient, {}}));
    expect_accepted(scene);
}

TEST_F(Accepted, NamesFullOfSurprises) {
    Scene scene = empty_scene();
    scene.material_names = {"", "texture"};
    scene.names = {"a\nsphere { 0, 1 } \\"};
    const std::uint32_t material = add_material(scene, {});
    add_object(scene, Sphere{}, material).name = 0;
    expect_accepted(scene);
}

}  // namespace
}  // namespace lancer::reference
