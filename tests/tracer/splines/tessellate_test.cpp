#include "tracer/tessellation/tessellate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "model/patch_net.h"
#include "tests/tracer/splines/fewest_grid.h"
#include "tests/tracer/splines/random_patch.h"

namespace lancer::splines {
namespace {

/// Edges with only one face, as pairs of places: the rim of the mesh. A crack makes the rim longer.
std::size_t open_edges(const std::vector<const Mesh*>& meshes) {
    using Key = std::array<double, 6>;
    std::map<Key, int> count;
    for (const Mesh* mesh : meshes) {
        for (const auto& face : mesh->faces) {
            for (std::size_t k = 0; k < 3; ++k) {
                Vec3d a = mesh->vertices[face[k]];
                Vec3d b = mesh->vertices[face[(k + 1) % 3]];
                const auto key = [](const Vec3d& p) { return std::array{p.x, p.y, p.z}; };
                if (key(b) < key(a)) std::swap(a, b);
                ++count[{a.x, a.y, a.z, b.x, b.y, b.z}];
            }
        }
    }
    return static_cast<std::size_t>(
        std::ranges::count_if(count, [](const auto& edge) { return edge.second == 1; }));
}

/// Edges along the side at which the texture coordinate v has this value.
std::size_t border_edges(const Mesh& mesh, double v) {
    std::size_t edges = 0;
    for (const auto& face : mesh.faces) {
        for (std::size_t k = 0; k < 3; ++k)
            edges += mesh.uvs[face[k]].y == v && mesh.uvs[face[(k + 1) % 3]].y == v;
    }
    return edges;
}

TEST(Tessellate, DistanceIsWithinTheToleranceAtAnyScale) {
    for (unsigned seed = 0; seed < 6; ++seed) {
        for (const double factor : {1.0, 1e9, 1e-9, 1e90, 1e-90}) {
            if (seed > 1 && factor != 1) continue;
            const Patch patch = random_patch_from_corner(seed, factor, seed % 2 == 0 ? 1 : 0.1);
            for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
                const auto mesh = tessellate(patch, tolerance * factor);
                ASSERT_TRUE(mesh);
                const Wide worst = measured_distance(patch, *mesh, 6) / factor;
                EXPECT_LE(worst, tolerance) << seed << " " << factor;
                RecordProperty("worst", std::to_string(static_cast<double>(worst)));
            }
        }
    }
}

TEST(Tessellate, EachPatchIsCutAsIfAlone) {
    // Scaling by a power of two scales the mesh exactly.
    const Patch patch = random_patch_from_corner(1, 1, 1);
    Patch large = patch;
    for (Vec3d& p : large.control) p *= 1024.0;
    const auto a = tessellate(patch, 1e-3);
    const auto b = tessellate(large, 1.024);
    ASSERT_EQ(a->vertices.size(), b->vertices.size());
    for (std::size_t i = 0; i < a->vertices.size(); ++i) {
        EXPECT_EQ(a->vertices[i] * 1024.0, b->vertices[i]);
    }
}

TEST(Tessellate, FewTrianglesForItsPromise) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        for (const double flatness : {1.0, 0.3, 0.1}) {
            const Patch patch = random_patch_from_corner(seed, 1, flatness);
            for (const double tolerance : {1e-1, 3e-2, 1e-2}) {
                const std::size_t triangles = tessellate(patch, tolerance)->faces.size();
                UniformGrids grids(bezier_net(patch).patch(0, 0), tolerance);
                EXPECT_LE(triangles, 2 * grids.fewest(triangles))
                    << seed << " " << flatness << " " << tolerance;
            }
        }
    }
}

TEST(Tessellate, NeighboursOfDifferentTolerancesHaveOneBorder) {
    const Patch first = random_patch_from_corner(1, 1, 1);
    Patch second = random_patch_from_corner(2, 1, 1);
    for (Vec3d& p : second.control) p.z += 1;
    for (std::size_t i = 0; i < 4; ++i) second.control[i] = first.control[12 + i];
    std::ranges::reverse(second.control);
    for (const auto& [a, b] : {std::pair<std::optional<double>, std::optional<double>>{1e-2, 1e-4},
                               {1e-4, 1e-2},
                               {{}, 1e-4},
                               {1e-2, {}}}) {
        BorderTolerances borders;
        borders.add(first, a);
        borders.add(second, b);
        const auto one = tessellate(first, a, &borders);
        const auto two = tessellate(second, b, &borders);
        ASSERT_TRUE(one && two);
        EXPECT_GT(one->faces.size() * two->faces.size(), 100u);
        EXPECT_LE(measured_distance(first, *one, 4), a.value_or(1));
        EXPECT_LE(measured_distance(second, *two, 4), b.value_or(1));
        // The common border is no rim of both together.
        EXPECT_EQ(open_edges({&*one}) + open_edges({&*two}) - open_edges({&*one, &*two}),
                  2 * border_edges(*one, 1));
        EXPECT_EQ(border_edges(*one, 1), border_edges(*two, 1));
    }
}

TEST(Tessellate, NoCracksWithinANetNorBetweenPatches) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> place(-1, 1);
    Patch net{Patch::Basis::bspline, 7, 6, {}, {}};
    for (int i = 0; i < 7; ++i) {
        for (int j = 0; j < 6; ++j) {
            net.control.emplace_back(j + 0.3 * place(generator), 2 * place(generator),
                                     i + 0.3 * place(generator));
        }
    }
    for (const auto tolerance : {std::optional<double>{}, std::optional<double>{0.003}}) {
        const auto whole = tessellate(net, tolerance);
        ASSERT_TRUE(whole);
        // The rim: the edges of the mesh that lie on the net's border.
        std::size_t rim = 0;
        for (const auto& face : whole->faces) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec2d a = whole->uvs[face[k]];
                const Vec2d b = whole->uvs[face[(k + 1) % 3]];
                rim += (a.x == b.x && (a.x == 0 || a.x == 1)) ||
                       (a.y == b.y && (a.y == 0 || a.y == 1));
            }
        }
        EXPECT_EQ(open_edges({&*whole}), rim);

        // The same patches one by one, some of them turned round.
        const BezierNet bezier = bezier_net(net);
        std::vector<Mesh> parts;
        for (std::size_t i = 0; i < bezier.rows; ++i) {
            for (std::size_t j = 0; j < bezier.columns; ++j) {
                const BezierPatch p = bezier.patch(i, j);
                Patch single{Patch::Basis::bezier, 4, 4, {p.begin(), p.end()}, {}};
                if ((i + j) % 2 == 1) std::ranges::reverse(single.control);
                parts.push_back(*tessellate(single, tolerance));
            }
        }
        std::vector<const Mesh*> all;
        for (const Mesh& part : parts) all.push_back(&part);
        EXPECT_EQ(open_edges(all), rim);
    }
}

TEST(Tessellate, ABorderMuchStraighterThanTheInside) {
    // Straight borders, a bulge inside.
    Patch patch;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            const bool inside = i > 0 && i < 3 && j > 0 && j < 3;
            patch.control.emplace_back(j, inside ? 8 : 0, i);
        }
    }
    for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
        const auto mesh = tessellate(patch, tolerance);
        ASSERT_TRUE(mesh);
        EXPECT_LE(measured_distance(patch, *mesh, 4), tolerance);
        EXPECT_EQ(open_edges({&*mesh}), 4u);
    }
}

/// An eighth of a ball, near enough: one border is a pole.
Patch eighth() {
    const double k = 0.5522847498;
    Patch patch;
    const std::array<Vec2d, 4> arc{Vec2d{0, 1}, {k, 1}, {1, k}, {1, 0}};  // (radius, height)
    for (const Vec2d& a : arc) {
        for (const Vec2d& t : {Vec2d{1, 0}, {1, k}, {k, 1}, {0, 1}}) {
            patch.control.emplace_back(a.x * t.x, a.y, a.x * t.y);
        }
    }
    return patch;
}

TEST(Tessellate, APoleHasItsNormalAndNoEmptyTriangles) {
    const Patch patch = eighth();
    const auto mesh = tessellate(patch, 1e-3);
    ASSERT_TRUE(mesh);
    int poles = 0;
    for (std::size_t i = 0; i < mesh->vertices.size(); ++i) {
        EXPECT_NEAR(length(mesh->normals[i]), 1, 1e-12);
        EXPECT_GT(std::abs(dot(mesh->normals[i], mesh->vertices[i])), 0.999);
        poles += mesh->vertices[i] == Vec3d(0, 1, 0);
    }
    EXPECT_GT(poles, 0);
    for (const auto& f : mesh->faces) {
        const Vec3d& a = mesh->vertices[f[0]];
        EXPECT_GT(length(cross(mesh->vertices[f[1]] - a, mesh->vertices[f[2]] - a)), 0);
    }
    EXPECT_LE(measured_distance(patch, *mesh, 5), 1e-3);
}

TEST(Tessellate, NormalsAreFiniteWhateverControlPointsCoincide) {
    std::mt19937 generator(8);
    std::uniform_int_distribution<int> which(0, 15);
    for (int round = 0; round < 300; ++round) {
        Patch patch = random_patch_from_corner(static_cast<unsigned>(round), 1, 1);
        for (int k = 0; k < round % 12; ++k) {
            patch.control[static_cast<std::size_t>(which(generator))] =
                patch.control[static_cast<std::size_t>(which(generator))];
        }
        const auto mesh = tessellate(patch, 0.05);
        ASSERT_TRUE(mesh);
        for (const Vec3d& n : mesh->normals) {
            ASSERT_TRUE(is_finite(n));
            EXPECT_NEAR(length(n), 1, 1e-9) << round;
        }
    }
}

TEST(Tessellate, AFlatPatchIsTwoTrianglesAndAPointIsNothing) {
    Patch patch;
    for (int i = 0; i < 16; ++i) patch.control.emplace_back(i % 4, 0, i / 4);
    EXPECT_EQ(tessellate(patch, 1e-9)->faces.size(), 2u);
    patch.control.assign(16, Vec3d(1, 2, 3));
    EXPECT_TRUE(tessellate(patch, 1e-9)->faces.empty());
}

TEST(Tessellate, TooManyTrianglesAreRefusedBeforeTheyAreMade) {
    EXPECT_FALSE(tessellate(random_patch_from_corner(1, 1, 1), 1e-12));
    EXPECT_FALSE(tessellate(random_patch_from_corner(1, 1, 1), 1e-300));
    // All points on a line: no normal anywhere.
    Patch line;
    line.control.assign(16, Vec3d(0));
    line.control[15] = {1, 2, 3};
    EXPECT_FALSE(tessellate(line, 1e-16));
    EXPECT_TRUE(tessellate(line, 1e-3));
}

TEST(Tessellate, AToleranceFinerThanTheRoundingsIsTheRounding) {
    // Flat except for rounding, and far away: no triangle can be closer than the last digits of the
    // points.
    for (const double away : {0.0, 1e9}) {
        Patch patch;
        for (int i = 0; i < 16; ++i)
            patch.control.push_back(Vec3d(away) + Vec3d(i % 4, i / 4, i % 4 + i / 4) / 3.0);
        EXPECT_EQ(tessellate(patch, 1e-18)->faces.size(), 2u) << away;
    }
}

TEST(Tessellate, WildPatchesTakeFiniteTimeAndKeepTheirPromise) {
    // Control points anywhere, many of them the same; borders that fold, close and shrink.
    for (unsigned seed = 0; seed < 120; ++seed) {
        std::mt19937 generator(seed);
        std::uniform_real_distribution<double> place(-1, 1);
        std::uniform_int_distribution<std::size_t> which(0, 15);
        Patch patch = random_patch_from_corner(seed, 1, 1);
        auto& c = patch.control;
        for (std::size_t k = 0; k < 16; ++k) {
            if (seed % 4 == 0) c[k] = {place(generator), place(generator), place(generator)};
            if (seed % 4 == 1 && k < 10) c[which(generator)] = c[which(generator)];
            if (seed % 4 == 2 && k < 4) c[k] = c[4 + k] = seed % 8 == 2 ? c[12 + k] : c[4];
            if (seed % 4 == 3) c[k].y *= k % 3 == 0 ? 20 : 0;
        }
        const double tolerance = seed % 3 == 0 ? 0.3 : 0.02;
        const auto mesh = tessellate(patch, tolerance);
        ASSERT_TRUE(mesh);
        EXPECT_LE(measured_distance(patch, *mesh, 4, mesh->faces.size() / 200 | 1), tolerance)
            << seed;
    }
}

}  // namespace
}  // namespace lancer::splines
