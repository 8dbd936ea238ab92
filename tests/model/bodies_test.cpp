#include "model/bodies.h"

#include <gtest/gtest.h>

namespace lancer {
namespace {

/// A tetrahedron whose faces share their corners by index.
Mesh tetrahedron() {
    Mesh mesh;
    mesh.vertices = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
    mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return mesh;
}

/// The same mesh with three vertices of its own for each face, as STL has it.
Mesh unshared(const Mesh& mesh) {
    Mesh soup;
    for (const Mesh::Corners& face : mesh.faces) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const std::uint32_t corner : face) soup.vertices.push_back(mesh.vertices[corner]);
        soup.faces.push_back({first, first + 1, first + 2});
    }
    return soup;
}

bool lathe_is_body(Spline spline, std::vector<Vec2d> profile) {
    Scene scene;
    scene.lathes.push_back({std::move(profile), spline, {}});
    return is_body(scene, LatheRef{0});
}

TEST(Bodies, AMeshIsClosedWhenEveryEdgeHasTwoFaces) {
    Mesh mesh = tetrahedron();
    EXPECT_TRUE(is_closed(mesh));
    mesh.faces.pop_back();
    EXPECT_FALSE(is_closed(mesh)) << "a face is missing";
    mesh = tetrahedron();
    mesh.vertices.push_back(Vec3d(-1, -1, 0));
    mesh.faces.push_back({0, 1, 4});
    EXPECT_FALSE(is_closed(mesh)) << "an edge has three faces";
    EXPECT_FALSE(is_closed(Mesh{})) << "nothing encloses nothing";
}

TEST(Bodies, CornersAtOnePlaceAreOneCorner) {
    EXPECT_TRUE(is_closed(unshared(tetrahedron())));
    Mesh mesh = unshared(tetrahedron());
    mesh.vertices[0].x = -0.0;
    EXPECT_TRUE(is_closed(mesh)) << "minus zero is zero";
    mesh.vertices[0].x = 1e-300;
    EXPECT_FALSE(is_closed(mesh)) << "no tolerance";
}

TEST(Bodies, OpenCylindersConesAndPrismsAreSheets) {
    Scene scene;
    scene.prisms.resize(2);
    scene.prisms[1].capped = false;
    EXPECT_TRUE(is_body(scene, Cylinder{}));
    EXPECT_FALSE(is_body(scene, Cylinder{.capped = false}));
    EXPECT_TRUE(is_body(scene, Cone{}));
    EXPECT_FALSE(is_body(scene, Cone{.capped = false}));
    EXPECT_TRUE(is_body(scene, PrismRef{0}));
    EXPECT_FALSE(is_body(scene, PrismRef{1}));
    EXPECT_TRUE(is_body(scene, Plane{}));
    EXPECT_FALSE(is_body(scene, Triangle{}));
    EXPECT_FALSE(is_body(scene, PatchRef{0}));
}

TEST(Bodies, ALatheIsABodyWhenItsCurveEndsOnTheAxisOrInItself) {
    EXPECT_TRUE(lathe_is_body(Spline::linear, {{0, 0}, {1, 1}, {0, 2}}));
    EXPECT_FALSE(lathe_is_body(Spline::linear, {{0, 0}, {1, 1}, {0.5, 2}}));
    EXPECT_TRUE(lathe_is_body(Spline::linear, {{1, 0}, {2, 0}, {2, 1}, {1, 0}}));
    EXPECT_TRUE(lathe_is_body(Spline::bezier, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    // The outer points of a Catmull-Rom spline only guide.
    EXPECT_TRUE(lathe_is_body(Spline::catmull_rom, {{3, -1}, {0, 0}, {1, 1}, {0, 2}, {3, 3}}));
    EXPECT_FALSE(lathe_is_body(Spline::catmull_rom, {{0, -1}, {1, 0}, {1, 1}, {1, 2}, {0, 3}}));
    // A B-spline begins at (a + 4b + c) / 6.
    EXPECT_TRUE(lathe_is_body(Spline::bspline, {{-1, -1}, {0, 0}, {1, 1}, {0, 2}, {-1, 3}}));
    EXPECT_FALSE(lathe_is_body(Spline::bspline, {{0, -1}, {0, 0}, {1, 1}, {0, 2}, {0, 3}}));
}

}  // namespace
}  // namespace lancer
