#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <random>

#include "model/io/mesh_file.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

LoadedMesh ply(const std::string& bytes) {
    return read_mesh(bytes, "t.ply");
}

std::string ply_error(const std::string& bytes) {
    return file_error([&] { ply(bytes); });
}

/// The bytes of a value in the order of a format.
template <class Value>
std::string packed(Value value, bool big_endian) {
    std::string bytes(sizeof(Value), 0);
    std::memcpy(bytes.data(), &value, sizeof(Value));
    if (big_endian != (std::endian::native == std::endian::big)) {
        std::reverse(bytes.begin(), bytes.end());
    }
    return bytes;
}

std::string packed_as(const std::string& type, double value, bool big_endian) {
    if (type == "char" || type == "int8")
        return packed(static_cast<std::int8_t>(value), big_endian);
    if (type == "uchar" || type == "uint8") {
        return packed(static_cast<std::uint8_t>(value), big_endian);
    }
    if (type == "short" || type == "int16") {
        return packed(static_cast<std::int16_t>(value), big_endian);
    }
    if (type == "ushort" || type == "uint16") {
        return packed(static_cast<std::uint16_t>(value), big_endian);
    }
    if (type == "int" || type == "int32") {
        return packed(static_cast<std::int32_t>(value), big_endian);
    }
    if (type == "uint" || type == "uint32") {
        return packed(static_cast<std::uint32_t>(value), big_endian);
    }
    if (type == "float" || type == "float32") return packed(static_cast<float>(value), big_endian);
    return packed(value, big_endian);
}

/// A tetrahedron with vertices of type `scalar`, and between their coordinates and beside the faces
/// much that a reader has to skip.
std::string tetrahedron(const std::string& format, const std::string& scalar,
                        const std::string& count_type, const std::string& index_type) {
    std::string bytes = "ply\nformat " + format + " 1.0\ncomment by hand\nobj_info x\n" +
                        "element material 1\nproperty list uchar " + scalar +
                        " weights\nproperty int id\n" + "element vertex 4\nproperty " + scalar +
                        " z\nproperty uchar red\nproperty " + scalar + " x\nproperty " + scalar +
                        " y\nelement face 4\nproperty uchar flag\nproperty list " + count_type +
                        " " + index_type + " vertex_indices\nproperty float quality\nend_header\n";
    const bool text = format == "ascii";
    const bool big = format == "binary_big_endian";
    const auto put = [&](const std::string& type, double value) {
        bytes += text ? std::to_string(static_cast<int>(value)) + " " : packed_as(type, value, big);
    };
    const auto end_line = [&] {
        if (text) bytes += "\n";
    };
    put("uchar", 2);
    put(scalar, 7);
    put(scalar, 9);
    put("int", -5);
    end_line();
    const int places[4][3] = {{0, 0, 0}, {3, 0, 0}, {0, 5, 0}, {0, 0, 100}};
    for (const auto& place : places) {
        put(scalar, place[2]);
        put("uchar", 200);
        put(scalar, place[0]);
        put(scalar, place[1]);
        end_line();
    }
    const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    for (const auto& face : faces) {
        put("uchar", 1);
        put(count_type, 3);
        for (const int corner : face) put(index_type, corner);
        put("float", 1);
        end_line();
    }
    return bytes;
}

constexpr const char* formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};

TEST(Ply, ReadsEveryFormatAndScalarType) {
    for (const char* format : formats) {
        for (const char* scalar :
             {"char", "int8", "uchar", "uint8", "short", "int16", "ushort", "uint16", "int",
              "int32", "uint", "uint32", "float", "float32", "double", "float64"}) {
            const LoadedMesh loaded = ply(tetrahedron(format, scalar, "uchar", "int"));
            EXPECT_THAT(loaded.mesh.vertices, ElementsAre(Vec3d(0, 0, 0), Vec3d(3, 0, 0),
                                                          Vec3d(0, 5, 0), Vec3d(0, 0, 100)))
                << format << scalar;
            EXPECT_THAT(loaded.mesh.faces,
                        ElementsAre(Mesh::Corners{0, 2, 1}, Mesh::Corners{0, 1, 3},
                                    Mesh::Corners{1, 2, 3}, Mesh::Corners{2, 0, 3}))
                << format << scalar;
        }
        for (const char* type : {"char", "uchar", "short", "ushort", "int", "uint"}) {
            EXPECT_EQ(ply(tetrahedron(format, "float", type, type)).mesh.faces.size(), 4u);
        }
    }
}

TEST(Ply, KeepsDoublesInFullPrecision) {
    std::string bytes =
        "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty double x\nproperty double "
        "y\nproperty double z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n";
    for (const double v : {0.1, 0.2, 0.3, 1e-300, 1e300, -0.7, 1.0, 2.0, 3.0}) {
        bytes += packed(v, true);
    }
    bytes += "\3" + packed(0, true) + packed(1, true) + packed(2, true);
    const LoadedMesh loaded = ply(bytes);
    EXPECT_EQ(loaded.mesh.vertices[0], Vec3d(0.1, 0.2, 0.3));
    EXPECT_EQ(loaded.mesh.vertices[1], Vec3d(1e-300, 1e300, -0.7));
}

std::string text_ply(const std::string& vertex_properties, const std::string& vertices,
                     const std::string& faces = "3 0 1 2\n", int face_count = 1) {
    return "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
           "property float z\r\n" +
           vertex_properties + "element face " + std::to_string(face_count) +
           "\r\nproperty list uchar int vertex_indices\r\nend_header\r\n" + vertices + faces;
}

const std::string plain = "0 0 0\n1 0 0\n0 1 0\n";

TEST(Ply, ReadsNormalsAndTextureCoordinates) {
    const LoadedMesh loaded = ply(text_ply(
        "property float s\nproperty float t\nproperty float nx\nproperty float ny\nproperty float "
        "nz\n",
        "0 0 0  0 0.5  0 0 1\n1 0 0  1 0.5  0 1 0\n0 1 0  0.25 1  1 0 0\n"));
    EXPECT_THAT(loaded.mesh.normals, ElementsAre(Vec3d(0, 0, 1), Vec3d(0, 1, 0), Vec3d(1, 0, 0)));
    EXPECT_TRUE(loaded.mesh.normal_faces.empty());
    EXPECT_THAT(loaded.mesh.uvs, ElementsAre(Vec2d(0, 0.5), Vec2d(1, 0.5), Vec2d(0.25, 1)));
    for (const char* names : {"u v", "texture_u texture_v", "texture_s texture_t"}) {
        const std::string pair = names;
        const std::size_t space = pair.find(' ');
        const std::string properties = "property float " + pair.substr(0, space) +
                                       "\nproperty float " + pair.substr(space + 1) + "\n";
        EXPECT_EQ(ply(text_ply(properties, "0 0 0 1 2\n1 0 0 3 4\n0 1 0 5 6\n")).mesh.uvs[1],
                  Vec2d(3, 4))
            << names;
    }
    EXPECT_TRUE(
        ply(text_ply("property float nx\n", "0 0 0 1\n1 0 0 1\n0 1 0 1\n")).mesh.normals.empty());
}

TEST(Ply, SplitsFacesOfMoreCorners) {
    const std::string bytes =
        "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement "
        "vertex 5\nproperty float x\nproperty float y\nproperty float z\nend_header\n5 0 1 2 3 4\n"
        "0 0 0 1 0 0 2 1 0 1 2 0 0 1 0\n";
    EXPECT_EQ(ply(bytes).mesh.faces.size(), 3u);
}

TEST(Ply, NamesThePlaceOfAMistake) {
    const auto vertices = [](const std::string& text) { return ply_error(text_ply("", text)); };
    EXPECT_THAT(vertices("0 0 0\n1 x 0\n0 1 0\n"), StartsWith("t.ply:11: a number expected"));
    EXPECT_THAT(vertices("0 0 0\n1 nan 0\n0 1 0\n"),
                StartsWith("t.ply:11: 'y' of vertex 1 is not"));
    EXPECT_THAT(vertices("0 0 0\n"), HasSubstr("truncated"));
    const auto faces = [](const std::string& text) { return ply_error(text_ply("", plain, text)); };
    EXPECT_EQ(faces("3 0 1 3\n"),
              "t.ply:13: the face names vertex 3, but there are 3, counted from 0");
    EXPECT_THAT(faces("3 0 1 -1\n"), StartsWith("t.ply:13: a vertex index of face 0"));
    EXPECT_THAT(faces("3 0 1 1.5\n"), StartsWith("t.ply:13: a whole number"));
    EXPECT_THAT(faces("2 0 1\n"), StartsWith("t.ply:13: face 0 has 2 corners"));
    EXPECT_THAT(faces("3 0 1\n"), HasSubstr("truncated"));
    EXPECT_THAT(faces(""), HasSubstr("truncated"));
    EXPECT_THAT(faces("-3 0 1 2\n"), HasSubstr("negative"));
    EXPECT_THAT(faces("4000000000 0 1 2\n"), HasSubstr("truncated"));
    EXPECT_THAT(ply_error(text_ply("", plain, "", 0)), HasSubstr("no faces"));

    const auto header = [](const std::string& text) { return ply_error("ply\n" + text); };
    EXPECT_THAT(ply_error("plyx\n"), StartsWith("t.ply:1: "));
    EXPECT_THAT(ply_error(""), StartsWith("t.ply:1: "));
    EXPECT_THAT(header(""), HasSubstr("truncated"));
    EXPECT_THAT(header("format text 1.0\n"), StartsWith("t.ply:2: unknown format 'text'"));
    EXPECT_THAT(header("format ascii 2.0\n"), StartsWith("t.ply:2: unknown version"));
    EXPECT_THAT(header("format ascii 1.0\nelement vertex -3\n"), StartsWith("t.ply:3: the number"));
    EXPECT_THAT(header("property float x\n"), StartsWith("t.ply:2: a property must belong"));
    EXPECT_THAT(header("element vertex 1\nproperty real x\n"), HasSubstr("unknown type 'real'"));
    EXPECT_THAT(header("element vertex 1\nproperty list float int x\n"), HasSubstr("whole number"));
    EXPECT_THAT(header("elements vertex 1\n"), HasSubstr("unknown statement 'elements'"));
    EXPECT_THAT(header("end_header\n"), HasSubstr("no format"));
    EXPECT_THAT(header("format ascii 1.0\nend_header\n"), HasSubstr("no vertices"));
    EXPECT_THAT(header("format ascii 1.0\nelement vertex 1\nproperty int x\nend_header\n1\n"),
                HasSubstr("lack x, y or z"));
}

TEST(Ply, TakesNoMemoryForAHugeClaim) {
    for (const char* format : formats) {
        const std::string bytes =
            std::string("ply\nformat ") + format +
            " 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float "
            "z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n1 2 3 4 5 6\n";
        EXPECT_THAT(ply_error(bytes), HasSubstr("cannot hold 4000000000"));
    }
}

TEST(Ply, RefusesEveryTruncationOfBinaryData) {
    for (const char* format : formats) {
        const std::string bytes = tetrahedron(format, "float", "uchar", "int");
        const std::size_t end = bytes.find_last_not_of(" \n") + 1;
        const std::size_t last = format == formats[0] ? end : bytes.size();
        for (std::size_t size = 0; size < last; ++size) {
            EXPECT_THROW(ply(bytes.substr(0, size)), FileError) << format << size;
        }
    }
}

TEST(Ply, RefusesNumbersThatAreNotFiniteInBinaryData) {
    std::string bytes = tetrahedron("binary_little_endian", "float", "uchar", "int");
    const std::size_t data = bytes.find("end_header\n") + 11;
    const std::size_t second_z = data + 13 + 13;
    bytes.replace(second_z, 4, packed(std::numeric_limits<float>::quiet_NaN(), false));
    EXPECT_THAT(ply_error(bytes), HasSubstr("'z' of vertex 1 is not finite"));
}

TEST(Ply, NumbersThatNobodyUsesNeedNotBeFinite) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
        "float z\nproperty float quality\nelement face 1\nproperty list uchar int "
        "vertex_indices\nend_header\n0 0 0 nan\n1 0 0 inf\n0 1 0 -nan\nnan 0 0 1\n3 0 1 2\n";
    EXPECT_EQ(ply(text).mesh.faces.size(), 1u);
    EXPECT_THAT(ply_error(text.substr(0, text.size() - 2) + "3\n"),
                StartsWith("t.ply:14: 'x' of vertex 3 is not finite"));
}

TEST(Ply, APartOfANormalIsNoneAndNeedsNotBeFinite) {
    const LoadedMesh loaded =
        ply("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nproperty float ny\nproperty float nz\nproperty float u\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0 nan 1 inf\n1 0 0 0 -nan 0\n0 1 0 0 0 inf\n3 0 1 2\n");
    EXPECT_EQ(loaded.mesh.faces.size(), 1U);
    EXPECT_TRUE(loaded.mesh.normals.empty());
    EXPECT_TRUE(loaded.mesh.uvs.empty());
}

TEST(Ply, ColorsOfEightBitsAreEncodedAndThoseOfFloatsAreLight) {
    const std::string begin =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\n";
    const std::string end = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const auto parts = [](const std::string& type) {
        return "property " + type + " red\nproperty " + type + " green\nproperty " + type +
               " blue\nproperty " + type + " alpha\n";
    };
    const LoadedMesh bytes = ply(begin + parts("uchar") + end +
                                 "0 0 0 255 0 0 9\n1 0 0 188 188 188 9\n0 1 0 0 0 1 9\n3 0 1 2\n");
    ASSERT_EQ(bytes.mesh.colors.size(), 3u);
    EXPECT_EQ(bytes.mesh.colors[0], Vec3d(1, 0, 0));
    EXPECT_NEAR(bytes.mesh.colors[1].x, 0.5029, 1e-4);
    EXPECT_NEAR(bytes.mesh.colors[2].z, 1 / 255.0 / 12.92, 1e-12);
    const LoadedMesh light = ply(begin + parts("float") + end +
                                 "0 0 0 2 0.5 0 9\n1 0 0 0 0 0 9\n0 1 0 0 0 1 9\n3 0 1 2\n");
    EXPECT_EQ(light.mesh.colors[0], Vec3d(2, 0.5, 0));
    const LoadedMesh wrong = ply(begin + parts("float") + end +
                                 "0 0 0 2 -0.5 0 9\n1 0 0 0 0 0 9\n0 1 0 0 0 1 9\n3 0 1 2\n");
    EXPECT_TRUE(wrong.mesh.colors.empty());
    EXPECT_THAT(wrong.warnings, ElementsAre(HasSubstr("'green' of vertex 0 is negative or not")));
    EXPECT_TRUE(ply(begin + "property uchar red\n" + end + "0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n")
                    .mesh.colors.empty())
        << "a part of a colour is none";
}

TEST(Ply, ReadsStripsOfTriangles) {
    const auto strips = [](const std::string& lists) {
        return "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float "
               "y\nproperty float z\nelement tristrips " +
               std::to_string(std::count(lists.begin(), lists.end(), '\n')) +
               "\nproperty list int int vertex_indices\nend_header\n0 0 0\n0 1 0\n1 0 0\n1 1 "
               "0\n2 0 0\n" +
               lists;
    };
    using Faces = std::vector<Mesh::Corners>;
    EXPECT_EQ(ply(strips("5 0 1 2 3 4\n")).mesh.faces, (Faces{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
    EXPECT_EQ(ply(strips("8 0 1 2 -1 1 2 3 4\n")).mesh.faces,
              (Faces{{0, 1, 2}, {1, 2, 3}, {3, 2, 4}}));
    // A corner written twice joins two strips, and turns no triangle.
    EXPECT_EQ(ply(strips("6 0 1 2 2 3 4\n")).mesh.faces, (Faces{{0, 1, 2}, {3, 2, 4}}));
    EXPECT_EQ(ply(strips("3 0 1 2\n3 2 1 3\n")).mesh.faces.size(), 2u);
    EXPECT_EQ(ply(strips("3 0 1 2\n")).degenerate, 0u);
    EXPECT_THAT(ply_error(strips("3 0 1 5\n")), HasSubstr("vertex 5, but there are 5"));
    EXPECT_THAT(ply_error(strips("3 0 1 -2\n")), HasSubstr("a strip is out of range: -2"));
    EXPECT_THAT(ply_error(strips("3 0 1.5 2\n")), HasSubstr("whole number"));
    EXPECT_THAT(ply_error(strips("2 0 1\n")), HasSubstr("no faces"));
}

TEST(Ply, NeverCrashesOnDamage) {
    std::mt19937 random(2);
    for (const char* format : formats) {
        const std::string bytes = tetrahedron(format, "double", "uchar", "uint");
        int refused = 0;
        for (int i = 0; i < 3000; ++i) {
            std::string damaged = bytes;
            for (int k = 0; k < 2; ++k) {
                damaged[random() % damaged.size()] = static_cast<char>(random());
            }
            try {
                ply(damaged);
            } catch (const FileError& error) {
                EXPECT_THAT(error.what(), StartsWith("t.ply:"));
                ++refused;
            }
        }
        EXPECT_GT(refused, 1000);
    }
}

}  // namespace
}  // namespace lancer::io
