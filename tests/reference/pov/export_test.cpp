#include "reference/pov/export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/io/png_file.h"
#include "tests/reference/pov/pair_scenes.h"
#include "tests/reference/pov/scene_kit.h"

namespace lancer::reference {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr ExportView view{0, 160, 120};

/// In the scene's own lengths, which are easier to read.
std::string text_of(const Scene& scene) {
    return export_pov(scene, view, {.keep_lengths = true}).text;
}

/// From the first line that holds `first` to the end of its block.
std::string block(const std::string& text, const std::string& first) {
    const std::size_t at = text.find(first);
    if (at == std::string::npos) return "";
    const std::size_t start = text.rfind('\n', at) + 1;
    const std::string indent = text.substr(start, text.find_first_not_of(' ', start) - start);
    const std::size_t end = text.find("\n" + indent + "}", at);
    return text.substr(start, end + indent.size() + 2 - start);
}

TEST(Export, WritesASmallSceneAsAPersonWould) {
    Scene scene = empty_scene();
    scene.cameras[0].position = {0, 0, 5};
    scene.cameras[0].projection = PerspectiveProjection{60};
    scene.cameras[0].name = "front";
    scene.settings.max_depth = 4;
    Material red;
    red.color = {0.9, 0.2, 0.1};
    add_object(scene, Sphere{{0, 1, 0}, 0.5}, add_material(scene, red)).name = 0;
    scene.names = {"ball"};
    scene.material_names = {"", "red"};
    EXPECT_EQ(text_of(scene),
              R"(// scene: written by Lancer for POV-Ray 3.7
// povray +Iscene.pov +W160 +H120 +FN16 File_Gamma=1.0 -D -A   (16 bit, linear light)
// Lengths are those of the scene.
#version 3.7;
global_settings {
    assumed_gamma 1.0
    max_trace_level 4
    adc_bailout 0
    ambient_light rgb 1
}
background { rgb <0.1, 0.15, 0.2> }
camera {  // front
    perspective  // vertical angle 60
    location <0, 0, 5>
    direction <0, 0, -1>
    right <1.5396007178390019, 0, 0>
    up <0, 1.1547005383792515, 0>
}
light_source {
    <4, 6, 5>, rgb 0.7
}

#declare T1_red = texture {
    pigment { rgb <0.9, 0.2, 0.1> }
    finish {
        ambient 0.1 diffuse 0.6 brilliance 1 emission rgb 0
        phong 0 phong_size 40 specular 0 roughness 0.05 metallic 0
        reflection 0
    }
}

// "ball"
sphere { <0, 1, 0>, 0.5
    texture { T1_red }
}
)");
}

TEST(Export, KeepsEveryDigitAndNoMore) {
    Scene scene = empty_scene();
    add_object(scene, Sphere{{0.1, 1.0 / 3, 1e-7}, 0.30000000000000004});
    EXPECT_THAT(text_of(scene),
                HasSubstr("sphere { <0.1, 0.3333333333333333, 1e-07>, 0.30000000000000004"));
}

TEST(Export, RescalesDecimalNumbersIntoDecimalNumbers) {
    Scene scene = empty_scene();
    scene.cameras[0].position = {0, 0, 0.007};
    scene.lights[0].kind = PointLight{{0.0012, 0, 0}, Fade{0.003, 2}};
    Material glass;
    glass.transmission = 1;
    glass.ior = 1.5;
    glass.absorption = {50, 100, 0};
    add_object(scene, Sphere{{0.0003, 0, 0}, 0.001}, add_material(scene, glass));
    const ExportResult result = export_pov(scene, view);
    EXPECT_EQ(result.factor, 1e5);
    EXPECT_THAT(result.text, HasSubstr("Lengths are those of the scene times 100000"));
    EXPECT_THAT(result.text, HasSubstr("location <0, 0, 700>"));
    EXPECT_THAT(result.text, HasSubstr("<120, 0, 0>, rgb 0.7\n    fade_distance 300 fade_power 2"));
    EXPECT_THAT(result.text, HasSubstr("sphere { <30, 0, 0>, 100\n"));
    EXPECT_THAT(result.text, HasSubstr("fade_distance 1000 fade_color rgb <0.5, 0, 1>"));
}

TEST(Export, ChoosesAScaleThatSuitsMostOfTheScene) {
    const auto factor = [](std::initializer_list<double> radii, bool keep) {
        Scene scene = empty_scene();
        for (const double r : radii) add_object(scene, Sphere{{0, 0, 0}, r});
        return export_pov(scene, view, {.keep_lengths = keep}).factor;
    };
    EXPECT_EQ(factor({1, 1, 1}, false), 100);
    EXPECT_EQ(factor({1, 1, 1}, true), 1);
    EXPECT_EQ(factor({1e-3, 1e-3, 1e-3}, true), 1e4) << "too small to be kept";
    EXPECT_EQ(factor({1, 1, 1e6}, false), 1) << "a planet under small things";
    EXPECT_EQ(factor({1, 1, 1e6}, true), 1);
    EXPECT_EQ(factor({1, 1, 300}, false), 10) << "neither too small nor too far";
    EXPECT_EQ(factor({1e30, 1e30, 1e30}, true), 1e-28);
    EXPECT_EQ(factor({}, false), 100) << "by the view";
}

TEST(Export, PutsTransformsBehindTheTextureSoThatTheyMoveIt) {
    Scene scene = empty_scene();
    Affine<double> map;
    map.rows = {Vec3d(1, 2, 3), Vec3d(4, 5, 6), Vec3d(7, 8, 10)};
    map.shift = {11, 12, 13};
    add_object(scene, Sphere{}).transform = add_transform(scene, map);
    EXPECT_EQ(block(text_of(scene), "sphere {"),
              "sphere { <0, 0, 0>, 1\n"
              "    texture { T0_plain }\n"
              "    matrix <1, 4, 7, 2, 5, 8, 3, 6, 10, 11, 12, 13>\n"
              "}");
}

TEST(Export, GivesClosedSolidsAnInteriorOfTheirOwnAndSheetsNoIndex) {
    Scene scene = empty_scene();
    Material glass;
    glass.transmission = 0.9;
    glass.ior = 1.5;
    const std::uint32_t material = add_material(scene, glass);
    add_object(scene, Cylinder{{0, 0, 0}, {0, 1, 0}, 1, true}, material);
    add_object(scene, Cylinder{{2, 0, 0}, {2, 1, 0}, 1, false}, material);
    const std::string text = text_of(scene);
    EXPECT_THAT(block(text, "cylinder { <0"), HasSubstr("interior { ior 1.5 }"));
    EXPECT_THAT(block(text, "cylinder { <2"), HasSubstr("open\n"));
    EXPECT_THAT(block(text, "cylinder { <2"), HasSubstr("interior { ior 1 }"));
}

TEST(Export, KeepsTheIndexOfAnOpaqueMirrorByFresnel) {
    Scene scene = empty_scene();
    Material lacquer;
    lacquer.reflection = {1, 1, 1};
    lacquer.fresnel = true;
    lacquer.ior = 1.4;
    add_object(scene, Triangle{{Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)}},
               add_material(scene, lacquer));
    EXPECT_THAT(text_of(scene), HasSubstr("interior { ior 1.4 }"));
    EXPECT_THAT(text_of(scene), HasSubstr("reflection { rgb 1 fresnel on } conserve_energy"));
}

TEST(Export, DeclaresWhatHoldsTheCameraFromLargeToSmall) {
    Scene scene = empty_scene();
    Material glass;
    glass.transmission = 1;
    const std::uint32_t material = add_material(scene, glass);
    const Vec3d eye = scene.cameras[0].position;
    add_object(scene, Sphere{eye, 1}, material);
    add_object(scene, Sphere{eye, 9});  // opaque: irrelevant for POV-Ray's list of interiors
    add_object(scene, Sphere{eye, 3}, material);
    add_object(scene, Sphere{{-50, 0, 0}, 4}, material);
    add_object(scene, Plane{{0, 1, 0}, 7}, material);
    const std::string text = text_of(scene);
    std::vector<std::size_t> at;
    for (const char* shape : {"plane {", "6>, 9", "6>, 3", "0>, 4", "6>, 1"})
        at.push_back(text.find(shape));
    EXPECT_TRUE(std::is_sorted(at.begin(), at.end())) << text;
}

TEST(Export, CastsNoShadowWhereNoneIsAskedFor) {
    Scene scene = empty_scene();
    add_object(scene, Sphere{});
    EXPECT_THAT(text_of(scene), Not(HasSubstr("no_shadow")));
    scene.objects[0].casts_shadow = false;
    EXPECT_THAT(text_of(scene), HasSubstr("no_shadow"));
    scene.objects[0].casts_shadow = true;
    scene.settings.shadows = false;
    EXPECT_THAT(text_of(scene), HasSubstr("no_shadow"));
}

TEST(Export, DeclaresAMeshOnceForAllWhoShowIt) {
    Scene scene = empty_scene();
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{0, 1, 2}};
    scene.meshes.push_back(std::make_shared<Mesh>(mesh));
    for (double x : {0.0, 1.0, 2.0}) {
        Affine<double> map;
        map.shift = {x, 0, 0};
        add_object(scene, MeshRef{0, false}).transform = add_transform(scene, map);
    }
    const std::string text = text_of(scene);
    EXPECT_EQ(text.find("mesh2"), text.rfind("mesh2"));
    EXPECT_THAT(text,
                HasSubstr("object { Mesh0\n    texture { T0_plain }\n    translate <2, 0, 0>"));
    EXPECT_THAT(text, Not(HasSubstr("normal_vectors")));
    EXPECT_THAT(text, Not(HasSubstr("inside_vector")));
}

TEST(Export, AMeshWithGapsHasAnInsideWhereItsAuthorSaysSo) {
    Material glass;
    glass.transmission = 1;
    glass.ior = 1.5;
    for (const Inside inside : {Inside::if_closed, Inside::never, Inside::always}) {
        Scene scene = empty_scene();
        Mesh mesh;
        mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh.faces = {{0, 1, 2}};
        scene.meshes.push_back(std::make_shared<Mesh>(mesh));
        add_object(scene, MeshRef{0, false, inside}, add_material(scene, glass));
        const bool body = inside == Inside::always;
        EXPECT_EQ(text_of(scene).find("inside_vector") != std::string::npos, body);
        EXPECT_EQ(text_of(scene).find("ior 1.5") != std::string::npos, body);
    }
}

TEST(Export, KeepsMeshesFarFromTheOriginPrecise) {
    Scene scene = empty_scene();
    Mesh mesh;
    for (const double x : {1000.123456789, 1001.0, 1000.5})
        mesh.vertices.push_back({x, x == 1000.5 ? 1.0 : 0.0, 0});
    mesh.faces = {{0, 1, 2}};
    scene.meshes.push_back(std::make_shared<Mesh>(mesh));
    add_object(scene, MeshRef{0, false});
    EXPECT_THAT(text_of(scene), HasSubstr("<0.123456789,0,0>"));
    EXPECT_THAT(text_of(scene), HasSubstr("translate <1000, 0, 0>"));
}

TEST(Export, WritesImagesSoThatPovRayDecodesThem) {
    const Scene scene = tex_planar_scene();
    const ExportResult result = export_pov(scene, view, {"tex"});
    ASSERT_EQ(result.assets.size(), 2u);
    EXPECT_TRUE(result.approximations.empty());
    EXPECT_THAT(result.text, HasSubstr("image_map { png \"tex-0.png\" gamma srgb map_type 0 }"));
    EXPECT_THAT(result.text,
                HasSubstr("png \"tex-1.png\" gamma 1.0 map_type 0 interpolate 2 once"));
    for (std::uint32_t i = 0; i < 2; ++i) {
        const Image back = io::decode_png(result.assets[i].bytes, "", io::ColorSpace::automatic);
        const Image& image = *scene.images[i].pixels;
        ASSERT_EQ(back.data.size(), image.data.size());
        for (std::size_t k = 0; k < image.data.size(); ++k)
            EXPECT_NEAR(back.data[k], image.data[k], 1e-12);
    }
}

TEST(Export, SaysWhenAnImageIsRounded) {
    Scene scene = empty_scene();
    const std::uint32_t index = add_image(scene);
    Image image = *scene.images[index].pixels;
    image.data[4] = 0.1234567;
    scene.images[index].pixels = std::make_shared<Image>(image);
    add_object(scene, Sphere{}, add_texture(scene, {ImageTexture{index}, {}}));
    const ExportResult result = export_pov(scene, view);
    ASSERT_EQ(result.approximations.size(), 1u);
    EXPECT_THAT(result.approximations[0].explanation, HasSubstr("'made.png' rounded to 16 bits"));
}

/// The one refusal of a scene, with its place; the text must be empty.
Diagnostic refusal(const Scene& scene) {
    const ExportResult result = export_pov(scene, view);
    EXPECT_EQ(result.text, "");
    EXPECT_TRUE(result.assets.empty());
    EXPECT_EQ(result.refusals.size(), 1u);
    return result.refusals.empty() ? Diagnostic{} : result.refusals.front();
}

TEST(Export, RefusesWhatPovRayHasNoWordForAtItsPlace) {
    Scene scene = empty_scene();
    add_object(scene, Sphere{});
    Material frosted;
    frosted.phong_transmission = 0.5;
    add_object(scene, Box{}, add_material(scene, frosted));
    EXPECT_THAT(refusal(scene).message, HasSubstr("no highlights from light behind a surface"));
    EXPECT_EQ(refusal(scene).where, scene.objects[1].place);

    scene = empty_scene();
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
    mesh.faces = {{0, 1, 2}, {1, 2, 3}};
    mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
    mesh.uv_faces = {{0, 1, 2}, {none, none, none}};
    scene.meshes.push_back(std::make_shared<Mesh>(mesh));
    add_object(scene, MeshRef{0, false},
               add_texture(scene, {ImageTexture{add_image(scene), ImageTexture::Mapping::uv}, {}}));
    EXPECT_THAT(refusal(scene).message, HasSubstr("some faces of this mesh have no uvs"));

    scene = empty_scene();
    scene.prisms.push_back({{{0, 0}, {1, 0}, {0, 1}}, Spline::linear, 0, 1, true, {}});
    add_object(scene, PrismRef{0},
               add_texture(scene, {ImageTexture{add_image(scene), ImageTexture::Mapping::uv}, {}}));
    EXPECT_THAT(refusal(scene).message, HasSubstr("no uv mapping for prisms"));

    scene = empty_scene();
    add_object(scene, Box{{-1, -1, 0}, {1, 1, 0}},
               add_texture(scene, {ImageTexture{add_image(scene), ImageTexture::Mapping::uv}, {}}));
    EXPECT_THAT(refusal(scene).message, HasSubstr("sides of a flat box"));

    scene = empty_scene();
    Gradient gradient;
    for (int i = 0; i <= 256; ++i) gradient.stops.push_back({i / 256.0, {}});
    add_object(scene, Sphere{}, add_texture(scene, {gradient, {}}));
    EXPECT_THAT(refusal(scene).message, HasSubstr("at most 256 stops"));

    scene = empty_scene();
    Image image(1, 1);
    image.data = {0, 0, 1.5};
    scene.images.push_back({"bright.exr", false, std::make_shared<Image>(image)});
    add_object(scene, Sphere{}, add_texture(scene, {ImageTexture{0}, {}}));
    EXPECT_THAT(refusal(scene).message, HasSubstr("'bright.exr' contains values outside 0 to 1"));
}

TEST(Export, DeclaresAPatternAnewForEachSizeThatShowsIt) {
    Scene scene = empty_scene();
    const std::uint32_t tiled = add_texture(scene, {Checker{}, {}});
    Affine<double> hundredth;
    for (Vec3d& row : hundredth.rows) row *= 0.01;
    add_object(scene, Sphere{}, tiled);
    add_object(scene, Sphere{{0, 0, 0}, 100}, tiled).transform = add_transform(scene, hundredth);
    const std::string text = text_of(scene);
    EXPECT_THAT(text, HasSubstr("#declare T1_plain = texture {"));
    EXPECT_THAT(text, HasSubstr("#declare T1_plain_m2 = texture {"));
    EXPECT_EQ(text.find("texture { T1_plain }"), text.rfind("texture { T1_plain }"));
    EXPECT_THAT(text, HasSubstr("texture { T1_plain_m2 }"));
}

TEST(Export, LeavesOutTexturesThatAreSwitchedOff) {
    Scene scene = tex_planar_scene();
    scene.settings.textures = false;
    const ExportResult result = export_pov(scene, view);
    EXPECT_TRUE(result.assets.empty());
    EXPECT_THAT(result.text, Not(HasSubstr("image_map")));
}

/// A flat sheet of n x n x 2 triangles.
std::shared_ptr<const Mesh> sheet(std::uint32_t n) {
    const auto mesh = std::make_shared<Mesh>();
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) mesh->vertices.emplace_back(i, 0, j);
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i;
            mesh->faces.push_back({a, a + 1, a + n + 2});
            mesh->faces.push_back({a, a + n + 2, a + n + 1});
        }
    }
    return mesh;
}

TEST(ExportMeshes, AFineMeshIsWrittenInPiecesUnlessLightPassesIt) {
    const auto pieces = [](std::uint32_t n, double transmission, bool smooth) {
        Scene scene = empty_scene();
        scene.meshes.push_back(sheet(n));
        Material material;
        material.transmission = transmission;
        add_object(scene, MeshRef{0, smooth}, add_material(scene, material));
        const std::string text = export_pov(scene, {0, 64, 48}).text;
        std::size_t count = 0;
        for (std::size_t at = text.find("mesh2 {"); at != std::string::npos;
             at = text.find("mesh2 {", at + 1))
            ++count;
        // Every face is there once.
        std::size_t faces = 0;
        for (std::size_t at = text.find("face_indices { "); at != std::string::npos;
             at = text.find("face_indices { ", at + 1))
            faces += std::stoul(text.substr(at + 15));
        EXPECT_EQ(faces, 2u * n * n);
        EXPECT_EQ(text.find("normal_vectors") != std::string::npos, smooth);
        return count;
    };
    EXPECT_EQ(pieces(22, 0, true), 1u) << "968 faces";
    EXPECT_GT(pieces(23, 0, true), 4u) << "1,058";
    EXPECT_GT(pieces(23, 0, false), 4u);
    EXPECT_EQ(pieces(23, 0.5, true), 1u) << "pieces have no inside";
}

}  // namespace
}  // namespace lancer::reference
