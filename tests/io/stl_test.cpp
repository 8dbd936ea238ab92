#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <map>
#include <random>

#include "model/io/mesh_file.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

LoadedMesh stl(const std::string& bytes) {
    return read_mesh(bytes, "t.stl");
}

std::string stl_error(const std::string& bytes) {
    return file_error([&] { stl(bytes); });
}

using Triangle = std::array<std::array<float, 3>, 3>;

/// A closed tetrahedron with one corner at -0, as cutting tools write it.
const std::vector<Triangle> stl_tetrahedron{
    {{{0, 0, 0}, {0, 1, 0}, {0.1f, 0, 0}}},
    {{{-0.0f, 0, 0}, {0.1f, 0, 0}, {0, 0, 1}}},
    {{{0.1f, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0, 1, 0}, {0, -0.0f, 0}, {0, 0, 1}}},
};

template <class Value>
std::string little_endian(Value value) {
    static_assert(sizeof(Value) <= 4);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(Value));
    std::string bytes;
    for (std::size_t i = 0; i < sizeof(Value); ++i) {
        bytes += static_cast<char>((bits >> (8 * i)) & 0xFF);
    }
    return bytes;
}

std::string binary(const std::vector<Triangle>& triangles, std::string header = "made by hand") {
    header.resize(80, ' ');
    std::string bytes = header + little_endian(static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& triangle : triangles) {
        for (int i = 0; i < 3; ++i) bytes += little_endian(std::numeric_limits<float>::quiet_NaN());
        for (const auto& corner : triangle) {
            for (const float x : corner) bytes += little_endian(x);
        }
        bytes += std::string(2, '\7');
    }
    return bytes;
}

std::string text(const std::vector<Triangle>& triangles, const char* line_end = "\n") {
    std::string bytes = std::string("solid made by hand") + line_end;
    for (const Triangle& triangle : triangles) {
        bytes += std::string("  facet normal 0 -nan 1e0") + line_end + "    outer loop" + line_end;
        for (const auto& corner : triangle) {
            bytes += "      vertex";
            for (const float x : corner)
                bytes += " " + std::string(x == 0.1f         ? "0.1"
                                           : x == 1          ? "1"
                                           : std::signbit(x) ? "-0.0"
                                                             : "0");
            bytes += line_end;
        }
        bytes += std::string("    endloop") + line_end + "  endfacet" + line_end;
    }
    return bytes + "endsolid made by hand" + line_end;
}

void expect_closed(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& face : mesh.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = face[i];
            const std::uint32_t b = face[(i + 1) % 3];
            edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
    for (const auto& [edge, balance] : edges) EXPECT_EQ(balance, 0);
}

TEST(Stl, MergesEqualCornersSoThatAClosedSurfaceIsClosed) {
    for (const std::string& bytes : {binary(stl_tetrahedron), text(stl_tetrahedron)}) {
        const LoadedMesh loaded = stl(bytes);
        EXPECT_EQ(loaded.mesh.vertices.size(), 4u);
        EXPECT_EQ(loaded.mesh.faces.size(), 4u);
        EXPECT_TRUE(loaded.mesh.normals.empty());
        expect_closed(loaded.mesh);
    }
}

TEST(Stl, KeepsThePrecisionOfTheFile) {
    EXPECT_EQ(stl(binary(stl_tetrahedron)).mesh.vertices[2].x, static_cast<double>(0.1f));
    EXPECT_EQ(stl(text(stl_tetrahedron)).mesh.vertices[2].x, 0.1);
}

TEST(Stl, ABinaryFileMayBeginWithSolid) {
    EXPECT_EQ(stl(binary(stl_tetrahedron, "solid by a careless program")).mesh.faces.size(), 4u);
}

TEST(Stl, MergesManyVertices) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < 3000; ++i) {
        const float x = static_cast<float>(i % 1000);
        triangles.push_back({{{x, 0, 0}, {x + 1, 0, 0}, {x, 1, static_cast<float>(i / 1000)}}});
    }
    const LoadedMesh loaded = stl(binary(triangles));
    EXPECT_EQ(loaded.mesh.vertices.size(), 1001u + 3000u);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& [x, y, z] = triangles[i][k];
            EXPECT_EQ(loaded.mesh.vertices[loaded.mesh.faces[i][k]], Vec3d(x, y, z));
        }
    }
}

TEST(Stl, ReadsTextInAnyCaseWithSeveralSolids) {
    EXPECT_EQ(stl(text(stl_tetrahedron, "\r\n")).mesh.faces.size(), 4u);
    EXPECT_EQ(stl(text(stl_tetrahedron) + text(stl_tetrahedron)).mesh.faces.size(), 8u);
    EXPECT_EQ(stl("SOLID\nFACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 VERTEX 0 1 0 "
                  "ENDLOOP ENDFACET\nENDSOLID")
                  .mesh.faces.size(),
              1u);
}

TEST(Stl, DropsAndCountsDegenerateTriangles) {
    std::vector<Triangle> triangles = stl_tetrahedron;
    triangles.push_back({{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}});
    triangles.push_back({{{0, 0, 0}, {1, 1, 1}, {0, 0, 0}}});
    EXPECT_EQ(stl(binary(triangles)).degenerate, 2u);
}

TEST(Stl, RefusesEveryTruncation) {
    for (const std::string& bytes : {binary(stl_tetrahedron), text(stl_tetrahedron)}) {
        const std::size_t last = bytes[0] == 's' ? bytes.find("endsolid") + 8 : bytes.size();
        for (std::size_t size = 0; size < last; ++size) {
            EXPECT_THROW(stl(bytes.substr(0, size)), FileError) << size;
        }
    }
}

TEST(Stl, NamesThePlaceOfAMistake) {
    std::vector<Triangle> triangles = stl_tetrahedron;
    triangles[1][2][0] = std::numeric_limits<float>::infinity();
    EXPECT_THAT(stl_error(binary(triangles)), StartsWith("t.stl: byte 182: a coordinate is not"));
    EXPECT_THAT(stl_error(binary({})), HasSubstr("no faces"));
    EXPECT_THAT(stl_error(""), HasSubstr("truncated"));
    EXPECT_THAT(stl_error("hello"), HasSubstr("truncated"));
    std::string wrong = text(stl_tetrahedron);
    wrong.replace(wrong.find("vertex"), 6, "vertix");
    EXPECT_THAT(stl_error(wrong), StartsWith("t.stl:4: 'vertex' expected, not 'vertix'"));
    EXPECT_THAT(stl_error("solid\nendsolid\n"), HasSubstr("no faces"));
    EXPECT_THAT(stl_error("solid\nfacet normal 0 0 0 outer loop vertex 1 nan 2"),
                StartsWith("t.stl:2: a coordinate is not finite"));
}

TEST(Stl, NeverCrashesOnDamage) {
    std::mt19937 random(4);
    for (const std::string& bytes : {binary(stl_tetrahedron), text(stl_tetrahedron)}) {
        for (int i = 0; i < 3000; ++i) {
            std::string damaged = bytes;
            for (int k = 0; k < 2; ++k) {
                damaged[random() % damaged.size()] = static_cast<char>(random());
            }
            try {
                stl(damaged);
            } catch (const FileError& error) {
                EXPECT_THAT(error.what(), StartsWith("t.stl:"));
            }
        }
    }
}

TEST(Stl, BytesBehindTheTrianglesAreAWarning) {
    for (const char* header : {"made by hand", "solid x"}) {
        std::string head = header;
        head.resize(80, '\0');
        const LoadedMesh loaded = stl(binary(stl_tetrahedron, head) + std::string("\0\1", 2));
        EXPECT_EQ(loaded.mesh.faces.size(), 4u);
        EXPECT_THAT(loaded.warnings,
                    testing::ElementsAre("t.stl: byte 80: the file has 286 bytes, but 4 triangles "
                                         "need 284: the rest is skipped"));
        EXPECT_TRUE(stl(binary(stl_tetrahedron, head)).warnings.empty());
        EXPECT_EQ(stl_error(binary(stl_tetrahedron, head).substr(0, 283)),
                  "t.stl: byte 80: the file has 283 bytes, but 4 triangles need 284");
    }
}

}  // namespace
}  // namespace lancer::io
