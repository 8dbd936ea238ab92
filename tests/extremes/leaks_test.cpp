// Closed surfaces are closed: at edges, vertices, seams and in needles, at any zoom.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/extremes/corners.h"
#include "tests/extremes/picture.h"

namespace lancer::extremes {
namespace {

/// Black inside a white world: every white pixel is a leak.
Stage dark() {
    Stage s;
    s.scene.background = {1, 1, 1};
    s.scene.width = 96;
    s.scene.height = 64;
    return s;
}
std::uint32_t black(Stage& s) {
    Material m;
    m.ambient = 0;
    m.diffuse = 0;
    m.color = {0, 0, 0};
    return s.material(m);
}

Vec3d perpendicular(const Vec3d& v) {
    return normalize(cross(v, std::abs(v.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0)));
}

TEST(Leaks, VerticesAndEdgesOfMeshes) {
    const Mesh ball = icosphere({0.1, -0.2, 0.3}, 1, 1);
    for (const bool loose : {false, true}) {
        for (const bool parallel : {false, true}) {
            for (int k = 0; k <= 14; k += 2) {
                for (const bool edge : {false, true}) {
                    const Mesh::Corners& f = ball.faces[7];
                    const Vec3d at = edge ? (ball.vertices[f[0]] + ball.vertices[f[1]]) / 2.0
                                          : ball.vertices[f[0]];
                    const Vec3d out = normalize(at - Vec3d(0.1, -0.2, 0.3));
                    Stage s = dark();
                    const std::uint32_t m = black(s);
                    if (loose) {
                        for (const Mesh::Corners& g : ball.faces)
                            s.add(Triangle{{ball.vertices[g[0]], ball.vertices[g[1]],
                                            ball.vertices[g[2]]}},
                                  m);
                    } else {
                        s.add(ball, m);
                    }
                    const double height = 0.5 * power10(-k);
                    const Vec3d from = at + out * 4.0 + perpendicular(out) * 0.7;
                    if (parallel)
                        s.look_parallel(from, at, height, perpendicular(out));
                    else
                        s.look(from, at, degrees(2 * std::atan(height / 8)), perpendicular(out));
                    EXPECT_EQ(wrong(picture(s.scene), Color(0, 0, 0)), 0)
                        << "k " << k << (loose ? " loose" : " mesh")
                        << (edge ? " edge" : " vertex");
                }
            }
        }
    }
}

TEST(Leaks, StretchedOctahedron) {
    for (int k = 0; k <= 12; ++k) {
        const double f = power10(k);
        const Affine<double> map = compose(turn(1, 20), compose(turn(2, 33), stretched(1, f, 1)));
        Mesh mesh;
        for (const Vec3d& v : {Vec3d(1, 0, 0), Vec3d(-1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, -1, 0),
                               Vec3d(0, 0, 1), Vec3d(0, 0, -1)})
            mesh.vertices.push_back(map_point(map, v));
        mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
        Stage s = dark();
        s.add(mesh, black(s));
        // Rays through the octahedron's inside, at points of its middle plane.
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(-1, 1);
        s.scene.width = s.scene.height = 1;
        Settings settings = s.scene.settings;
        int leaks = 0;
        for (int i = 0; i < 300; ++i) {
            const double x = unit(random) * 0.9;
            const double y = unit(random) * (0.9 - std::abs(x));
            const Vec3d target = map_point(map, {i % 3 == 0 ? 0 : x, i % 2 == 0 ? 0 : y, 0});
            const Vec3d from =
                target + map_vector(map, {0.1 * unit(random), 0.1 * unit(random), 5});
            s.look(from, target, 1e-9, map_vector(map, {1, 0, 0}));
            const auto renderer = compile(s.scene, settings);
            leaks += renderer->probe({0, 1, 1, {}, false}, 0.5, 0.5).object == none;
        }
        EXPECT_EQ(leaks, 0) << k;
    }
}

TEST(Leaks, SeamsOfSolids) {
    // Two solids that share a face, seen along it, zoomed onto the seam.
    for (int k = 0; k <= 14; k += 2) {
        for (const int kind : {0, 1, 2}) {
            Stage s = dark();
            const std::uint32_t m = black(s);
            const Vec3d axis = kind == 2 ? normalize(Vec3d(0.3, 1, 0.2)) : Vec3d(0, 1, 0);
            if (kind == 0) {
                s.add(Box{{-1, -1, -1}, {1, 0, 1}}, m);
                s.add(Box{{-1, 0, -1}, {1, 1, 1}}, m);
            } else {
                s.add(Cylinder{-axis, Vec3d(0.0), 1}, m);
                s.add(kind == 1 ? Shape(Cylinder{Vec3d(0.0), axis, 1})
                                : Shape(Cone{Vec3d(0.0), axis, 1, 0.5}),
                      m);
            }
            const double height = 0.5 * power10(-k);
            s.look({0.1, 0.2, 5}, {0.01, 0, 0}, degrees(2 * std::atan(height / 10)));
            EXPECT_EQ(wrong(picture(s.scene), Color(0, 0, 0)), 0) << k << " kind " << kind;
        }
    }
}

TEST(Leaks, EveryEdgeOfAGlassMeshIsCrossed) {
    // Rays aimed at vertices and edges of glass meshes: each enters as often as it leaves.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    std::uint64_t lost = 0;
    int odd = 0;
    for (const double angle : {0.0, 37.0}) {
        const Mesh ball = icosphere({0.1, -0.2, 0.3}, 1, 2);
        const Affine<double> map =
            angle == 0 ? Affine<double>{}
                       : compose(shift({3, 4, 5}), compose(turn(0, angle), stretched(1, 2, 0.5)));
        Stage s;
        s.scene.background = {0.25, 0.5, 0.75};
        // Index 1, so that no ray is bent and all end in the background; then glass.
        s.scene.width = s.scene.height = 2;
        s.scene.settings.max_depth = 40;
        const std::uint32_t m = s.glass(1);
        s.add(ball, m, map);
        for (int i = 0; i < 4000; ++i) {
            const auto& f = ball.faces[random() % ball.faces.size()];
            const double w = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.5 : unit(random);
            const Vec3d at =
                map_point(map, ball.vertices[f[0]] * (1 - w) + ball.vertices[f[1]] * w);
            const auto& g = ball.faces[random() % ball.faces.size()];
            Vec3d from = map_point(map, Vec3d(4 * unit(random) - 2, 4 * unit(random) - 2, 5));
            if (i % 4 == 0)
                from = at + (at - map_point(map, ball.vertices[g[0]])) * 3.0 + Vec3d(1e-300);
            if (length_squared(from - at) == 0) continue;
            s.look(from, at, 1e-8, normalize(Vec3d(0.3, 0.8, 0.1)));
            RayCounts counts;
            const Image image =
                compile(s.scene, s.scene.settings)->render({0, 2, 2, {}, false}, {}, counts);
            lost += counts.media_lost;
            odd += wrong(image, Color(0.25, 0.5, 0.75));
            s.scene.materials[m].ior = 1.5;
            compile(s.scene, s.scene.settings)->render({0, 2, 2, {}, false}, {}, counts);
            lost += counts.media_lost;
            s.scene.materials[m].ior = 1;
        }
    }
    EXPECT_EQ(lost, 0u);
    EXPECT_EQ(odd, 0);
}

TEST(Leaks, EveryCornerOfABodyIsCrossed) {
    // Rays at places where three faces of different parts of a body of glass meet.
    for (const unsigned seed : {3U, 47U}) {
        std::mt19937 random(seed);
        for (int i = 0; i < 300; ++i) {
            const Scene scene = random_corner(random, 16);
            RayCounts counts;
            compile(scene, scene.settings)
                ->render({0, scene.width, scene.height, {}, false}, {}, counts);
            EXPECT_EQ(counts.media_lost, 0U) << "picture " << i << " of seed " << seed;
        }
    }
}

TEST(Leaks, Needle) {
    // One triangle of height 10^-k, with the camera compressed in the same way: the picture is
    // always the same.
    const auto scene = [](int k, double angle) {
        const double f = power10(-k);
        const Affine<double> map = compose(turn(2, angle), stretched(1, f, 1));
        Stage s = dark();
        s.scene.background = {1, 1, 1};
        s.add(Triangle{{map_point(map, {-1, -0.3, 0}), map_point(map, {1.1, -0.2, 0}),
                        map_point(map, {0.05, 0.5, 0})}},
              black(s));
        s.scene.width = 96;
        s.scene.height = 64;
        return std::pair(s, map);
    };
    const auto hits = [&](int k, double angle) {
        auto [s, map] = scene(k, angle);
        std::vector<bool> hit;
        for (int i = 0; i < 400; ++i) {
            const Vec3d at((i % 20 - 9.7) / 9, (i / 20 - 9.4) / 18, 0);
            const Vec3d target = map_point(map, at);
            s.look(target + Vec3d(0, 0, 3), target, 1e-9);
            hit.push_back(
                compile(s.scene, s.scene.settings)->probe({0, 1, 1, {}, false}, 0.5, 0.5).object !=
                none);
        }
        return hit;
    };
    for (const double angle : {0.0, 40.0}) {
        const std::vector<bool> reference = hits(0, angle);
        for (int k = 1; k <= 12; ++k) EXPECT_EQ(hits(k, angle), reference) << k << " at " << angle;
    }
}

}  // namespace
}  // namespace lancer::extremes
