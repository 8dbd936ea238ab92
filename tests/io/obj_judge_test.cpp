// Our OBJ reader compared with tinyobjloader, which shares no code with it, on files that both
// accept.
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

#include <random>
#include <sstream>

#include "model/io/obj_materials.h"
#include "model/io/obj_reader.h"

namespace lancer::io {
namespace {

/// A random file: vertices with numbers in many notations, faces of three to six corners in one of
/// the four forms, with indices counted from the front or from the back.
std::string random_obj(std::mt19937& random) {
    std::string text = "# random\n";
    const auto number = [&] {
        const int digits = static_cast<int>(random() % 17);
        const double value = std::ldexp(static_cast<double>(random()), -32) * 20 - 10;
        return random() % 4 == 0 ? fmt::format("{:.{}e}", value, digits)
                                 : fmt::format("{:.{}f}", value, digits);
    };
    const int count = 6 + static_cast<int>(random() % 20);
    for (int i = 0; i < count; ++i) {
        text += fmt::format("v {} {}  {}\n", number(), number(), number());
        text += fmt::format("vt {}\t{}\nvn {} {} {}\n", number(), number(), number(), number(),
                            number());
    }
    const auto index = [&] {
        const int i = 1 + static_cast<int>(random() % static_cast<unsigned>(count));
        return random() % 3 == 0 ? i - count - 1 : i;
    };
    for (int face = 0; face < 12; ++face) {
        text += "f";
        const auto corners = 3 + random() % 4;
        const auto form = random() % 4;
        for (unsigned i = 0; i < corners; ++i) {
            text += fmt::format(" {}", index());
            if (form == 1) text += fmt::format("/{}", index());
            if (form == 2) text += fmt::format("//{}", index());
            if (form == 3) text += fmt::format("/{}/{}", index(), index());
        }
        text += random() % 2 == 0 ? "\r\n" : " \n";
    }
    return text;
}

std::uint32_t at_or_none(const std::vector<std::uint32_t>& list, std::size_t i) {
    return list.empty() ? none : list.at(i);
}

TEST(ObjJudge, TinyobjloaderReadsTheSame) {
    std::mt19937 random(2024);
    for (int trial = 0; trial < 200; ++trial) {
        const std::string text = random_obj(random);
        const PolygonSoup ours = join_obj(read_obj(text, "t.obj", {}));

        tinyobj::attrib_t attributes;
        std::vector<tinyobj::shape_t> shapes;
        std::vector<tinyobj::material_t> materials;
        std::string warnings;
        std::string errors;
        std::istringstream stream(text);
        ASSERT_TRUE(tinyobj::LoadObj(&attributes, &shapes, &materials, &warnings, &errors, &stream,
                                     nullptr, false))
            << errors;
        ASSERT_EQ(shapes.size(), 1u);
        const tinyobj::mesh_t& theirs = shapes[0].mesh;

        ASSERT_EQ(ours.vertices.size() * 3, attributes.vertices.size());
        for (std::size_t i = 0; i < ours.vertices.size(); ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                // tinyobjloader rounds its decimals more than once.
                const double value = attributes.vertices[3 * i + static_cast<std::size_t>(axis)];
                EXPECT_NEAR(ours.vertices[i][axis], value, 1e-14 * (1 + std::abs(value)));
            }
        }
        ASSERT_EQ(ours.face_ends.size(), theirs.num_face_vertices.size());
        ASSERT_EQ(ours.corners.size(), theirs.indices.size());
        std::size_t end = 0;
        for (std::size_t face = 0; face < ours.face_ends.size(); ++face) {
            end += theirs.num_face_vertices[face];
            EXPECT_EQ(ours.face_ends[face], end);
        }
        for (std::size_t i = 0; i < ours.corners.size(); ++i) {
            const tinyobj::index_t& corner = theirs.indices[i];
            EXPECT_EQ(ours.corners[i], static_cast<std::uint32_t>(corner.vertex_index));
            EXPECT_EQ(at_or_none(ours.uv_corners, i),
                      static_cast<std::uint32_t>(corner.texcoord_index));
            EXPECT_EQ(at_or_none(ours.normal_corners, i),
                      static_cast<std::uint32_t>(corner.normal_index));
        }
    }
}

/// Random materials of the statements that both know, and faces that use them.
struct Painted {
    std::string obj, mtl;
};
Painted random_materials(std::mt19937& random) {
    Painted files;
    const auto share = [&] { return std::ldexp(static_cast<double>(random() % 256), -8); };
    const auto count = static_cast<unsigned>(1 + random() % 5);
    for (unsigned i = 0; i < count; ++i) {
        files.mtl += fmt::format("newmtl m{}\n", i);
        const auto maybe = [&](const std::string& line) {
            if (random() % 3 != 0) files.mtl += line + (random() % 2 == 0 ? "\n" : "\r\n");
        };
        for (const char* color : {"Ka", "Kd", "Ks", "Ke"})
            maybe(fmt::format("{} {} {} {}", color, share(), share(), share()));
        maybe(fmt::format("Ns {}", 100 * share()));
        maybe(fmt::format("Ni {}", 1 + share()));
        maybe(random() % 2 == 0 ? fmt::format("d {}", share()) : fmt::format("Tr {}", share()));
        maybe(fmt::format("illum {}", random() % 10));
        maybe(fmt::format("map_Kd pictures/wood {}.png", i));
    }
    files.obj = "mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    for (unsigned i = 0; i < 10; ++i) {
        if (i == 0 || random() % 2 == 0) files.obj += fmt::format("usemtl m{}\n", random() % count);
        files.obj += random() % 2 == 0 ? "f 1 2 3\n" : "f 1 2 4\n";
    }
    return files;
}

TEST(ObjJudge, TinyobjloaderReadsTheSameMaterials) {
    std::mt19937 random(2026);
    for (int trial = 0; trial < 200; ++trial) {
        const Painted files = random_materials(random);
        const LoadedMesh ours = read_mesh(files.obj, "t.obj");
        const ObjMaterials found =
            find_materials(ours, "t.obj", [&](const std::string&) { return files.mtl; });

        tinyobj::attrib_t attributes;
        std::vector<tinyobj::shape_t> shapes;
        std::vector<tinyobj::material_t> theirs;
        std::string warnings;
        std::string errors;
        std::istringstream obj(files.obj);
        std::istringstream mtl(files.mtl);
        tinyobj::MaterialStreamReader reader(mtl);
        ASSERT_TRUE(tinyobj::LoadObj(&attributes, &shapes, &theirs, &warnings, &errors, &obj,
                                     &reader, false))
            << errors;
        const std::vector<int>& numbers = shapes.at(0).mesh.material_ids;
        ASSERT_EQ(numbers.size(), ours.mesh.faces.size());
        for (std::size_t face = 0; face < numbers.size(); ++face) {
            const tinyobj::material_t& t = theirs.at(static_cast<std::size_t>(numbers[face]));
            const std::size_t slot = ours.face_materials.empty() ? 0 : ours.face_materials[face];
            ASSERT_TRUE(found.materials.at(slot)) << ours.materials.at(slot);
            const MtlMaterial& m = *found.materials[slot];
            EXPECT_EQ(ours.materials.at(slot), t.name);
            EXPECT_EQ(m.name, t.name);
            const auto expect_color = [](const std::optional<Color>& color, const double* other) {
                for (int i = 0; color && i < 3; ++i) EXPECT_NEAR((*color)[i], other[i], 1e-12);
            };
            expect_color(m.ambient, t.ambient);
            expect_color(m.diffuse, t.diffuse);
            expect_color(m.specular, t.specular);
            expect_color(m.emission, t.emission);
            if (m.shininess) {
                EXPECT_NEAR(*m.shininess, t.shininess, 1e-12);
            }
            if (m.ior) {
                EXPECT_NEAR(*m.ior, t.ior, 1e-12);
            }
            if (m.opacity) {
                EXPECT_NEAR(*m.opacity, t.dissolve, 1e-12);
            }
            if (m.illumination) {
                EXPECT_EQ(*m.illumination, t.illum);
            }
            EXPECT_EQ(m.image, t.diffuse_texname);
        }
    }
}

}  // namespace
}  // namespace lancer::io
