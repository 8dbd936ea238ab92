// Complete validations: our tracer, the exporter and POV-Ray. Each inserted error is on our side
// only.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/judge/validate_fixture.h"
#include "tests/reference/pov/pair_scenes.h"
#include "tests/reference/pov/scene_kit.h"

namespace lancer::judge {
namespace {

TEST_F(Validate, SolidsAgree) {
    const Validation v = validate(solids_scene());
    EXPECT_EQ(v.verdict, Verdict::agrees) << said(v);
    EXPECT_LE(v.judgement.interior_max, 2e-5);
}

TEST_F(Validate, NestedGlassAgrees) {
    const Validation v = validate(glass_nested_scene());
    EXPECT_EQ(v.verdict, Verdict::agrees) << said(v);
}

TEST_F(Validate, PlanarTexturesAgree) {
    const Validation v = validate(tex_planar_scene());
    EXPECT_EQ(v.verdict, Verdict::agrees) << said(v);
}

TEST_F(Validate, CatchesALampOnePercentDimmer) {
    expect_caught(
        solids_scene(), [](Scene& scene) { scene.lights[0].color = 0.99 * scene.lights[0].color; },
        2000);
}

TEST_F(Validate, CatchesAMissingObject) {
    for (std::size_t i = 1; i < solids_scene().objects.size(); ++i) {
        SCOPED_TRACE(i);
        expect_caught(
            solids_scene(),
            [i](Scene& scene) {
                scene.objects.erase(scene.objects.begin() + static_cast<std::ptrdiff_t>(i));
            },
            50);
    }
}

TEST_F(Validate, CatchesAnIorOffByAHundredth) {
    expect_caught(
        glass_nested_scene(),
        [](Scene& scene) {
            for (Material& material : scene.materials) {
                if (material.ior > 1) material.ior += 0.01;
            }
        },
        500);
}

TEST_F(Validate, CatchesATextureShiftedByATexel) {
    expect_caught(
        tex_planar_scene(),
        [](Scene& scene) {
            // One column of texels: the picture itself is turned, the mapping stays.
            for (SceneImage& image : scene.images) {
                auto turned = std::make_shared<Image>(*image.pixels);
                for (int y = 0; y < turned->height; ++y) {
                    for (int x = 0; x < turned->width; ++x) {
                        const double* from = image.pixels->pixel((x + 1) % turned->width, y);
                        std::copy(from, from + turned->channels, turned->pixel(x, y));
                    }
                }
                image.pixels = turned;
            }
        },
        500);
}

TEST_F(Validate, CatchesACameraOffByAFiveThousandthOfAPixel) {
    for (const Scene& scene : {solids_scene(), glass_nested_scene(), tex_planar_scene()}) {
        const Validation v = validate(scene, [](Scene& ours) {
            Camera& camera = ours.cameras[0];
            const Vec3d forward = camera.look_at - camera.position;
            const Vec3d right = normalize(cross(forward, camera.up));
            const auto* lens = std::get_if<PerspectiveProjection>(&camera.projection);
            ASSERT_NE(lens, nullptr);
            const double pixel = 2 * length(forward) * std::tan(radians(lens->fov) / 2) / 120;
            camera.look_at += 0.005 * pixel * right;
        });
        EXPECT_EQ(v.verdict, Verdict::differs);
        EXPECT_TRUE(v.judgement.picture_shift.is_significant(1e-3, 5) ||
                    v.judgement.count(PixelClass::unexplained) > 0)
            << said(v);
    }
}

TEST_F(Validate, CatchesAFlippedNormal) {
    // A smooth triangle, and one of its three normals to the other side.
    Scene scene = solids_scene();
    const std::uint32_t red = scene.objects[1].material;
    scene.triangle_attributes.push_back({});
    scene.triangle_attributes[0].normals = {Vec3d(-0.3, 0, 1), Vec3d(0.3, 0, 1), Vec3d(0, 0.3, 1)};
    add_object(scene, Triangle{{Vec3d(-1, 0.6, 3), Vec3d(1, 0.6, 3), Vec3d(0, 2.2, 2)}, 0}, red);
    EXPECT_EQ(validate(scene).verdict, Verdict::agrees);
    expect_caught(
        scene,
        [](Scene& ours) {
            Vec3d& normal = (*ours.triangle_attributes[0].normals)[1];
            normal = -normal;
        },
        500);
}

TEST_F(Validate, CatchesBodiesTakenInTheOtherOrder) {
    // The camera is inside two bodies, declared in either order. A renderer that assumes the first
    // declared one as the medium around the camera would take the inner body's index for the outer
    // one's.
    for (const bool inner_first : {false, true}) {
        Scene scene = glass_nested_scene();
        Material outer;
        outer.diffuse = outer.ambient = 0;
        outer.transmission = 1;
        outer.ior = 1.5;
        Material inner = outer;
        inner.ior = 1.2;
        const Vec3d eye = scene.cameras[0].position;
        const std::uint32_t outer_material = add_material(scene, outer);
        const std::uint32_t inner_material = add_material(scene, inner);
        const Sphere large{eye, 1.5};
        const Sphere small{eye + Vec3d(0.2, 0, 0), 0.6};
        if (inner_first) add_object(scene, small, inner_material);
        add_object(scene, large, outer_material);
        if (!inner_first) add_object(scene, small, inner_material);
        const Validation v = validate(scene);
        EXPECT_EQ(v.verdict, Verdict::agrees) << said(v);
        expect_caught(
            scene, [=](Scene& ours) { ours.materials[inner_material].ior = 1.5; }, 1000);
    }
}

TEST_F(Validate, CatchesAWrongGamma) {
    const Scene scene = solids_scene();
    ValidationJob job;
    job.name = "gamma";
    job.scene = std::make_shared<Scene>(scene);
    job.view = {0, 160, 120};
    const OurRenderer renderer = [](const std::shared_ptr<const Scene>& given,
                                    const reference::ExportView& view) {
        OurPicture picture = render_ours(given, view);
        for (double& value : picture.image.data) value = std::pow(value, 1 / 2.2);
        return picture;
    };
    const Validation v = validate_scene(job, renderer, reference::find_povray(), {});
    EXPECT_EQ(v.verdict, Verdict::differs);
    EXPECT_GT(v.judgement.count(PixelClass::unexplained), v.judgement.pixels / 2);
}

TEST_F(Validate, CatchesNotANumber) {
    ValidationJob job;
    job.name = "nan";
    job.scene = std::make_shared<Scene>(solids_scene());
    job.view = {0, 32, 24};
    const OurRenderer renderer = [](const std::shared_ptr<const Scene>& given,
                                    const reference::ExportView& view) {
        OurPicture picture = render_ours(given, view);
        picture.image.data[7] = std::numeric_limits<double>::quiet_NaN();
        return picture;
    };
    const Validation v = validate_scene(job, renderer, reference::find_povray(), {});
    EXPECT_EQ(v.verdict, Verdict::differs);
    EXPECT_THAT(said(v), testing::HasSubstr("NaN"));
}

TEST_F(Validate, BrightScenesAreExposedOnBothSides) {
    Scene scene = solids_scene();
    for (Light& light : scene.lights) light.color = 8.0 * light.color;
    const Validation v = validate(scene);
    EXPECT_LT(v.exposure, 1);
    EXPECT_EQ(v.verdict, Verdict::agrees) << said(v);
}

TEST_F(Validate, ShowsALightOnACurvedSurface) {
    Scene scene = empty_scene();
    add_object(scene, Plane{{0, 1, 0}, -1});
    add_object(scene, Sphere{{-0.75, 0, 0}, 0.625});
    add_object(scene, Box{{0.25, -1, -0.5}, {1.25, 0, 0.5}});
    scene.lights[0].kind = PointLight{{-0.375, 0.5, 0}, {}};  // 3, 4 and 5 eighths
    const Validation v = validate(scene);
    EXPECT_EQ(v.verdict, Verdict::differs);
    EXPECT_GE(v.judgement.count(PixelClass::unexplained), 1000u);
}

TEST_F(Validate, AnExpectedRefusalThatDoesNotComeFails) {
    Expectations expect;
    expect.refused = true;
    const Validation v = validate(solids_scene(), {}, expect);
    EXPECT_EQ(v.verdict, Verdict::failed);
    EXPECT_THAT(said(v), testing::HasSubstr("expected to refuse"));
}

TEST(ValidateWithoutPovRay, SaysWhatWentWrong) {
    ValidationJob job;
    job.name = "nowhere";
    job.scene = std::make_shared<Scene>(solids_scene());
    job.view = {0, 8, 6};
    reference::PovRay missing;
    missing.program = "/nonexistent/povray";
    const Validation v = validate_scene(job, render_ours, missing, {});
    EXPECT_EQ(v.verdict, Verdict::failed);
    EXPECT_FALSE(v.reasons.empty());
}

}  // namespace
}  // namespace lancer::judge
