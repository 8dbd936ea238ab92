// What a mesh block makes of the materials of an OBJ file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/io/mtl_reader.h"
#include "parser/blocks/file_materials.h"
#include "tests/parser/script.h"

namespace lancer {
namespace {

using testing::HasSubstr;

/// A cube without texture coordinates; `roof` has two of its sides.
const std::string cube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "mtllib cube.mtl\nusemtl wall\nf 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nusemtl roof\n"
    "f 8 7 3 4\nf 1 2 6 5\n";
const std::string two_colors = "newmtl wall\nKd 0.5 0.4 0.3\nnewmtl roof\nKd 0.7 0.1 0.1\n";

/// Runs a script that finds these texts and meshes, and pictures of any name without "missing".
test::Result run_with_files(const std::string& script,
                            const std::map<std::string, std::string>& files,
                            const Limits& limits = {}) {
    test::Result result;
    SourceMap sources;
    Loader loader = test::memory_loader(files);
    loader.mesh = [&](const std::string& path) { return io::read_mesh(files.at(path), path); };
    const Script parsed = parse_script("main.lancer", script, {}, sources, result.found);
    Evaluation evaluation = evaluate(parsed, {}, limits, sources, result.found, loader);
    for (const Diagnostic& d : result.found) result.messages += format(d, sources);
    result.scene = std::move(evaluation.scene);
    return result;
}

const Material& material(const test::Result& result, std::size_t object) {
    return result.scene.materials.at(result.scene.objects.at(object).material);
}
const Mesh& mesh_of(const test::Result& result, std::size_t object) {
    return *result.scene.meshes.at(std::get<MeshRef>(result.scene.objects.at(object).shape).mesh);
}

TEST(MeshMaterials, EachIsAnObjectOfItsOwnWithTheShapesAttributes) {
    const auto result = run_with_files(
        "mesh { file \"a.obj\" name \"house\" shadow false translate [1, 0, 0] smooth false } "
        "sphere { radius 1 }",
        {{"a.obj", cube}, {"cube.mtl", two_colors}});
    EXPECT_EQ(result.messages, "");
    ASSERT_EQ(result.scene.objects.size(), 3u);
    EXPECT_EQ(material(result, 0).color, Color(0.5, 0.4, 0.3));
    EXPECT_EQ(material(result, 1).color, Color(0.7, 0.1, 0.1));
    for (const std::size_t object : {0u, 1u}) {
        const Object& o = result.scene.objects[object];
        EXPECT_FALSE(o.casts_shadow);
        EXPECT_EQ(result.scene.names.at(o.name), "house");
        EXPECT_EQ(result.scene.transforms.at(o.transform).shift, Vec3d(1, 0, 0));
        EXPECT_TRUE(mesh_of(result, object).normals.empty()) << "flat";
    }
    EXPECT_EQ(mesh_of(result, 0).faces.size(), 8u);
    EXPECT_EQ(mesh_of(result, 1).faces.size(), 4u);
    EXPECT_EQ(result.scene.meshes.size(), 2u) << "without the whole, which nobody shows";
}

TEST(MeshMaterials, AnothersMaterialWins) {
    const std::map<std::string, std::string> files{{"a.obj", cube}, {"cube.mtl", two_colors}};
    const auto result = run_with_files(
        "sphere { radius 1 } group { mesh { file \"a.obj\" } sphere { radius 2 } "
        "mesh { file \"a.obj\" translate [1, 0, 0] } translate [0, 1, 0] }"
        "mesh { file \"a.obj\" material { color [0, 1, 0] } }"
        "group { group { mesh { file \"a.obj\" } } material { color [0, 0, 1] } }",
        files);
    EXPECT_EQ(result.messages, "");
    ASSERT_EQ(result.scene.objects.size(), 8u);
    for (const std::size_t wall : {1u, 4u}) {
        EXPECT_EQ(material(result, wall).color, Color(0.5, 0.4, 0.3));
        EXPECT_EQ(material(result, wall + 1).color, Color(0.7, 0.1, 0.1));
        EXPECT_EQ(result.scene.transforms.at(result.scene.objects[wall + 1].transform).shift,
                  Vec3d(wall == 4 ? 1 : 0, 1, 0));
    }
    EXPECT_EQ(std::get<Sphere>(result.scene.objects[3].shape).radius, 2) << "in their places";
    EXPECT_EQ(result.scene.objects[3].material, 0u);
    EXPECT_EQ(material(result, 6).color, Color(0, 1, 0));
    EXPECT_EQ(material(result, 7).color, Color(0, 0, 1));
    EXPECT_EQ(mesh_of(result, 6).faces.size(), 12u);
    EXPECT_EQ(result.scene.meshes.size(), 3u) << "made once";
    EXPECT_EQ(result.scene.materials.size(), 5u);
}

TEST(MeshMaterials, NothingIsReadThatDoesNotCount) {
    const std::map<std::string, std::string> without{{"a.obj", cube}};
    EXPECT_EQ(run_with_files("mesh { file \"a.obj\" material { } }", without).messages, "");
    EXPECT_EQ(run_with_files("group { mesh { file \"a.obj\" } material { } }", without).messages,
              "");
}

TEST(MeshMaterials, AMissingLibraryIsAWarningAndTheMeshStaysWhole) {
    const auto result = run_with_files("mesh { file \"a.obj\" }", {{"a.obj", cube}});
    ASSERT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_EQ(result.found[0].severity, Severity::warning);
    EXPECT_THAT(result.messages,
                HasSubstr("a.obj:9: the materials cannot be read: cannot read 'cube.mtl'"));
    ASSERT_EQ(result.scene.objects.size(), 1u);
    EXPECT_EQ(result.scene.objects[0].material, 0u);
    EXPECT_EQ(mesh_of(result, 0).vertices.size(), 8u);
}

TEST(MeshMaterials, WarningsInAGroupNameTheCallsThatLedToTheMesh) {
    const auto result = run_with_files(
        "def house() { mesh { file \"a.obj\" } }\ngroup {\n house()\n }", {{"a.obj", cube}});
    EXPECT_THAT(result.messages, HasSubstr("main.lancer:3:2: note: "));
}

TEST(MeshMaterials, PiecesHaveTheNormalsOfTheWhole) {
    const auto result =
        run_with_files("mesh { file \"a.obj\" }", {{"a.obj", cube}, {"cube.mtl", two_colors}});
    const auto whole =
        run_with_files("mesh { file \"a.obj\" smooth 180 material { } }", {{"a.obj", cube}});
    const Mesh& all = mesh_of(whole, 0);
    std::size_t compared = 0;
    for (const std::size_t object : {0u, 1u}) {
        const Mesh& piece = mesh_of(result, object);
        ASSERT_EQ(piece.normals.size(), piece.vertices.size());
        for (std::size_t i = 0; i < piece.vertices.size(); ++i) {
            for (std::size_t face = 0; face < all.faces.size(); ++face) {
                for (std::size_t k = 0; k < 3; ++k) {
                    if (all.vertices[all.faces[face][k]] != piece.vertices[i]) continue;
                    const Vec3d& normal = all.normals[all.normal_faces[face][k]];
                    EXPECT_LT(length(normal - piece.normals[i]), 1e-15);
                    ++compared;
                }
            }
        }
    }
    EXPECT_GE(compared, 36u);
    const auto sharp = run_with_files("mesh { file \"a.obj\" smooth 40 }",
                                      {{"a.obj", cube}, {"cube.mtl", two_colors}});
    EXPECT_EQ(mesh_of(sharp, 0).normals.size(), 16u);
}

TEST(MeshMaterials, GlassThatIsOnlyAPieceIsAWarning) {
    const auto glass = [](const std::string& obj) {
        return run_with_files(
            "mesh { file \"a.obj\" }",
            {{"a.obj", obj}, {"cube.mtl", "newmtl wall\nKd 1 1 1\nnewmtl roof\nNi 1.5\nd 0.1\n"}});
    };
    const auto result = glass(cube);
    ASSERT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_THAT(
        result.messages,
        HasSubstr("light passes through the faces of this mesh that are 'roof', but this "
                  "surface is not closed: 8 of its edges do not belong to exactly two faces"));
    EXPECT_THAT(result.messages,
                HasSubstr("hint: a mesh with several materials becomes one object for "
                          "each of them: put the glass into a file of its own"));
    std::string all_glass = cube;
    all_glass.replace(all_glass.find("wall"), 4, "roof");
    EXPECT_EQ(glass(all_glass).messages, "");
}

TEST(MeshMaterials, CountAsObjects) {
    Limits limits;
    limits.objects = 3;
    const std::map<std::string, std::string> files{{"a.obj", cube}, {"cube.mtl", two_colors}};
    const std::string house = "mesh { file \"a.obj\" } ";
    EXPECT_EQ(run_with_files(house, files, limits).messages, "");
    EXPECT_THAT(run_with_files(house + house, files, limits).messages, HasSubstr("3 objects"));
    EXPECT_THAT(run_with_files("group { " + house + house + "}", files, limits).messages,
                HasSubstr("3 objects"));
}

io::MtlMaterial mtl(const std::string& text) {
    return io::read_mtl("newmtl a\n" + text, "t.mtl").materials.at(0);
}

TEST(MeshMaterials, EachStatementOfMtlHasItsTerm) {
    const Material m = material_of(mtl("Ka 0.2 0.2 0.2\nKd 0.8 0.4 0.2\nKs 0.3 0.5 0.4\nKe 0.4 0 "
                                       "0.2\nNs 60\nNi 1.5\nd 0.75\n"),
                                   false);
    EXPECT_EQ(m.color, Color(0.8, 0.4, 0.2));
    EXPECT_EQ(m.diffuse, 1);
    EXPECT_EQ(m.color * m.emission, Color(0.4, 0, 0.2));
    EXPECT_DOUBLE_EQ(m.ambient, 0.1 * 0.2 / 0.8);
    EXPECT_EQ(m.phong, 0.5);
    EXPECT_EQ(m.shininess, 60);
    EXPECT_EQ(m.reflection, Color(0, 0, 0));
    EXPECT_EQ(m.transmission, 0.25);
    EXPECT_EQ(m.ior, 1.5);
    EXPECT_FALSE(m.fresnel);
    EXPECT_EQ(material_of(mtl("Ni 1.5\n"), false).ior, 1) << "nothing passes that could bend";
}

TEST(MeshMaterials, TheIlluminationModelSwitchesTerms) {
    const auto with = [](int model) {
        return material_of(
            mtl("Kd 0.5 0.5 0.5\nKs 0.3 0.3 0.3\nNi 1.5\nillum " + std::to_string(model) + "\n"),
            false);
    };
    EXPECT_EQ(with(0).color * with(0).emission, Color(0.5, 0.5, 0.5));
    EXPECT_EQ(with(0).diffuse, 0);
    EXPECT_EQ(with(1).phong, 0);
    EXPECT_EQ(with(2).phong, 0.3);
    EXPECT_EQ(with(2).reflection, Color(0, 0, 0));
    for (const int model : {3, 4, 5, 6, 7, 8, 9}) {
        EXPECT_EQ(with(model).reflection, Color(0.3, 0.3, 0.3)) << model;
        EXPECT_EQ(with(model).fresnel, model == 5 || model == 7) << model;
    }
    EXPECT_EQ(with(10).reflection, Color(0, 0, 0));
}

TEST(MeshMaterials, ALampMayBeBlack) {
    const Material lamp = material_of(mtl("Kd 0 0 0\nKe 5 4 3\n"), false);
    const Color light = lamp.color * lamp.emission;
    EXPECT_EQ(light, Color(5, 4, 3));
    EXPECT_LT(max_component(lamp.color), 1e-9);
}

TEST(MeshMaterials, AnImageNeedsTextureCoordinates) {
    const std::string picture = "newmtl wall\nKd 0.5 0.5 0.5\nmap_Kd wood.png\nnewmtl roof\n";
    std::string with_uvs = "vt 0 0\nvt 1 0\nvt 0 1\n" + cube;
    with_uvs.replace(with_uvs.find("f 5 6 7 8"), 9, "f 5/1 6/2 7/3 8/3");
    const std::string script = "mesh { file \"a.obj\" }";
    const auto result = run_with_files(script, {{"a.obj", with_uvs}, {"cube.mtl", picture}});
    EXPECT_EQ(result.messages, "");
    ASSERT_EQ(result.scene.textures.size(), 1u);
    const auto& image = std::get<ImageTexture>(result.scene.textures[0].pattern);
    EXPECT_EQ(image.mapping, ImageTexture::Mapping::uv);
    EXPECT_EQ(result.scene.images.at(image.image).path, "wood.png");
    EXPECT_EQ(material(result, 0).texture, 0u);
    EXPECT_EQ(material(result, 0).diffuse, 0.5);
    EXPECT_EQ(material(result, 1).texture, none);
    const auto plain = run_with_files(script, {{"a.obj", cube}, {"cube.mtl", picture}});
    EXPECT_EQ(material(plain, 0).texture, none);
    EXPECT_EQ(material(plain, 0).color, Color(0.5, 0.5, 0.5));
    const auto missing = run_with_files(
        script,
        {{"a.obj", with_uvs}, {"cube.mtl", "newmtl wall\nmap_Kd missing.png\nnewmtl roof\n"}});
    ASSERT_EQ(missing.found.size(), 1u);
    EXPECT_EQ(missing.found[0].severity, Severity::warning);
    EXPECT_EQ(material(missing, 0).texture, none);
}

}  // namespace
}  // namespace lancer
