#include "model/io/mtl_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "model/diagnostic.h"
#include "model/io/obj_materials.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

MtlFile mtl(const std::string& text) {
    return read_mtl(text, "t.mtl");
}
MtlMaterial only(const std::string& statements) {
    const MtlFile file = mtl("newmtl a\n" + statements);
    EXPECT_EQ(file.materials.size(), 1u);
    EXPECT_TRUE(file.skipped.empty());
    return file.materials.at(0);
}

TEST(Mtl, ReadsEveryStatementThatBecomesAMaterial) {
    const MtlMaterial m = only(
        "Ka 0.1 0.2 0.3 # a comment\n\tKd .5 .6 .7\r\nKs 1\nKe 0 2 0\nNs 96.5\nNi 1.45\nd 0.25\n"
        "illum 7\nmap_Kd textures\\my wood.png  \n");
    EXPECT_EQ(m.ambient, Color(0.1, 0.2, 0.3));
    EXPECT_EQ(m.diffuse, Color(0.5, 0.6, 0.7));
    EXPECT_EQ(m.specular, Color(1, 1, 1));
    EXPECT_EQ(m.emission, Color(0, 2, 0));
    EXPECT_EQ(m.shininess, 96.5);
    EXPECT_EQ(m.ior, 1.45);
    EXPECT_EQ(m.opacity, 0.25);
    EXPECT_EQ(m.illumination, 7);
    EXPECT_EQ(m.image, "textures/my wood.png");
}

TEST(Mtl, TransparencyIsOneLessOpacity) {
    EXPECT_EQ(only("Tr 0.25\n").opacity, 0.75);
    EXPECT_EQ(only("Tr 1.5\n").opacity, 0.0);
    EXPECT_EQ(only("d 2\n").opacity, 1.0);
    EXPECT_EQ(only("").opacity, std::nullopt);
}

TEST(Mtl, NamesWhatItSkipsOnce) {
    const MtlFile file =
        mtl("newmtl a b\nmap_Bump b.png\nTf 1 1 1\nKd spectral x.rfl\nd -halo 0.5\nillum 12\n"
            "map_Kd -s 2 2 2 -clamp on -mm 0 1 wood.png\nnewmtl c\nTf 1 1 1\nNi 0\n");
    EXPECT_THAT(file.skipped,
                ElementsAre("map_Bump (line 2)", "Tf (line 3)", "Kd spectral (line 4)",
                            "d -halo (line 5)", "illum (line 6)", "map_Kd -s (line 7)",
                            "map_Kd -clamp (line 7)", "map_Kd -mm (line 7)"));
    EXPECT_EQ(file.materials.at(0).name, "a b");
    EXPECT_EQ(file.materials.at(0).image, "wood.png");
    EXPECT_EQ(file.materials.at(0).opacity, 0.5);
    EXPECT_EQ(file.materials.at(0).diffuse, std::nullopt);
    EXPECT_EQ(file.materials.at(1).ior, std::nullopt);
}

TEST(Mtl, NamesTheLineOfAMistake) {
    const auto error = [](const std::string& text) { return file_error([&] { mtl(text); }); };
    EXPECT_EQ(error("Kd 1 1 1\n"), "t.mtl:1: 'newmtl' expected, not 'Kd'");
    EXPECT_EQ(error("newmtl a\nKd 1 one 1\n"), "t.mtl:2: a part of a colour expected, not 'one'");
    EXPECT_EQ(error("newmtl a\nKd 1 1\n"),
              "t.mtl:2: a part of a colour expected, but the line ends");
    EXPECT_EQ(error("newmtl a\n\nNs nan\n"), "t.mtl:3: an exponent is not finite: 'nan'");
    EXPECT_THAT(error("<html>"), HasSubstr("t.mtl:1: "));
    EXPECT_TRUE(mtl("").materials.empty());
}

const std::string lone_square =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nmtllib a.mtl\nf 1 2 3 4\nusemtl red\nf 1 2 3 4\nusemtl "
    "blue\nf 1 2 3\nusemtl red\nf 1 3 4\nf 1 1 2\n";

/// The materials of an OBJ file with this text; only these other files exist.
ObjMaterials found(const std::string& obj, const std::map<std::string, std::string>& all,
                   const std::string& path = "t.obj") {
    return find_materials(read_mesh(obj, path), path, [&](const std::string& library) {
        const auto at = all.find(library);
        if (at == all.end()) throw FileError("cannot read '" + library + "'");
        return at->second;
    });
}

TEST(ObjMaterials, FacesKnowTheirMaterials) {
    const LoadedMesh loaded = read_mesh(lone_square, "t.obj");
    EXPECT_THAT(loaded.face_materials, ElementsAre(0, 0, 1, 1, 2, 1));
    EXPECT_THAT(loaded.materials, ElementsAre("", "red", "blue"));
    EXPECT_TRUE(loaded.warnings.empty());
    const ObjMaterials all = found(
        lone_square, {{"dir/a.mtl", "newmtl blue\nKd 0 0 1\nmap_Kd x.png\nnewmtl red\nKd 1 0 0\n"}},
        "dir/t.obj");
    ASSERT_EQ(all.materials.size(), 3u);
    EXPECT_FALSE(all.materials[0]);
    EXPECT_EQ(all.materials[1].value().diffuse, Color(1, 0, 0));
    EXPECT_EQ(all.materials[2].value().diffuse, Color(0, 0, 1));
    EXPECT_EQ(all.materials[2].value().image, "dir/x.png");
    EXPECT_TRUE(all.warnings.empty());
}

TEST(ObjMaterials, OneForAllFacesIsTheMeshs) {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
    const LoadedMesh loaded = read_mesh("usemtl red\n" + corners + "f 1 2 3\n", "t.obj");
    EXPECT_TRUE(loaded.face_materials.empty());
    EXPECT_THAT(loaded.materials, ElementsAre("red"));
    EXPECT_TRUE(read_mesh(corners + "f 1 2 3\n", "t.obj").materials.empty());
    EXPECT_TRUE(read_mesh(corners + "f 1 2 3\nusemtl red\n", "t.obj").materials.empty());
    EXPECT_THAT(
        read_mesh(corners + "usemtl lost\nf 1 1 2\nusemtl red\nf 1 2 3\n", "t.obj").materials,
        ElementsAre("red"))
        << "no triangle is left of the other";
}

TEST(ObjMaterials, WhatIsMissingIsAWarning) {
    EXPECT_THAT(found(lone_square, {}).warnings,
                ElementsAre("t.obj:5: the materials cannot be read: cannot read 'a.mtl'"));
    EXPECT_THAT(found(lone_square, {{"a.mtl", "newmtl red\nKd red\n"}}).warnings,
                ElementsAre("t.obj:5: the materials cannot be read: a.mtl:2: a part of a colour "
                            "expected, not 'red'"));
    EXPECT_THAT(found(lone_square, {{"a.mtl", "newmtl red\nTf 1\n"}}).warnings,
                ElementsAre("a.mtl: skipped, because Lancer does not support it: Tf (line 2)",
                            "t.obj: no library contains these materials: 'blue'"));
    EXPECT_THAT(found("mtllib\n" + lone_square, {{"a.mtl", "newmtl red\nnewmtl blue\n"}}).warnings,
                ElementsAre("t.obj:1: the materials cannot be read: no file is named"));
}

TEST(ObjMaterials, ALineNamesOneLibraryWithBlanksOrSeveral) {
    const std::string obj = "mtllib my colours.mtl\nmtllib a.mtl\n" + lone_square;
    const ObjMaterials one = found(obj, {{"my colours.mtl", "newmtl red\nKd 1 0 0\n"},
                                         {"a.mtl", "newmtl red\nnewmtl blue\nKd 0 0 1\n"}});
    EXPECT_TRUE(one.warnings.empty());
    EXPECT_EQ(one.materials.at(1).value().diffuse, Color(1, 0, 0)) << "the first that has it";
    EXPECT_EQ(one.materials.at(2).value().diffuse, Color(0, 0, 1));
    const ObjMaterials two = found(obj, {{"my", "newmtl red\nKd 1 0 0\n"},
                                         {"colours.mtl", "newmtl blue\nKd 0 0 1\n"},
                                         {"a.mtl", ""}});
    EXPECT_TRUE(two.warnings.empty());
    EXPECT_TRUE(two.materials.at(1) && two.materials.at(2));
}

TEST(ObjMaterials, NoNameIsStandardInput) {
    const ObjMaterials read =
        found("mtllib -\n" + lone_square, {{"./-", "newmtl red\n"}, {"a.mtl", ""}});
    EXPECT_TRUE(read.materials.at(1));
}

}  // namespace
}  // namespace lancer::io
