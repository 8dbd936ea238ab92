// Lathes, prisms and patches in whole pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/diagnostic.h"
#include "model/splines.h"
#include "tracer/render.h"

namespace lancer {
namespace {

const std::vector<Vec2d> spindle{{0, -1}, {0.7, -0.2}, {0.3, 0.1}, {0.9, 0.5}, {0, 1}};
const std::vector<Vec2d> goblet{{0, -0.9},  {0.9, -0.9}, {0.1, -0.3}, {0.8, 0.3},
                                {0.9, 0.8}, {0.2, 0.9},  {0, 0.2}};
const std::vector<Vec2d> star{{1, 0},    {0.3, 0.2},   {0.2, 1},  {-0.2, 0.4},
                              {-1, 0.5}, {-0.4, -0.2}, {0, -1.1}, {0.3, -0.3}};

Affine<double> turned_and_scaled(double factor) {
    Affine<double> m;
    m.rows = {Vec3d(0.8, -0.36, 0.48) * factor, Vec3d(0.6, 0.48, -0.64) * factor,
              Vec3d(0, 0.8, 0.6) * factor};
    return m;
}

/// One spline body before a camera at distance 4, everything scaled by `factor`.
class Stage {
  public:
    explicit Stage(double factor = 1) : factor_(factor) {
        scene.settings.min_contribution = 0;
        scene.settings.max_depth = 20;
        scene.background = {0.3, 0.5, 0.7};
        Camera camera;
        camera.position = Vec3d(0.5, 1.1, 4) * factor;
        camera.look_at = Vec3d(0, 0, 0);
        scene.cameras.push_back(camera);
        Light light;
        light.kind = PointLight{Vec3d(3, 5, 4) * factor, {}};
        scene.lights.push_back(light);
    }

    void add(const Shape& shape, const Material& material, bool turned = true) {
        scene.materials.push_back(material);
        Object object;
        object.shape = shape;
        object.material = static_cast<std::uint32_t>(scene.materials.size() - 1);
        scene.transforms.push_back(turned ? turned_and_scaled(factor_) : Affine<double>{});
        object.transform = static_cast<std::uint32_t>(scene.transforms.size() - 1);
        scene.objects.push_back(object);
    }
    void add_lathe(Spline spline, const std::vector<Vec2d>& profile, const Material& material) {
        scene.lathes.push_back({profile, spline, {}});
        add(LatheRef{static_cast<std::uint32_t>(scene.lathes.size() - 1)}, material);
    }
    void add_prism(Spline spline, const std::vector<Vec2d>& outline, const Material& material) {
        scene.prisms.push_back({outline, spline, -0.6, 0.5, true, {}});
        add(PrismRef{static_cast<std::uint32_t>(scene.prisms.size() - 1)}, material);
    }

    Image render(int size = 48) {
        counts = {};
        return compile(scene, scene.settings)->render({0, size, size, {}, false}, {}, counts);
    }

    Scene scene;
    RayCounts counts;

  private:
    double factor_;
};

Material glass(double ior) {
    Material m;
    m.ambient = m.diffuse = 0;
    m.transmission = 1;
    m.ior = ior;
    return m;
}

void add_body(Stage& stage, int which, const Material& material) {
    switch (which) {
        case 0:
            stage.add_lathe(Spline::linear, spindle, material);
            break;
        case 1:
            stage.add_lathe(Spline::bezier, goblet, material);
            break;
        case 2:
            stage.add_prism(Spline::linear, star, material);
            break;
        default:
            stage.add_prism(Spline::catmull_rom, star, material);
            break;
    }
}

TEST(SplineSolids, ClearGlassOfIndexOneIsNotThere) {
    for (int which = 0; which < 4; ++which) {
        Stage stage;
        const Image empty = stage.render();
        add_body(stage, which, glass(1));
        EXPECT_EQ(stage.render().data, empty.data) << which;
    }
}

TEST(SplineSolids, GlassLosesNoCrossing) {
    for (int which = 0; which < 4; ++which) {
        Stage stage;
        add_body(stage, which, glass(1.5));
        stage.render(200);
        EXPECT_GT(stage.counts.transmitted, 1000u) << which;
        EXPECT_EQ(stage.counts.media_lost, 0u) << which;
    }
}

TEST(SplineSolids, PowersOfTwoChangeNoBit) {
    for (int which = 0; which < 4; ++which) {
        Stage small;
        add_body(small, which, glass(1.5));
        const Image reference = small.render();
        for (const int exponent : {-100, -20, 30, 100}) {
            Stage scaled(std::ldexp(1.0, exponent));
            add_body(scaled, which, glass(1.5));
            EXPECT_EQ(scaled.render().data, reference.data) << which << " " << exponent;
        }
    }
}

TEST(SplineSolids, PowersOfTenChangeNothingThatOneSees) {
    for (int which = 0; which < 4; ++which) {
        Stage small;
        Material matte;
        add_body(small, which, matte);
        const Image reference = small.render();
        for (const double factor : {1e-90, 1e-9, 1e9, 1e90}) {
            Stage scaled(factor);
            add_body(scaled, which, matte);
            const Image image = scaled.render();
            int wrong = 0;
            for (std::size_t i = 0; i < image.data.size(); ++i)
                wrong += std::abs(image.data[i] - reference.data[i]) > 1e-4;
            EXPECT_EQ(wrong, 0) << which << " " << factor;
        }
    }
}

TEST(SplineSolids, AClosedBodyShowsNoLightFromBehindItsSeams) {
    // A black body before a white world, the camera aimed at seams from ever nearer: all black.
    for (int which = 0; which < 4; ++which) {
        for (double zoom = 1; zoom > 1e-12; zoom /= 100) {
            Stage stage;
            stage.scene.background = {1, 1, 1};
            Material black;
            black.color = {0, 0, 0};
            add_body(stage, which, black);
            // An inner joint: the lathe's second point, or the prism's edge between side and top.
            const Affine<double> map = turned_and_scaled(1);
            const Vec3d joint = which < 2 ? (which == 0 ? Vec3d(0.3, 0.1, 0) : Vec3d(0.8, 0.3, 0))
                                          : Vec3d(0.3, 0.5, 0.2);
            const Vec3d inner = which < 2 ? Vec3d(0, 0.1, 0) : Vec3d(0.05, 0.1, 0.05);
            Camera& camera = stage.scene.cameras.front();
            const Vec3d seam = map_point(map, joint);
            const Vec3d towards = map_point(map, inner) - seam;
            camera.position = seam - 3.0 * towards;
            camera.look_at = seam;
            camera.up = {0.1, 0.9, 0.3};
            camera.projection = OrthographicProjection{1e-2 * zoom};
            const Image image = stage.render(64);
            int leaks = 0;
            for (const double value : image.data) leaks += value > 0;
            EXPECT_EQ(leaks, 0) << which << " " << zoom;
        }
    }
}

/// Counts lit pixels of a black body in front of a white world, seen from outside at a place of its
/// surface, towards a place inside.
int leaks(Stage& stage, const Vec3d& at, const Vec3d& within, double height) {
    Camera& camera = stage.scene.cameras.front();
    camera.position = at - 3.0 * (within - at);
    camera.look_at = at;
    camera.up = {0.1, 0.9, 0.3};
    camera.projection = OrthographicProjection{height};
    const Image image = stage.render(48);
    return static_cast<int>(
        std::ranges::count_if(image.data, [](double value) { return value > 0; }));
}

Stage black_stage() {
    Stage stage;
    stage.scene.background = {1, 1, 1};
    return stage;
}

Material black() {
    Material m;
    m.color = {0, 0, 0};
    return m;
}

TEST(SplineSolids, NoJointOfAnyKindOfCurveLeaksAtAnyZoom) {
    const std::vector<Vec2d> flower{{1, 0},       {0.9, 0.5}, {0.3, 0.9},  {-0.5, 0.8}, {-1, 0.3},
                                    {-0.9, -0.4}, {-0.4, -1}, {0.4, -0.9}, {0.9, -0.5}};
    const Affine<double> map = turned_and_scaled(1);
    for (const Spline spline :
         {Spline::linear, Spline::bezier, Spline::bspline, Spline::catmull_rom}) {
        Stage lathe = black_stage();
        lathe.add_lathe(spline, goblet, black());
        Stage prism = black_stage();
        const auto& outline = spline == Spline::bezier ? flower : star;
        prism.add_prism(spline, outline, black());
        int joints = 0;
        for (double zoom = 1; zoom > 1e-13; zoom /= 1e3) {
            const PlaneCurve profile = profile_curve(spline, goblet);
            for (std::size_t i = 1; i < profile.segments(); ++i) {
                const Vec2d p = profile.points[i * static_cast<std::size_t>(profile.degree)];
                EXPECT_EQ(leaks(lathe, map_point(map, Vec3d(p.x, p.y, 0)),
                                map_point(map, Vec3d(0, 0, 0)), 0.02 * zoom),
                          0)
                    << "lathe " << static_cast<int>(spline) << " " << i << " " << zoom;
                ++joints;
            }
            const PlaneCurve around = outline_curve(spline, outline);
            for (std::size_t i = 0; i < around.segments(); ++i) {
                const Vec2d p = around.points[i * static_cast<std::size_t>(around.degree)];
                // Beside the joint and, from above, where it meets the cap.
                for (const double y : {0.1, 0.5}) {
                    EXPECT_EQ(leaks(prism, map_point(map, Vec3d(p.x, y, p.y)),
                                    map_point(map, Vec3d(0, 0, 0)), 0.02 * zoom),
                              0)
                        << "prism " << static_cast<int>(spline) << " " << i << " " << y << " "
                        << zoom;
                    ++joints;
                }
            }
        }
        EXPECT_GE(joints, 25);
    }
}

TEST(SplineSolids, APatchIsDrawnAndAPointIsNot) {
    Stage stage;
    const Image empty = stage.render();
    Patch patch;
    for (int i = 0; i < 16; ++i)
        patch.control.emplace_back(i % 4 - 1.5, (i * 7) % 5 * 0.2, i / 4 - 1.5);
    stage.scene.patches.push_back(patch);
    Patch point;
    point.control.assign(16, Vec3d(0.5, 0.5, 0.5));
    stage.scene.patches.push_back(point);
    stage.add(PatchRef{1}, Material{});
    EXPECT_EQ(stage.render().data, empty.data);
    stage.add(PatchRef{0}, Material{});
    EXPECT_NE(stage.render().data, empty.data);
}

TEST(SplineSolids, AToleranceBeyondReachIsAnErrorAtThePatch) {
    Stage stage;
    Patch patch;
    for (int i = 0; i < 16; ++i) patch.control.emplace_back(i % 4, (i * 7) % 5, i / 4);
    patch.tolerance = 1e-14;
    stage.scene.patches.push_back(patch);
    stage.add(PatchRef{0}, Material{});
    stage.scene.objects.back().place = {0, 42, 5};
    try {
        stage.render();
        FAIL() << "no error";
    } catch (const SceneError& error) {
        EXPECT_EQ(error.where.offset, 42u);
    }
}

TEST(SplineSolids, ToleranceIsInWorldUnits) {
    // The same patch ten times as large must not become ten times as rough.
    const auto triangles = [](double factor, std::optional<double> own,
                              std::optional<double> scene) {
        Stage stage(factor);
        Patch patch;
        for (int i = 0; i < 16; ++i) patch.control.emplace_back(i % 4, (i * 7) % 5, i / 4);
        patch.tolerance = own;
        stage.scene.settings.tolerance = scene;
        stage.scene.patches.push_back(patch);
        stage.add(PatchRef{0}, Material{});
        const auto renderer = compile(stage.scene, stage.scene.settings);
        EXPECT_EQ(renderer->counts().triangles, 0u);  // no ray has come near it yet
        renderer->render({0, 16, 16, {}, false}, {}, stage.counts);
        return renderer->counts().triangles;
    };
    EXPECT_EQ(triangles(16, {}, 0.16), triangles(1, {}, 0.01));
    EXPECT_GT(triangles(16, {}, 0.01), 8 * triangles(1, {}, 0.01));
    EXPECT_GT(triangles(16, 0.01, {}), 8 * triangles(1, 0.01, {}));
    EXPECT_EQ(triangles(1, 0.01, 0.1), triangles(1, {}, 0.01));
    EXPECT_EQ(triangles(1, 0.1, 0.01), triangles(1, {}, 0.01));
}

}  // namespace
}  // namespace lancer
