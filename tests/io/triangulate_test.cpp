#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numeric>
#include <random>

#include "model/diagnostic.h"
#include "model/io/degenerate.h"
#include "model/io/expansion.h"
#include "model/io/mesh_file.h"

namespace lancer::io {
namespace {

using testing::ElementsAre;
using Triangles = std::vector<Mesh::Corners>;

std::vector<std::uint32_t> all_of(const std::vector<Vec3d>& points) {
    std::vector<std::uint32_t> corners(points.size());
    std::iota(corners.begin(), corners.end(), 0u);
    return corners;
}

Triangles split(const std::vector<Vec3d>& points) {
    Triangles triangles;
    const bool any = triangulate(points, all_of(points), triangles);
    EXPECT_EQ(any, !triangles.empty());
    return triangles;
}

Vec3d area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return cross(b - a, c - a) * 0.5;
}

/// Checks that the triangles together have the area of the polygon and all turn the same way: in
/// the plane, this means that they cover it without overlap.
void expect_covers(const std::vector<Vec3d>& points, const Triangles& triangles, Vec3d normal) {
    Vec3d outline{0, 0, 0};
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        outline = outline + area(points[0], points[i], points[i + 1]);
    }
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
        const double part = dot(area(points[a], points[b], points[c]), normal);
        EXPECT_GT(part, 0);
        sum += part;
    }
    EXPECT_NEAR(sum, dot(outline, normal), 1e-12 * std::abs(sum));
}

TEST(Triangulate, AConvexFaceIsAFanFromItsFirstCorner) {
    EXPECT_THAT(split({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), ElementsAre(Mesh::Corners{0, 1, 2}));
    std::vector<Vec3d> hexagon;
    for (int i = 0; i < 6; ++i) {
        hexagon.emplace_back(std::cos(i), 2.0, std::sin(i));
    }
    EXPECT_THAT(split(hexagon), ElementsAre(Mesh::Corners{0, 1, 2}, Mesh::Corners{0, 2, 3},
                                            Mesh::Corners{0, 3, 4}, Mesh::Corners{0, 4, 5}));
}

TEST(Triangulate, AConcaveQuadrilateralIsCutAtItsReflexCorner) {
    const std::vector<Vec3d> dart{{0, 0, 0}, {2, 2, 0}, {0, 1, 0}, {-2, 2, 0}};
    for (std::size_t turn = 0; turn < 4; ++turn) {
        std::vector<Vec3d> points = dart;
        std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(turn),
                    points.end());
        expect_covers(points, split(points), {0, 0, 1});
        std::reverse(points.begin(), points.end());
        expect_covers(points, split(points), {0, 0, -1});
    }
}

/// A comb: a bar with teeth, an extremely concave polygon.
std::vector<Vec3d> comb(int teeth) {
    std::vector<Vec3d> points{{0, 0, 0}, {2.0 * teeth, 0, 0}};
    for (int i = teeth - 1; i >= 0; --i) {
        points.emplace_back(2.0 * i + 1.5, 5, 0);
        points.emplace_back(2.0 * i + 1, 0.25, 0);
    }
    return points;
}

TEST(Triangulate, CoversAComb) {
    const std::vector<Vec3d> points = comb(100);
    const Triangles triangles = split(points);
    EXPECT_EQ(triangles.size(), points.size() - 2);
    expect_covers(points, triangles, {0, 0, 1});
}

TEST(Triangulate, CoversRandomStarsInAnyPlaneAtAnyScale) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.05, 1);
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3d u = normalize(Vec3d(uniform(random), uniform(random), -uniform(random)));
        const Vec3d n = normalize(cross(u, Vec3d(uniform(random), -uniform(random), 1)));
        const Vec3d v = cross(n, u);
        std::vector<Vec3d> points;
        const int count = 4 + trial % 30;
        for (int i = 0; i < count; ++i) {
            const double radius = uniform(random);
            const double angle = tau * i / count;
            points.push_back(u * (radius * std::cos(angle)) + v * (radius * std::sin(angle)));
        }
        const Triangles triangles = split(points);
        EXPECT_EQ(triangles.size(), points.size() - 2);
        expect_covers(points, triangles, n);
        for (const int power : {500, -500, 1000, -900}) {
            std::vector<Vec3d> scaled;
            for (const Vec3d& p : points) scaled.push_back(scaled_by_power_of_two(p, power));
            EXPECT_EQ(split(scaled), triangles) << power;
        }
    }
}

TEST(Triangulate, ACornerOnAnEdgeStaysACorner) {
    // A fan from the first corner would begin with a triangle without area and lose corner 1.
    const std::vector<Vec3d> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    const Triangles triangles = split(points);
    expect_covers(points, triangles, {0, 0, 1});
    EXPECT_EQ(triangles.size(), 2u);
}

TEST(Triangulate, ARepeatedCornerDoesNoHarm) {
    const std::vector<Vec3d> points{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    const Triangles triangles = split(points);
    EXPECT_EQ(triangles.size(), 1u);
    expect_covers(points, triangles, {0, 0, 1});
}

TEST(Triangulate, AHoleReachedByABridgeStaysOpen) {
    const std::vector<Vec3d> points{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0},
                                    {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}};
    const Triangles triangles = split(points);
    EXPECT_EQ(triangles.size(), 8u);
    expect_covers(points, triangles, {0, 0, 1});
}

TEST(Triangulate, FacesWithoutAreaGiveNothing) {
    EXPECT_TRUE(split({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}).empty());
    EXPECT_TRUE(split({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}}).empty());
    EXPECT_TRUE(split({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).empty());
    EXPECT_TRUE(split({{0, 0, 0}, {1, 0, 0}}).empty());
    EXPECT_TRUE(split({{0, 0, 0}, {0.1, 0.2, 0.7}, {0.3, 0.6, 2.1}}).empty());
    EXPECT_TRUE(split({{0, 0, 0}, {5e-324, 0, 0}, {0, 5e-324, 0}}).empty());
}

TEST(Triangulate, AlwaysEndsOnOutlinesThatCrossThemselves) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<Vec3d> points;
        const std::size_t count = 4 + random() % 40;
        for (std::size_t i = 0; i < count; ++i) {
            points.emplace_back(random() % 8, random() % 8, random() % 3);
        }
        EXPECT_LE(split(points).size(), count - 2);
    }
}

TEST(Triangulate, EndsWhenTheSpikeItCutsIsWhereItStands) {
    // Found by a fuzzer: the walk went on from a corner that was no longer in the outline.
    std::mt19937 random(9);
    for (int trial = 0; trial < 3000; ++trial) {
        std::vector<Vec3d> points;
        const std::size_t count = 4 + random() % 12;
        for (std::size_t i = 0; i < count; ++i) points.emplace_back(random() % 3, random() % 2, 0);
        EXPECT_LE(split(points).size(), count - 2);
    }
}

TEST(Triangulate, RefusesConcaveFacesThatWouldTakeForever) {
    const std::vector<Vec3d> points = comb(6000);
    Triangles triangles;
    EXPECT_THROW(triangulate(points, all_of(points), triangles), FileError);
    std::vector<Vec3d> circle;
    for (int i = 0; i < 20000; ++i) {
        circle.emplace_back(std::cos(tau * i / 20000), std::sin(tau * i / 20000), 0);
    }
    EXPECT_EQ(split(circle).size(), 19998u);
}

TEST(Degenerate, KeepsNeedlesAndDropsLinesAtAnyScale) {
    const Vec3d a{0, 0, 0};
    for (const double scale : {1.0, 1e-150, 1e150, 1e300, 1e-290}) {
        EXPECT_FALSE(is_degenerate(a, Vec3d(scale, 0, 0), Vec3d(scale, 1e-12 * scale, 0)));
        EXPECT_FALSE(is_degenerate(a, Vec3d(scale, 0, 0), Vec3d(scale / 2, 1e-12 * scale, 0)));
        EXPECT_TRUE(is_degenerate(a, Vec3d(scale, scale, scale), Vec3d(scale, scale, scale) * 3.0));
        EXPECT_TRUE(is_degenerate(a, Vec3d(scale, 0, 0), Vec3d(scale / 2, 1e-17 * scale, 0)));
    }
    // However thin, a right angle is an angle.
    EXPECT_FALSE(is_degenerate(a, {1, 0, 0}, {1, 1e-200, 0}));
    EXPECT_FALSE(is_degenerate({1e308, 0, 0}, {-1e308, 0, 0}, {0, 1e308, 0}));
}

TEST(Degenerate, DoesNotDependOnTheOrderOfCorners) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 2000; ++i) {
        const Vec3d a(uniform(random), uniform(random), uniform(random));
        const Vec3d d(uniform(random), uniform(random), uniform(random));
        const Vec3d off(0, 0, std::ldexp(uniform(random), -static_cast<int>(random() % 60)));
        const Vec3d b = a + d * 0.3;
        const Vec3d c = a + d + off;
        // Edges are rounded differences, so at the bound the result may depend on the order: avoid
        // that range.
        const double angle = length(cross(b - a, c - b)) / (length(b - a) * length(c - b));
        if (angle > 1e-16 && angle < 1e-15) continue;
        EXPECT_EQ(is_degenerate(a, b, c), is_degenerate(b, c, a));
        EXPECT_EQ(is_degenerate(a, b, c), is_degenerate(c, b, a));
    }
}

TEST(Orientation, IsExactWhereRoundingFails) {
    // Points next to a line through the origin, after Kettner, Mehlhorn, Pion, Schirra and Yap,
    // Classroom examples of robustness problems in geometric computations (2008), section 3.
    const double step = std::ldexp(1, -53);
    int naive_errors = 0;
    for (int i = 0; i < 64; ++i) {
        for (int j = 0; j < 64; ++j) {
            const Vec2d p(0.5 + i * step, 0.5 + j * step);
            const Vec2d q(12, 12);
            const Vec2d r(24, 24);
            const int exact = (i < j) - (i > j);  // p is above the diagonal when j > i
            EXPECT_EQ(orientation(q, r, p), exact);
            EXPECT_EQ(orientation(p, q, r), exact);
            EXPECT_EQ(orientation(r, q, p), -exact);
            const double naive = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
            if ((naive > 0) - (naive < 0) != exact) ++naive_errors;
        }
    }
    EXPECT_GT(naive_errors, 100);  // the test would show it
}

}  // namespace
}  // namespace lancer::io
