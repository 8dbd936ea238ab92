#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "model/io/mesh_file.h"
#include "tests/io/read_in_chunks.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// Every test reads its files by chunks, too.
LoadedMesh obj(const std::string& text) {
    for (const int threads : {1, 2, 3, 8})
        EXPECT_EQ(told(text, {.threads = threads, .chunk_bytes = 5}), told(text, {})) << text;
    return read_mesh(text, "t.obj");
}

std::string obj_error(const std::string& text) {
    return file_error([&] { obj(text); });
}

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, ReadsVerticesInFullPrecision) {
    const LoadedMesh loaded =
        obj("v 0.1 -0.30000000000000004 1e-300\nv +1.5 5e-324 1e308\n v\t1 2 3 \r\nf 1 2 3");
    EXPECT_EQ(loaded.mesh.vertices[0], Vec3d(0.1, -0.30000000000000004, 1e-300));
    EXPECT_EQ(loaded.mesh.vertices[1], Vec3d(1.5, 5e-324, 1e308));
    EXPECT_EQ(loaded.mesh.vertices[2], Vec3d(1, 2, 3));
    EXPECT_EQ(loaded.mesh.faces, (std::vector<Mesh::Corners>{{0, 1, 2}}));
}

TEST(Obj, ReadsEveryFormOfCorner) {
    const std::string all = triangle + "vt 0 0\nvt 1 0\nvt 0.5 1\nvn 0 0 1\nvn 0 1 0\n";
    LoadedMesh loaded = obj(all + "f 3 2 1\n");
    EXPECT_EQ(loaded.mesh.faces[0], (Mesh::Corners{2, 1, 0}));
    EXPECT_TRUE(loaded.mesh.normals.empty());
    EXPECT_TRUE(loaded.mesh.uvs.empty());

    loaded = obj(all + "f 1/3 2/2 3/1\n");
    EXPECT_THAT(loaded.mesh.uv_faces, ElementsAre(Mesh::Corners{2, 1, 0}));
    EXPECT_EQ(loaded.mesh.uvs[2], Vec2d(0.5, 1));

    loaded = obj(all + "f 1//2 2//1 3//2\n");
    EXPECT_THAT(loaded.mesh.normal_faces, ElementsAre(Mesh::Corners{1, 0, 1}));
    EXPECT_EQ(loaded.mesh.normals[1], Vec3d(0, 1, 0));

    loaded = obj(all + "f 1 2 3\nf 1/1/1 2/2/1 3/3/2\n");
    EXPECT_THAT(loaded.mesh.normal_faces,
                ElementsAre(Mesh::Corners{none, none, none}, Mesh::Corners{0, 0, 1}));
    EXPECT_THAT(loaded.mesh.uv_faces,
                ElementsAre(Mesh::Corners{none, none, none}, Mesh::Corners{0, 1, 2}));

    loaded = obj(all + "f 1/1/1 2/2/1 3/3/2\nf 1 2 3\n");
    EXPECT_THAT(loaded.mesh.normal_faces,
                ElementsAre(Mesh::Corners{0, 0, 1}, Mesh::Corners{none, none, none}));
}

TEST(Obj, LeavesOutIndicesThatEqualThoseOfTheVertices) {
    const LoadedMesh loaded = obj(triangle + "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1//1 2//2 3//3\n");
    EXPECT_TRUE(loaded.mesh.normal_faces.empty());
    EXPECT_EQ(loaded.mesh.normals.size(), 3u);
}

TEST(Obj, CountsNegativeIndicesFromTheLastVertexSoFar) {
    const LoadedMesh loaded = obj(triangle + "f -3 -2 -1\nv 5 5 5\nf -4 -3 -1\n");
    EXPECT_THAT(loaded.mesh.faces, ElementsAre(Mesh::Corners{0, 1, 2}, Mesh::Corners{0, 1, 3}));
}

TEST(Obj, AFaceMayComeBeforeItsVertices) {
    EXPECT_THAT(obj("f 1 2 3\n" + triangle).mesh.faces, ElementsAre(Mesh::Corners{0, 1, 2}));
}

TEST(Obj, SkipsWhatIsNoTriangle) {
    const LoadedMesh loaded = obj(
        "\xEF\xBB\xBF# a comment\n\nmtllib a b.mtl\no thing\ng part one\nusemtl red\ns off\n" +
        triangle + "v 1 1 1 0.5\nv 0 0 1 0.1 0.2 0.3 # colour\nl 1 2\np 1\nf 1 2 \\\n  3 # end\n");
    EXPECT_EQ(loaded.mesh.vertices.size(), 5u);
    EXPECT_EQ(loaded.mesh.faces.size(), 1u);
}

TEST(Obj, TakesLinesThatEndInCrOrCrLf) {
    EXPECT_EQ(obj("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n").mesh.faces.size(), 1u);
    EXPECT_EQ(obj("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3").mesh.faces.size(), 1u);
}

TEST(Obj, CarriesNormalsAndUvsAlongWhenItSplitsAFace) {
    const LoadedMesh loaded = obj(square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/4 2/3 3/2 4/1\n");
    EXPECT_THAT(loaded.mesh.faces, ElementsAre(Mesh::Corners{0, 1, 2}, Mesh::Corners{0, 2, 3}));
    EXPECT_THAT(loaded.mesh.uv_faces, ElementsAre(Mesh::Corners{3, 2, 1}, Mesh::Corners{3, 1, 0}));
}

TEST(Obj, DropsAndCountsDegenerateFaces) {
    const LoadedMesh loaded = obj(triangle + "v 2 0 0\nf 1 2 3\nf 1 1 3\nf 1 2 4\nf 4 2 3\n");
    EXPECT_EQ(loaded.degenerate, 2u);
    EXPECT_EQ(loaded.mesh.faces.size(), 2u);
}

TEST(Obj, WhatStandsBehindASlashMayBeLeftOut) {
    LoadedMesh loaded = obj(triangle + "f 1// 2// 3//\nf 1/ 2/ 3/ # end\n");
    EXPECT_THAT(loaded.mesh.faces, ElementsAre(Mesh::Corners{0, 1, 2}, Mesh::Corners{0, 1, 2}));
    EXPECT_TRUE(loaded.mesh.normals.empty());
    EXPECT_TRUE(loaded.warnings.empty());
    loaded = obj(triangle + "vt 0 0\nvt 1 0\nf 1/2/ 2/1/ 3/1/\n");
    EXPECT_THAT(loaded.mesh.uv_faces, ElementsAre(Mesh::Corners{1, 0, 0}));
    EXPECT_TRUE(loaded.mesh.normal_faces.empty());
}

TEST(Obj, IndicesOfAnAbsentListSayNothingButAWarning) {
    LoadedMesh loaded = obj(triangle + "f 1 2 3\nf 1//1 2//2 3//3\nf 1//-1 2//-1 3//-1\n");
    EXPECT_EQ(loaded.mesh.faces.size(), 3u);
    EXPECT_TRUE(loaded.mesh.normals.empty());
    EXPECT_TRUE(loaded.mesh.normal_faces.empty());
    EXPECT_THAT(loaded.warnings,
                ElementsAre("t.obj:5: the face names normals, but the file has none: they are "
                            "averages of the faces"));
    loaded = obj(triangle + "f 1/1 2/2 3/3\n");
    EXPECT_TRUE(loaded.mesh.uvs.empty());
    EXPECT_EQ(loaded.warnings.size(), 1u);
}

TEST(Obj, NumbersThatNobodyUsesNeedNotBeFinite) {
    const LoadedMesh loaded = obj("v 9 nan inf\nv 0 0 0 nan nan nan\nv 1 0 0 1 1 1\nv 0 1 0\n" +
                                  std::string("vt nan 0\nvn 0 -nan 0\nvn 0 0 1\n"
                                              "f 2//2 3//2 4//2\n"));
    EXPECT_THAT(loaded.mesh.faces, ElementsAre(Mesh::Corners{1, 2, 3}));
    // A vertex outside the mesh must not count in its size.
    EXPECT_EQ(loaded.mesh.vertices[0], Vec3d(0, 0, 0));
    EXPECT_TRUE(is_finite(loaded.mesh.normals[0]));
    EXPECT_THAT(obj_error(triangle + "vn 0 nan 0\nf 1//1 2//1 3//1\n"),
                "t.obj:4: a component of the normal is not finite");
    EXPECT_THAT(obj_error(triangle + "vt 0 inf\nf 1/1 2/1 3/1\n"),
                "t.obj:4: a texture coordinate is not finite");
}

TEST(Obj, SixNumbersAreAPlaceAndItsColor) {
    const LoadedMesh all = obj("v 0 0 0 1 0.5 0\nv 1 0 0 0 0 2\nv 0 1 0 0 0 0\nf 1 2 3\n");
    EXPECT_THAT(all.mesh.colors, ElementsAre(Vec3d(1, 0.5, 0), Vec3d(0, 0, 2), Vec3d(0, 0, 0)));
    const LoadedMesh some = obj("v 0 0 0\nv 1 0 0 0 0 2\nv 0 1 0 7\nf 1 2 3\n");
    EXPECT_THAT(some.mesh.colors, ElementsAre(Vec3d(1.0), Vec3d(0, 0, 2), Vec3d(1.0)))
        << "white beside colours; one number more is a weight";
    EXPECT_THAT(
        some.warnings,
        ElementsAre("t.obj:1: this vertex has no colour, but others have one: it becomes white"));
    EXPECT_TRUE(all.warnings.empty());
    EXPECT_TRUE(obj(triangle + "f 1 2 3\n").mesh.colors.empty());
    const LoadedMesh wrong = obj("v 0 0 0\nv 1 0 0 0 0 -2\nv 0 1 0\nf 1 2 3\n");
    EXPECT_TRUE(wrong.mesh.colors.empty());
    EXPECT_THAT(
        wrong.warnings,
        ElementsAre("t.obj:2: the colour of this vertex is negative or not finite: the mesh "
                    "is read without colours"));
    EXPECT_EQ(obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 9 0 0 -2\nf 1 2 3\n").mesh.colors.size(), 4u)
        << "a colour that nobody uses";
}

TEST(Obj, NamesTheLineOfAMistake) {
    EXPECT_THAT(obj_error("v 0 0 0\nv 1 abc 2\n"), StartsWith("t.obj:2: a coordinate expected"));
    EXPECT_THAT(obj_error("v 0 0\n"), StartsWith("t.obj:1: a coordinate expected, but the line"));
    const std::string used = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(obj_error("\nv 0 nan 0\n" + used), "t.obj:2: a coordinate is not finite");
    EXPECT_THAT(obj_error("v 0 inf 0\n" + used), HasSubstr("not finite"));
    EXPECT_THAT(obj_error("v 0 1e999 0\n" + used), HasSubstr("not finite"));
    EXPECT_THAT(obj_error("v 0 0x10 0\n"), HasSubstr("expected, not '0x10'"));
    EXPECT_THAT(obj_error("v 0 1,5 0\n"), HasSubstr("expected, not '1,5'"));
    EXPECT_THAT(obj_error("vn 0 0 zero\n"), StartsWith("t.obj:1: a component of the normal"));
    EXPECT_THAT(obj_error("vt\n"), StartsWith("t.obj:1: a texture coordinate"));
    EXPECT_THAT(obj_error(triangle + "f 1 2\n"),
                StartsWith("t.obj:4: a face needs at least three"));
    EXPECT_THAT(obj_error(triangle + "f 1 2 0\n"), StartsWith("t.obj:4: a vertex index is out"));
    EXPECT_THAT(obj_error(triangle + "f 1 2 -4\n"), StartsWith("t.obj:4: a vertex index is out"));
    EXPECT_EQ(obj_error(triangle + "\nf 1 2 4\n"),
              "t.obj:5: the face names vertex 4, but there are 3");
    EXPECT_EQ(obj_error(triangle + "vt 0 0\nf 1/1 2/2 3/1\n"),
              "t.obj:5: the face names texture vertex 2, but there are 1");
    EXPECT_EQ(obj_error("f -1 -2 -3\n" + triangle),
              "t.obj:1: a vertex index is out of range: -1 (there are 0 so far)");
    EXPECT_EQ(obj_error(triangle + "f 1//-1 2//-1 3//-1\nvn 0 0 1\n"),
              "t.obj:4: the face names normal before the first, but there are 1");
    EXPECT_THAT(obj_error(triangle + "f 1 2 99999999999\n"), HasSubstr("out of range"));
    EXPECT_THAT(obj_error(triangle + "f 1 2 99999999999999999999\n"), HasSubstr("expected"));
    EXPECT_THAT(obj_error(triangle + "f 1/x 2 3\n"), HasSubstr("texture vertex index expected"));
    EXPECT_THAT(obj_error(triangle + "f 1.5 2 3\n"), HasSubstr("vertex index expected"));
    EXPECT_THAT(obj_error("<html>\n"), StartsWith("t.obj:1: this is not a statement"));
    EXPECT_THAT(obj_error("\x7f"
                          "ELF\1\2\3"),
                StartsWith("t.obj:1: "));
    EXPECT_THAT(obj_error(""), HasSubstr("no faces"));
    EXPECT_THAT(obj_error(triangle), HasSubstr("no faces"));
}

TEST(Obj, ATinyNumberIsZeroWhateverItLooksLike) {
    const std::string zeros(400, '0');
    const LoadedMesh loaded = obj("v 1e-999 -1e-400 0." + zeros + "1\nv 1 0 0\nv 0 1 0" + zeros +
                                  "." + zeros + "e-400\nf 1 2 3\n");
    EXPECT_EQ(loaded.mesh.vertices[0], Vec3d(0, 0, 0));
    const std::string used = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_THAT(obj_error("v 1" + zeros + " 0 0\n" + used), HasSubstr("not finite"));
    EXPECT_THAT(obj_error("v 1e99999999999999999999 0 0\n" + used), HasSubstr("not finite"));
}

TEST(Obj, NeverCrashesOnDamage) {
    const std::string text = square + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3//1 4\nf -1 -2 -3\n";
    std::mt19937 random(1);
    int refused = 0;
    for (int i = 0; i < 5000; ++i) {
        std::string damaged = text;
        for (int k = 0; k < 3; ++k) {
            damaged[random() % damaged.size()] = "0123456789 \n/-.vfne\\#\0\xFF"[random() % 23];
        }
        damaged.resize(random() % damaged.size() + 1);
        if (i % 10 == 0) {
            ASSERT_EQ(told(damaged, {}), told(damaged, {.threads = 1, .chunk_bytes = 5}));
        }
        try {
            read_mesh(damaged, "t.obj");
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(), StartsWith("t.obj:"));
            ++refused;
        }
    }
    EXPECT_GT(refused, 1000);
}

TEST(Mesh, NamesAFileItCannotRead) {
    const ScratchFolder folder;
    EXPECT_THAT(file_error([&] { read_mesh(folder / "no.obj"); }), HasSubstr("no.obj"));
    put(folder / "a.fbx", "");
    EXPECT_THAT(file_error([&] { read_mesh(folder / "a.fbx"); }), HasSubstr(".obj, .ply or .stl"));
}

}  // namespace
}  // namespace lancer::io
