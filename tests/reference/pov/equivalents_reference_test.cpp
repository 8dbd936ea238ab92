// Two ways to write one thing must give the same picture: constructions of the exporter compared
// with what POV-Ray does for another shape.
#include <utility>

#include "tests/reference/pov/povray_fixture.h"
#include "tests/reference/pov/scene_kit.h"

namespace lancer::reference {
namespace {

class Equivalents : public WithPovRay {
  protected:
    /// Equal to the last step away from edges of geometry; `edges` is the share of pixels that may
    /// differ.
    void expect_same(const Scene& a, const Scene& b, double edges = 0, double exposure = 1) const {
        const ExportView view{0, 64, 48};
        const Image one = rendered(a, view);
        Image other = rendered(b, view);
        for (double& value : other.data) value *= exposure;
        const Difference found = difference(one, other, 2.5 / 65535);
        EXPECT_LE(found.share_over, edges) << "largest " << found.largest;
        EXPECT_GT(difference(one, Image(64, 48), 0.05).share_over, 0.2) << "nothing to see";
    }
    static std::uint32_t mapped(Scene& scene, ImageTexture::Mapping mapping,
                                const Affine<double>& to_object = {}) {
        return add_texture(scene,
                           {ImageTexture{add_image(scene), mapping, ImageTexture::Filter::bilinear,
                                         ImageTexture::Wrap::repeat},
                            to_object});
    }
};

Affine<double> stretched() {
    return {{Vec3d(0.7, 0.2, 0), Vec3d(-0.1, 0.5, 0), Vec3d(0, 0, 1)}, Vec3d(0.15, 0.35, 0)};
}

Affine<double> turned() {
    const auto [s, c] = elementary::sine_cosine_of_degrees(35);
    const Affine<double> y{{Vec3d(c, 0, s), Vec3d(0, 1, 0), Vec3d(-s, 0, c)}, Vec3d(0.0)};
    const Affine<double> x{{Vec3d(1, 0, 0), Vec3d(0, c, -s), Vec3d(0, s, c)}, Vec3d(0.1, 0, 0)};
    return compose(x, y);
}

// The box's uv as shading.md has them, written out corner by corner.
TEST_F(Equivalents, ABoxMappedByUvIsAMeshWithTheseUvs) {
    const Vec3d low(-0.8, -0.5, -0.6), high(0.7, 0.9, 0.8);
    Mesh mesh;
    const auto face = [&](int axis, double side, const auto& uv_of) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const auto& [a, b] :
             {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
            Vec3d q(a, b, side);
            if (axis == 0) q = Vec3d(side, a, b);
            if (axis == 1) q = Vec3d(a, side, b);
            mesh.vertices.push_back(low + q * (high - low));
            mesh.uvs.push_back(uv_of(q));
        }
        mesh.faces.push_back({first, first + 1, first + 2});
        mesh.faces.push_back({first, first + 2, first + 3});
    };
    face(2, 1, [](Vec3d q) { return Vec2d(q.x, q.y); });
    face(2, 0, [](Vec3d q) { return Vec2d(1 - q.x, q.y); });
    face(0, 1, [](Vec3d q) { return Vec2d(1 - q.z, q.y); });
    face(0, 0, [](Vec3d q) { return Vec2d(q.z, q.y); });
    face(1, 1, [](Vec3d q) { return Vec2d(q.x, 1 - q.z); });
    face(1, 0, [](Vec3d q) { return Vec2d(q.x, q.z); });
    for (const Affine<double>& pattern : {Affine<double>{}, stretched()})
        for (const double about : {0.0, 1.0}) {
            Affine<double> turn = turned();
            if (about > 0)  // the other three faces
                for (Vec3d& row : turn.rows) row = -row;
            Scene box = empty_scene();
            add_object(box, Box{low, high}, mapped(box, ImageTexture::Mapping::uv, pattern))
                .transform = add_transform(box, turn);
            Scene other = empty_scene();
            other.meshes.push_back(std::make_shared<Mesh>(mesh));
            add_object(other, MeshRef{0, false}, mapped(other, ImageTexture::Mapping::uv, pattern))
                .transform = add_transform(other, turn);
            expect_same(box, other, 0.001);
        }
}

TEST_F(Equivalents, TheMantleOfConesMappedByUvIsALatheMappedByUv) {
    for (const Affine<double>& pattern : {Affine<double>{}, stretched()})
        for (const double top : {0.7, 0.2}) {
            Scene cone = empty_scene();
            add_object(cone, Cone{{0, -0.8, 0}, {0, 0.8, 0}, 0.7, top, false},
                       mapped(cone, ImageTexture::Mapping::uv, pattern))
                .transform = add_transform(cone, turned());
            Scene lathe = empty_scene();
            lathe.lathes.push_back({{{0.7, -0.8}, {top, 0.8}}, Spline::linear, {}});
            add_object(lathe, LatheRef{0}, mapped(lathe, ImageTexture::Mapping::uv, pattern))
                .transform = add_transform(lathe, turned());
            expect_same(cone, lathe, 0.002);
        }
}

TEST_F(Equivalents, TheCapsOfACylinderMappedByUvAreDiscsMappedPlanar) {
    // One cap towards the camera: x' is x, z' = x' × y' is -y for an axis along z.
    Scene cylinder = empty_scene();
    add_object(cylinder, Cylinder{{0, 0, -0.5}, {0, 0, 0}, 0.8, true},
               mapped(cylinder, ImageTexture::Mapping::uv));
    Scene disc = empty_scene();
    const Affine<double> cap{{Vec3d(1.6, 0, 0), Vec3d(0, -1.6, 0), Vec3d(0, 0, 1)},
                             Vec3d(-0.8, 0.8, 0)};
    add_object(disc, Cylinder{{0, 0, -0.5}, {0, 0, 0}, 0.8, true},
               mapped(disc, ImageTexture::Mapping::planar, cap));
    cylinder.cameras[0].position = disc.cameras[0].position = {0, 0, 6};
    expect_same(cylinder, disc);
}

TEST_F(Equivalents, ASphereMappedByUvIsOneMappedSpherically) {
    Scene uv = empty_scene();
    add_object(uv, Sphere{{0.2, 0.1, 0}, 1}, mapped(uv, ImageTexture::Mapping::uv)).transform =
        add_transform(uv, turned());
    Scene spherical = empty_scene();
    Affine<double> center;
    center.shift = {0.2, 0.1, 0};
    add_object(spherical, Sphere{{0.2, 0.1, 0}, 1},
               mapped(spherical, ImageTexture::Mapping::spherical, center))
        .transform = add_transform(spherical, turned());
    expect_same(uv, spherical, 0.001);
}

TEST_F(Equivalents, ABsplineNetIsTheBezierPatchesItConsistsOf) {
    Scene net = empty_scene();
    Patch spline;
    spline.basis = Patch::Basis::bspline;
    spline.rows = 4;
    spline.columns = 5;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 5; ++j) spline.control.push_back({-2.4 + 1.2 * j, -1.8 + 1.2 * i, 0});
    net.patches = {spline};
    add_object(net, PatchRef{0}, mapped(net, ImageTexture::Mapping::uv));
    // Evenly spaced control points give the plane itself, with parameters to scale.
    Scene rectangle = empty_scene();
    Mesh mesh;
    mesh.vertices = {{-1.2, -0.6, 0}, {1.2, -0.6, 0}, {1.2, 0.6, 0}, {-1.2, 0.6, 0}};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}};
    rectangle.meshes.push_back(std::make_shared<Mesh>(mesh));
    add_object(rectangle, MeshRef{0, false}, mapped(rectangle, ImageTexture::Mapping::uv));
    expect_same(net, rectangle);
}

TEST_F(Equivalents, SplinesOfEveryKindThroughTheSameCurveAreOnePicture) {
    // A straight B-spline and a straight Catmull-Rom profile are cylinders.
    for (const Spline spline : {Spline::bspline, Spline::catmull_rom, Spline::bezier}) {
        Scene lathe = empty_scene();
        std::vector<Vec2d> profile;
        if (spline == Spline::bezier)
            profile = {{0.8, -0.6}, {0.8, -0.2}, {0.8, 0.2}, {0.8, 0.6}};
        else
            profile = {{0.8, -1.8}, {0.8, -0.6}, {0.8, 0.6}, {0.8, 1.8}};
        lathe.lathes.push_back({profile, spline, {}});
        add_object(lathe, LatheRef{0}).transform = add_transform(lathe, turned());
        Scene cylinder = empty_scene();
        add_object(cylinder, Cylinder{{0, -0.6, 0}, {0, 0.6, 0}, 0.8, false}).transform =
            add_transform(cylinder, turned());
        expect_same(lathe, cylinder, 0.001);
    }
}

// POV-Ray's own Catmull-Rom lathe against the Bezier curve with the same ends and tangents.
TEST_F(Equivalents, ACatmullRomLatheIsTheBezierLatheWithItsTangents) {
    const std::vector<Vec2d> p{{0.3, -1.4}, {0.8, -0.9}, {0.4, -0.1},
                               {0.9, 0.5},  {0.5, 0.9},  {0.2, 1.6}};
    std::vector<Vec2d> bezier{p[1]};
    for (std::size_t i = 1; i + 2 < p.size(); ++i) {
        bezier.push_back(p[i] + (p[i + 1] - p[i - 1]) / 6.0);
        bezier.push_back(p[i + 1] - (p[i + 2] - p[i]) / 6.0);
        bezier.push_back(p[i + 1]);
    }
    Scene one = empty_scene();
    one.lathes.push_back({p, Spline::catmull_rom, {}});
    add_object(one, LatheRef{0}, mapped(one, ImageTexture::Mapping::uv)).transform =
        add_transform(one, turned());
    Scene other = empty_scene();
    other.lathes.push_back({bezier, Spline::bezier, {}});
    add_object(other, LatheRef{0}, mapped(other, ImageTexture::Mapping::uv)).transform =
        add_transform(other, turned());
    expect_same(one, other, 0.002);
}

// A closed curve makes the same prism wherever it begins. A B-spline whose control points form a
// regular polygon with many corners is nearly a circle: it is compared with that cylinder.
TEST_F(Equivalents, ABsplinePrismBeginsAnywhereAndIsNearlyACylinder) {
    constexpr int corners = 48;
    const auto prism_from = [](int first, Spline spline) {
        Scene scene = empty_scene();
        std::vector<Vec2d> outline;
        for (int i = 0; i < corners; ++i) {
            const auto [sine, cosine] =
                elementary::sine_cosine_of_degrees(360.0 * (i + first) / corners);
            outline.push_back(Vec2d(cosine, sine) * 0.8);
        }
        scene.prisms.push_back({outline, spline, -0.6, 0.6, true, {}});
        add_object(scene, PrismRef{0}).transform = add_transform(scene, turned());
        return scene;
    };
    for (const Spline spline : {Spline::bspline, Spline::catmull_rom}) {
        const Scene prism = prism_from(0, spline);
        expect_same(prism, prism_from(7, spline), 0.002);
        // On the curve: a B-spline's points lie (2 + cos(turn)) / 3 of the way out.
        const double turn = tau / corners;
        const double radius =
            0.8 * (spline == Spline::bspline ? (2 + elementary::cos(turn)) / 3 : 1);
        Scene cylinder = empty_scene();
        add_object(cylinder, Cylinder{{0, -0.6, 0}, {0, 0.6, 0}, radius, true}).transform =
            add_transform(cylinder, turned());
        const ExportView view{0, 64, 48};
        const Difference found = difference(rendered(prism, view), rendered(cylinder, view), 1e-3);
        EXPECT_LE(found.share_over, 0.003);
    }
}

// A gradient's negative coordinates: POV-Ray's own rule is off by 1e-5 of a period per period.
TEST_F(Equivalents, AGradientIsTheSameOnBothSidesOfZero) {
    Gradient gradient;
    gradient.axis = {1, 0, 0};
    gradient.stops = {{0, {1, 0, 0}}, {0.7, {0, 1, 0.5}}, {1, {0.2, 0, 1}}};
    Affine<double> there;
    there.shift = {-7, 0, 0};
    Scene negative = empty_scene();
    add_object(negative, Sphere{{0, 0, 0}, 1}, add_texture(negative, {gradient, {}}));
    Scene moved = empty_scene();
    add_object(moved, Sphere{{0, 0, 0}, 1}, add_texture(moved, {gradient, there}));
    expect_same(negative, moved, 0.001);
}

// The same scene 10,000 times larger or smaller, in world space and under transforms, gives the
// same export within POV-Ray's range.
TEST_F(Equivalents, AScaledSceneIsTheSamePicture) {
    const auto scene_at = [](double k, bool by_transform) {
        Scene scene = empty_scene();
        Camera& camera = scene.cameras[0];
        camera.position = camera.position * k;
        scene.lights[0].kind = PointLight{Vec3d(4, 6, 5) * k, Fade{8 * k, 2}};
        scene.lights[0].color = {1.5, 1.5, 1.5};
        Material glass;
        glass.diffuse = 0.1;
        glass.transmission = 0.9;
        glass.ior = 1.3;
        glass.absorption = Color(0.5, 0.2, 0) / k;
        const std::uint32_t material = add_material(scene, glass);
        const double own = by_transform ? 1 : k;
        Affine<double> larger;
        for (Vec3d& row : larger.rows) row = row * (by_transform ? k : 1);
        const std::uint32_t transform = add_transform(scene, larger);
        Affine<double> pattern;
        for (Vec3d& row : pattern.rows) row = row * (own * 0.4);
        const std::uint32_t tiles =
            add_texture(scene, {Checker{{1, 1, 1}, {0.2, 0.3, 0.4}}, pattern});
        add_object(scene, Sphere{{0, 0, 0}, 0.9 * own}, material).transform = transform;
        add_object(scene, Box{Vec3d(-1.5, -1.3, -1.5) * own, Vec3d(1.5, -1.03, 1.5) * own}, tiles)
            .transform = transform;
        return scene;
    };
    for (const double k : {1e4, 1e-4, 1e-9, 1e12})
        for (const bool by_transform : {false, true}) {
            SCOPED_TRACE(testing::Message() << k << (by_transform ? " by transform" : ""));
            expect_same(scene_at(k, by_transform), scene_at(1, false), 0.002);
        }
}

TEST_F(Equivalents, ExposureMultipliesThePicture) {
    Scene scene = empty_scene();
    Material glowing;
    glowing.emission = {0.2, 0.1, 0};
    add_object(scene, Sphere{}, add_material(scene, glowing));
    const ExportView view{0, 64, 48};
    const ExportResult darker = export_pov(scene, view, {"scene", 0.5});
    const Image half = rendered(darker, view);
    Image whole = rendered(scene, view);
    for (double& value : whole.data) value *= 0.5;
    EXPECT_LE(difference(half, whole, 0).largest, 1.0 / 65535);
}

// Points a pixel apart are the picture's own pixels.
TEST_F(Equivalents, ACloseUpIsAPartOfThePicture) {
    Scene scene = empty_scene();
    Material matt;
    matt.diffuse = 0.9;
    add_object(scene, Sphere{{0.2, 0.1, 0}, 1.3}, add_material(scene, matt));
    const ExportView view{0, 64, 48};
    for (const bool orthographic : {false, true}) {
        SCOPED_TRACE(orthographic ? "orthographic" : "perspective");
        if (orthographic) scene.cameras[0].projection = OrthographicProjection{3};
        const Image whole = rendered(scene, view);
        constexpr int x = 25;
        constexpr int y = 27;
        ExportOptions options;
        options.close_up = CloseUp{x + 0.5, y + 0.5, 1};
        const Image close = rendered(export_pov(scene, view, options), {0, 3, 3});
        Image part(3, 3);
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i)
                std::copy_n(whole.pixel(x - 1 + i, y - 1 + j), 3, part.pixel(i, j));
        EXPECT_LE(difference(close, part, 0).largest, 1.0 / 65535);
        EXPECT_GT(std::abs(part.pixel(0, 2)[0] - part.pixel(2, 0)[0]), 0.01) << "nothing to see";
    }
}

}  // namespace
}  // namespace lancer::reference
