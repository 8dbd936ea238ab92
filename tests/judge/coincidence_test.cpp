// Coincident faces. POV-Ray has no rule for them, so it renders once more with the faces told apart
// by our contact rule. An error of ours must not hide there.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/judge/validate_fixture.h"
#include "tests/reference/pov/scene_kit.h"

namespace lancer::judge {
namespace {

class CoincidentFaces : public Validate {
  protected:
    CoincidentFaces() { view_ = {0, 80, 60}; }

    static std::string unexplained(const Validation& v) {
        std::string text = said(v);
        for (const DifferentPixel& p : v.judgement.different)
            if (p.pixel_class == PixelClass::unexplained)
                text += fmt::format("({}, {}) {:.3g}\n", p.x, p.y, p.difference);
        return text;
    }

    /// Some pixels differ because of coincident faces, and no other differences remain.
    void expect_coincident(const Scene& scene) {
        const Validation v = validate(scene);
        EXPECT_EQ(v.verdict, Verdict::agrees) << unexplained(v);
        EXPECT_GT(v.judgement.count(PixelClass::coincident), 0u);
    }

    /// The error is visible in our picture and unexplained at many of these pixels (the others lie
    /// near edges), and coincident faces never excuse it.
    void expect_not_excused(const Scene& scene, const Fault& fault) {
        const Validation right = validate(scene);
        const Validation v = validate(scene, fault);
        EXPECT_EQ(v.verdict, Verdict::differs);
        std::size_t shown = 0;
        std::size_t excused = 0;
        for (int y = 0; y < v.ours.height; ++y) {
            for (int x = 0; x < v.ours.width; ++x) {
                double most = 0;
                for (int c = 0; c < 3; ++c)
                    most =
                        std::max(most, std::abs(v.ours.pixel(x, y)[c] - right.ours.pixel(x, y)[c]));
                // POV-Ray's second value is within the threshold of both.
                if (most <= 2 * v.thresholds.interior) continue;
                ++shown;
                const auto i = static_cast<std::size_t>(y * v.ours.width + x);
                excused += v.judgement.classes[i] == PixelClass::coincident ? 1 : 0;
            }
        }
        EXPECT_GT(shown, 0u);
        EXPECT_EQ(excused, 0u);
        EXPECT_GE(4 * v.judgement.count(PixelClass::unexplained), shown);
    }
};

Material clear(double ior, double transmission = 0.9) {
    Material m;
    m.ambient = m.diffuse = 0;
    m.transmission = transmission;
    m.ior = ior;
    m.phong = 0.3;
    return m;
}

/// Deep enough for every path: faces that are told apart take two levels where coincident faces
/// take one.
Scene stage() {
    Scene scene = empty_scene();
    scene.background = {0.5, 0.7, 0.9};
    scene.settings.max_depth = 40;
    return scene;
}

/// A turn from axis u towards axis v, in radians.
Affine<double> turn(int u, int v, double angle) {
    Affine<double> map;
    map.rows[static_cast<std::size_t>(u)][u] = map.rows[static_cast<std::size_t>(v)][v] =
        std::cos(angle);
    map.rows[static_cast<std::size_t>(u)][v] = -std::sin(angle);
    map.rows[static_cast<std::size_t>(v)][u] = std::sin(angle);
    return map;
}

/// Tilted, so that rounding decides which coincident face POV-Ray finds; first rotated by `turned`
/// about the vertical.
std::uint32_t add_leaning(Scene& scene, double turned = 0) {
    return add_transform(scene,
                         compose(turn(1, 2, 0.19), compose(turn(0, 1, 0.37), turn(2, 0, turned))));
}

void add_table(Scene& scene, std::uint32_t leaning) {
    Texture texture;
    texture.pattern = Checker{{0.8, 0.75, 0.7}, {0.4, 0.3, 0.25}};
    for (std::size_t i = 0; i < 3; ++i) texture.to_object.rows[i] *= 0.43;
    const std::uint32_t tiles = add_texture(scene, texture);
    add_object(scene, Plane{{0, 1, 0}, -1}, tiles).transform = leaning;
}

Scene cube_on_table() {
    Scene scene = stage();
    scene.cameras[0].position = {0, 2, -5};
    scene.cameras[0].projection = PerspectiveProjection{50};
    add_object(scene, Box{{-0.7, -1, -0.7}, {0.7, 0.4, 0.7}}, add_material(scene, clear(1.5)))
        .transform = add_leaning(scene, 0.63);
    add_table(scene, add_leaning(scene));
    return scene;
}

TEST_F(CoincidentFaces, AGlassCubeOnATable) {
    expect_coincident(cube_on_table());
}

TEST_F(CoincidentFaces, AFaultInSuchASceneIsUnexplained) {
    const std::vector<Fault> faults{
        [](Scene& ours) { ours.materials[1].ior += 0.01; },
        [](Scene& ours) { ours.materials[1].transmission -= 0.01; },
        // Violates the contact rule: air between the glass and the table, visible through the
        // sides.
        [](Scene& ours) { std::get<Box>(ours.objects[0].shape).min.y += 1e-3; },
        // Violates the contact rule: the glass is shown instead of the table.
        [](Scene& ours) {
            ours.objects[1].transform = static_cast<std::uint32_t>(ours.transforms.size());
            Affine<double> lowered = ours.transforms[ours.objects[0].transform];
            lowered.shift.y -= 1e-3;
            ours.transforms.push_back(lowered);
        }};
    for (std::size_t i = 0; i < faults.size(); ++i) {
        SCOPED_TRACE(i);
        expect_not_excused(cube_on_table(), faults[i]);
    }
}

TEST_F(CoincidentFaces, GluedBlocksOfOneGlass) {
    Scene scene = stage();
    const std::uint32_t glass = add_material(scene, clear(1.4, 0.8));
    const std::uint32_t leaning = add_leaning(scene);
    add_object(scene, Box{{-1, -0.8, -0.5}, {0, 0.5, 0.5}}, glass).transform = leaning;
    add_object(scene, Box{{0, -0.6, -0.4}, {0.9, 0.4, 0.4}}, glass).transform = leaning;
    add_table(scene, leaning);
    expect_coincident(scene);
    // One of two glued blocks has another glass: this adds a surface that POV-Ray's second picture
    // does not have.
    expect_not_excused(scene, [](Scene& ours) {
        ours.objects[1].material = add_material(ours, clear(1.41, 0.8));
    });
}

/// POV-Ray has rules of its own for absorption in front of a mirror: they are tried on the one
/// body.
TEST_F(CoincidentFaces, GluedBlocksOfOneGlassThatMirrorsAndAbsorbs) {
    Scene scene = stage();
    scene.settings.max_depth = 7;
    Material glass = clear(1.5, 0.9);
    glass.reflection = Color(1);
    glass.fresnel = true;
    glass.absorption = {0.4, 0.2, 0.1};
    const std::uint32_t matter = add_material(scene, glass);
    const std::uint32_t leaning = add_leaning(scene);
    for (const double left : {-0.9, -0.3, 0.3})
        add_object(scene, Box{{left, -0.7, -0.5}, {left + 0.6, 0.5, 0.5}}, matter).transform =
            leaning;
    const Validation v = validate(scene);
    EXPECT_EQ(v.verdict, Verdict::agrees) << unexplained(v);
    expect_not_excused(scene, [](Scene& ours) { ours.materials[1].absorption = {0.4, 0.2, 0.15}; });
}

TEST_F(CoincidentFaces, TwoGlassesFaceToFace) {
    Scene scene = stage();
    const std::uint32_t leaning = add_leaning(scene);
    add_object(scene, Box{{-0.9, -0.8, -0.5}, {0, 0.5, 0.5}}, add_material(scene, clear(1.5)))
        .transform = leaning;
    add_object(scene, Box{{0, -0.8, -0.5}, {0.9, 0.5, 0.5}}, add_material(scene, clear(1.3)))
        .transform = leaning;
    add_table(scene, leaning);
    expect_coincident(scene);
}

TEST_F(CoincidentFaces, AnOpaqueFaceInFrontOfAnother) {
    for (int order = 0; order < 3; ++order) {
        SCOPED_TRACE(order);
        Scene scene = stage();
        const std::uint32_t leaning = add_leaning(scene);
        Material red;
        red.color = {0.9, 0.1, 0.1};
        const std::uint32_t paint = add_material(scene, red);
        add_table(scene, leaning);
        add_object(scene, Box{{-0.8, -1.5, -0.5}, {0.6, -1, 0.8}}, paint).transform = leaning;
        add_object(scene, Triangle{{Vec3d(0.9, -1, 0), Vec3d(1.8, -1, 0.5), Vec3d(0.8, -1, 1)}},
                   paint)
            .transform = leaning;
        std::rotate(scene.objects.begin(), scene.objects.begin() + order, scene.objects.end());
        expect_coincident(scene);
    }
}

TEST_F(CoincidentFaces, AGlassRodInTheHoleThatItFills) {
    Scene scene = stage();
    const std::uint32_t leaning = add_leaning(scene);
    Material red;
    red.color = {0.9, 0.1, 0.1};
    const std::uint32_t paint = add_material(scene, red);
    add_composite(scene, Composite::Kind::subtract, Box{{-0.9, -0.7, -0.9}, {0.9, 0, 0.9}},
                  Cylinder{{0, -0.7, 0}, {0, 0, 0}, 0.6}, paint, leaning);
    add_object(scene, Cylinder{{0, -0.6, 0}, {0, 0.3, 0}, 0.6}, add_material(scene, clear(1.5)))
        .transform = leaning;
    add_table(scene, leaning);
    expect_coincident(scene);
    // Air between the glass and the wall.
    expect_not_excused(
        scene, [](Scene& ours) { std::get<Cylinder>(ours.objects[1].shape).radius -= 1e-3; });
}

/// A body whose top lies in the top of a body around it.
Scene inlaid(const Material& outer, const Material& inner, bool inner_first) {
    Scene scene = stage();
    const std::uint32_t leaning = add_leaning(scene);
    Object& around = add_object(scene, Box{{-1, -0.9, -1}, {1, -0.4, 1}});
    around.transform = leaning;
    around.material = add_material(scene, outer);
    add_object(scene, Box{{-0.5, -0.7, -0.5}, {0.5, -0.4, 0.5}}, add_material(scene, inner))
        .transform = leaning;
    if (inner_first) std::swap(scene.objects[0], scene.objects[1]);
    return scene;
}

TEST_F(CoincidentFaces, AnOpaqueBlockInlaidInGlass) {
    Material red;
    red.color = {0.9, 0.1, 0.1};
    for (const bool first : {false, true}) {
        SCOPED_TRACE(first);
        expect_coincident(inlaid(clear(1.5), red, first));
    }
}

TEST_F(CoincidentFaces, ASheetUnderGlassAndASheetOfGlassOnABlock) {
    Material red;
    red.color = {0.9, 0.1, 0.1};
    for (const bool clear_body : {false, true}) {
        SCOPED_TRACE(clear_body);
        Scene scene = stage();
        const std::uint32_t leaning = add_leaning(scene);
        const double y = clear_body ? -0.9 : -0.4;
        const std::array<Vec3d, 3> corners{Vec3d(-1.5, y, -1), Vec3d(1.5, y, -0.8),
                                           Vec3d(0, y, 1.4)};
        add_object(scene, Box{{-0.6, -0.9, -0.6}, {0.6, -0.4, 0.6}},
                   add_material(scene, clear_body ? clear(1.5) : red))
            .transform = leaning;
        add_object(scene, Triangle{corners}, add_material(scene, clear_body ? red : clear(1, 0.5)))
            .transform = leaning;
        expect_coincident(scene);
    }
}

}  // namespace
}  // namespace lancer::judge
