#include "model/smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lancer {
namespace {

/// A cube from -1 to 1 of 8 vertices and 12 triangles that look outside.
Mesh cube() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    for (const auto& [a, b, c, d] :
         {std::array{0u, 2u, 3u, 1u}, std::array{4u, 5u, 7u, 6u}, std::array{0u, 1u, 5u, 4u},
          std::array{2u, 6u, 7u, 3u}, std::array{0u, 4u, 6u, 2u}, std::array{1u, 3u, 7u, 5u}}) {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
    }
    return mesh;
}

Vec3d normal_at(const Mesh& mesh, std::size_t face, std::size_t corner) {
    return mesh.normals.at(mesh.normal_faces.at(face)[corner]);
}

/// A roof of two rectangles whose normals are `degrees` apart.
Mesh roof(double degrees) {
    const double half = degrees / 2 * 3.14159265358979323846 / 180;
    const double x = std::cos(half), y = std::sin(half);
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 0, 1}, {x, -y, 0}, {x, -y, 1}, {-x, -y, 0}, {-x, -y, 1}};
    mesh.faces = {{0, 1, 3}, {0, 3, 2}, {1, 0, 4}, {1, 4, 5}};
    return mesh;
}

TEST(Smoothing, KeepsTheEdgesOfACube) {
    const Mesh smoothed = with_sharp_edges(cube(), 40);
    EXPECT_EQ(smoothed.normals.size(), 24u);
    for (std::size_t f = 0; f < smoothed.faces.size(); ++f) {
        const auto& [a, b, c] = smoothed.faces[f];
        const Vec3d across = normalize(cross(smoothed.vertices[b] - smoothed.vertices[a],
                                             smoothed.vertices[c] - smoothed.vertices[a]));
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(normal_at(smoothed, f, k), across);
    }
}

TEST(Smoothing, AnEdgeOfExactlyTheAngleIsSmooth) {
    EXPECT_EQ(with_sharp_edges(cube(), 90).normals.size(), 8u);
    EXPECT_EQ(with_sharp_edges(cube(), 89.9).normals.size(), 24u);
    for (const double degrees : {1e-3, 12.0, 40.0, 60.0, 120.0, 179.0}) {
        EXPECT_EQ(with_sharp_edges(roof(degrees), degrees * 1.0001).normals.size(), 6u) << degrees;
        EXPECT_EQ(with_sharp_edges(roof(degrees), degrees * 0.9999).normals.size(), 8u) << degrees;
    }
    EXPECT_EQ(with_sharp_edges(roof(30), 0).normals.size(), 8u);
}

TEST(Smoothing, WeighsByArea) {
    Mesh mesh = roof(60);
    // The left half four times as wide.
    mesh.vertices[4] = 4.0 * mesh.vertices[4];
    mesh.vertices[5] = mesh.vertices[4] + Vec3d(0, 0, 1);
    const Mesh smoothed = with_sharp_edges(mesh, 90);
    // At vertex 1: one right triangle of area 1/2, and the left ones of 2 each.
    const Vec3d right(std::sin(3.14159265358979323846 / 6), std::cos(3.14159265358979323846 / 6),
                      0);
    const Vec3d left(-right.x, right.y, 0);
    const Vec3d expected = normalize(right * 0.5 + left * 4.0);
    EXPECT_NEAR(length(normal_at(smoothed, 0, 1) - expected), 0, 1e-15);
}

TEST(Smoothing, IsTheSameAtAnySize) {
    const Mesh unit = with_sharp_edges(roof(30), 40);
    for (const int exponent : {-900, -300, 300, 900}) {
        Mesh mesh = roof(30);
        for (Vec3d& v : mesh.vertices)
            v = Vec3d(std::ldexp(v.x, exponent), std::ldexp(v.y, exponent),
                      std::ldexp(v.z, exponent));
        const Mesh smoothed = with_sharp_edges(mesh, 40);
        EXPECT_EQ(smoothed.normals, unit.normals);
        EXPECT_EQ(smoothed.normal_faces, unit.normal_faces);
    }
}

TEST(Smoothing, AnEdgeOfThreeFacesIsSharpAndLeftOverVerticesDoNotMatter) {
    Mesh mesh = roof(20);
    mesh.vertices.emplace_back(9, 9, 9);
    mesh.vertices.emplace_back(0, 1, 0.5);
    mesh.faces.push_back({0, 1, 7});
    EXPECT_EQ(with_sharp_edges(mesh, 40).normals.size(), 6u + 2u + 2u + 1u);
}

TEST(Smoothing, AFanOfManyFacesTakesNoSquareOfTime) {
    Mesh mesh;
    constexpr std::uint32_t count = 200'000;
    mesh.vertices.emplace_back(0, 0.1, 0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double a = 2 * 3.14159265358979323846 * i / count;
        mesh.vertices.emplace_back(std::cos(a), 0, -std::sin(a));
        mesh.faces.push_back({0, i + 1, (i + 1) % count + 1});
    }
    EXPECT_EQ(with_sharp_edges(mesh, 40).normals.size(), count + std::size_t{1});
}

TEST(Smoothing, CountsSharpEdges) {
    EXPECT_EQ(count_sharp_edges(cube(), 60), 12u);
    EXPECT_EQ(count_sharp_edges(cube(), 90), 0u);
    EXPECT_EQ(count_sharp_edges(roof(61), 60), 1u);
    EXPECT_EQ(count_sharp_edges(roof(59), 60), 0u);
}

}  // namespace
}  // namespace lancer
