// The result of a mesh block for closed and open meshes, and messages about glass that is not
// closed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/bodies.h"
#include "tests/parser/script.h"

namespace lancer {
namespace {

/// Meshes by name from texts; the rest as in memory_loader.
test::Result run_with(const std::string& script, const std::map<std::string, std::string>& files) {
    test::Result result;
    SourceMap sources;
    Loader loader = test::memory_loader({});
    loader.mesh = [&](const std::string& path) { return io::read_mesh(files.at(path), path); };
    const Script parsed = parse_script("main.lancer", script, {}, sources, result.found);
    Evaluation evaluation = evaluate(parsed, {}, {}, sources, result.found, loader);
    for (const Diagnostic& d : result.found) result.messages += format(d, sources);
    result.scene = std::move(evaluation.scene);
    return result;
}

const std::string two_sides_of_a_cube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 5 6 7 8\nf 6 2 3 7\n";

TEST(MeshBlock, AnAngleKeepsSharpEdges) {
    const auto result = run_with(
        "mesh { file \"a.obj\" smooth 40 } mesh { file \"a.obj\" } mesh { file \"a.obj\" smooth 40 "
        "}"
        "mesh { file \"a.obj\" smooth false } mesh { file \"a.obj\" smooth 90 }",
        {{"a.obj", two_sides_of_a_cube}});
    EXPECT_EQ(result.messages, "");
    const auto ref = [&](std::size_t i) {
        return std::get<MeshRef>(result.scene.objects.at(i).shape);
    };
    const auto normals = [&](std::size_t i) {
        return result.scene.meshes.at(ref(i).mesh)->normals.size();
    };
    EXPECT_EQ(result.scene.meshes.size(), 3u);
    EXPECT_EQ(ref(0).mesh, ref(2).mesh) << "made once";
    EXPECT_EQ(ref(1).mesh, ref(3).mesh);
    EXPECT_EQ(normals(0), 8u);
    EXPECT_EQ(normals(1), 0u) << "averages";
    EXPECT_EQ(normals(4), 6u);
    EXPECT_TRUE(ref(0).smooth && ref(1).smooth && !ref(3).smooth);
}

TEST(MeshBlock, AnStlKeepsEdgesSharperThanFortyDegrees) {
    const std::string stl =
        "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\n"
        "vertex 1 0 0\nendloop\nendfacet\nendsolid a\n";
    const auto normals = [&](const std::string& more) {
        const auto result = run_with("mesh { file \"a.STL\" " + more + " }", {{"a.STL", stl}});
        EXPECT_EQ(result.messages, "");
        return result.scene.meshes.at(0)->normals.size();
    };
    EXPECT_EQ(normals(""), 6u);
    EXPECT_EQ(normals("smooth 90"), 4u);
    EXPECT_EQ(normals("smooth true"), 0u) << "averages";
    EXPECT_EQ(normals("smooth false"), 0u);
}

TEST(MeshBlock, AMeshInPlaceTakesAnAngleAndGivenNormalsNeedNone) {
    const std::string corners =
        "mesh { vertices [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]] faces "
        "[[0, 1, 2], [0, 3, 1]] ";
    EXPECT_EQ(test::run(corners + "smooth 40 }").scene.meshes.at(0)->normals.size(), 6u);
    const auto given =
        test::run(corners + "smooth 40 normals [[0, 0, 1], [0, 0, 1], [0, 1, 1], [0, 1, 0]] }");
    EXPECT_EQ(given.messages, "");
    EXPECT_EQ(given.scene.meshes.at(0)->normals.at(2), Vec3d(0, 1, 1));
    EXPECT_NE(test::run(corners + "smooth 181 }").messages, "");
    EXPECT_NE(test::run(corners + "smooth -1 }").messages, "");
}

const std::string glass = "material { transmission 0.9 ior 1.5 }";
const std::string open_box =
    "mesh { vertices [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]] "
    "faces [[0, 2, 1], [0, 1, 3], [0, 3, 2]] ";

TEST(MeshBlock, GlassThatIsNotClosedIsAWarning) {
    const auto result = test::run(open_box + glass + " }");
    ASSERT_EQ(result.found.size(), 1u) << result.messages;
    EXPECT_EQ(result.found[0].severity, Severity::warning);
    EXPECT_EQ(result.found[0].message,
              "light passes through this mesh, but this surface is not closed: 3 of its edges do "
              "not belong to exactly two faces, the first from [0, 1, 0] to [1, 0, 0]; it has no "
              "inside, so its ior has no effect");
    // A pane bends nothing, and what is opaque needs no inside.
    EXPECT_EQ(test::run(open_box + "material { transmission 0.9 } }").messages, "");
    EXPECT_EQ(test::run(open_box + "material { ior 1.5 } }").messages, "");
    EXPECT_EQ(test::run(open_box + "material { filter 1 absorption [1, 0, 0] } }").found.size(),
              1u);
    EXPECT_EQ(test::run("group { " + open_box + "} " + glass + " }").found.size(), 1u);
    EXPECT_EQ(test::run("for i in 0..9 { " + open_box + glass + " } }").found.size(), 1u);
    const std::string closed =
        "mesh { vertices [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]] "
        "faces [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] ";
    EXPECT_EQ(test::run(closed + glass + " }").messages, "");
}

TEST(MeshBlock, BodyIsTheAuthorsWord) {
    const auto open = test::run(open_box + glass + " body true }");
    EXPECT_EQ(open.messages, "") << "no warning of gaps";
    EXPECT_TRUE(is_body(open.scene, open.scene.objects.at(0).shape));
    EXPECT_FALSE(is_body(test::run(open_box + "}").scene, MeshRef{0}));
    const std::string closed =
        "mesh { vertices [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]] "
        "faces [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] ";
    const auto sheet = test::run(closed + glass + " body false }");
    EXPECT_EQ(sheet.messages, "") << "it was asked for";
    EXPECT_FALSE(is_body(sheet.scene, sheet.scene.objects.at(0).shape));
    // Then a part of a body may have gaps, and one mesh may be used in both ways.
    const std::string cut = "difference { box { min [0, 0, 0] max [1, 1, 1] } " + open_box;
    EXPECT_NE(test::run(cut + "} }").messages, "");
    EXPECT_EQ(test::run(cut + "body true } }").messages, "");
    EXPECT_THAT(
        test::run("difference { box { min [0, 0, 0] max [1, 1, 1] } " + closed + "body false } }")
            .messages,
        testing::HasSubstr("a mesh with 'body false' has no inside"));
    EXPECT_THAT(test::run(open_box + "body 1 }").messages,
                testing::HasSubstr("'body' takes true or false"));
}

}  // namespace
}  // namespace lancer
