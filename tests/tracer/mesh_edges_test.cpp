// Rays that meet a glass mesh exactly at an edge or a corner: whichever face they take, each must
// find its way out.
#include <random>

#include "tests/tracer/scene_kit.h"

namespace lancer {
namespace {

using namespace kit;

/// A body whose faces are triangles.
Mesh solid_of(const std::vector<Vec3d>& vertices, const std::vector<Mesh::Corners>& faces) {
    Mesh mesh;
    mesh.vertices = vertices;
    mesh.faces = faces;
    return mesh;
}

/// A triangular prism along z: the right angle of its section is at (1, 1).
Mesh right_prism() {
    return solid_of(
        {{-1, 1, -4}, {1, 1, -4}, {1, -1, -4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}},
        {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {0, 2, 5}, {0, 5, 3}});
}

Mesh cube() {
    return solid_of({{-1, -1, -1},
                     {1, -1, -1},
                     {1, 1, -1},
                     {-1, 1, -1},
                     {-1, -1, 1},
                     {1, -1, 1},
                     {1, 1, 1},
                     {-1, 1, 1}},
                    {{0, 2, 1},
                     {0, 3, 2},
                     {4, 5, 6},
                     {4, 6, 7},
                     {0, 1, 5},
                     {0, 5, 4},
                     {2, 3, 7},
                     {2, 7, 6},
                     {0, 4, 7},
                     {0, 7, 3},
                     {1, 2, 6},
                     {1, 6, 5}});
}

/// Thin and sharp.
Mesh splinter() {
    return solid_of({{0, 0, 0}, {3, 0, 0}, {0, 0.25, 0}, {0.5, 0, 2}},
                    {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

/// A prism along z with an L-shaped section: its edge at the origin is concave.
Mesh notched_prism() {
    const double outline[6][2] = {{0, 0}, {2, 0}, {2, -2}, {-2, -2}, {-2, 2}, {0, 2}};
    std::vector<Vec3d> vertices;
    for (const double z : {-3.0, 3.0})
        for (const auto& p : outline) vertices.push_back({p[0], p[1], z});
    std::vector<Mesh::Corners> faces{{0, 1, 2}, {0, 2, 3}, {0, 3, 4},  {0, 4, 5},
                                     {6, 8, 7}, {6, 9, 8}, {6, 10, 9}, {6, 11, 10}};
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t j = (i + 1) % 6;
        faces.push_back({i, i + 6, j + 6});
        faces.push_back({i, j + 6, j});
    }
    return solid_of(vertices, faces);
}

std::uint64_t lost(const Mesh& mesh, const Affine<double>& map, double ior, bool fresnel,
                   const Vec3d& from, const Vec3d& at) {
    Scene scene;
    scene.background = Color(1);
    scene.settings.min_contribution = 0;
    scene.settings.max_depth = 8;
    scene.settings.threads = 1;
    scene.meshes.push_back(std::make_shared<Mesh>(mesh));
    Material m = clear(ior);
    m.fresnel = fresnel;
    m.reflection = Color(fresnel ? 1 : 0);
    show(scene, MeshRef{0, false}, m, map);
    scene.cameras = {camera_along(map_point(map, from), map_point(map, at))};
    RayCounts counts;
    picture(scene, 1, 1, &counts);
    return counts.media_lost;
}

/// In the section, a ray from (-0.5, 0.25) to the edge at (1, 1) meets both faces beyond the
/// critical angle and returns the way it came.
TEST(MeshEdge, TotalReflectionInARightAngleTurnsTheRayBack) {
    Scene scene;
    scene.settings.min_contribution = 0;
    scene.settings.max_depth = 8;
    scene.meshes.push_back(std::make_shared<Mesh>(right_prism()));
    show(scene, MeshRef{0, false}, clear(1.5));
    // Straight through the long face, on to the edge.
    for (const double z : {0.0, 0.125, 1.0 / 3}) {
        const Vec3d from(-3, -3, z);
        show(scene, Sphere{from - Vec3d(1, 1, 0), 0.5}, glowing({1, 0.5, 0.25}));
        EXPECT_COLOR_NEAR(seen(scene, from, {1, 1, z}), Color(1, 0.5, 0.25), 1e-12);
        scene.objects.pop_back();
    }
}

/// How many rays lose a crossing, of those aimed at edges and corners of random bodies.
///
/// \param beside  aims beside the edge, by 10^-12 to 10^-14
int lost_of(int rounds, bool beside, std::uint32_t seed) {
    const std::vector<Mesh> meshes{right_prism(), cube(), splinter(), notched_prism()};
    std::mt19937 random(seed);
    const auto below = [&](std::size_t n) { return random() % n; };
    const auto coordinate = [&] { return static_cast<double>(random()) / 4294967296.0 * 16 - 8; };
    int count = 0;
    for (int round = 0; round < rounds; ++round) {
        const Mesh& mesh = meshes[below(meshes.size())];
        const Mesh::Corners& face = mesh.faces[below(mesh.faces.size())];
        const std::size_t side = below(3);
        const Vec3d& a = mesh.vertices[face[side]];
        const Vec3d& b = mesh.vertices[face[(side + 1) % 3]];
        Vec3d at = a + (static_cast<double>(below(16)) / 16) * (b - a);  // 0 is a corner
        if (beside) {
            const double size = std::pow(10.0, -12.5 - static_cast<double>(below(4)) * 0.5);
            const double x = coordinate();
            const double y = coordinate();
            at = at + size * Vec3d(x, y, coordinate());
        }
        const double x = coordinate();
        const double y = coordinate();
        const Vec3d from(x, y, coordinate());
        const double index = std::vector<double>{1.25, 1.5, 2, 0.75}[below(4)];
        const Affine<double> map =
            in_turn(turn_x(17.0 * static_cast<double>(below(4))),
                    stretched(1, below(2) ? 1 : -3, 1), shift(0.3, 0, below(2) ? 0 : 1e3));
        if (lost(mesh, map, index, below(2) == 0, from, at) != 0) ++count;
    }
    return count;
}

/// Convex and concave edges and corners; when rotated, rays hit them as closely as rounding allows.
TEST(MeshEdge, NoCrossingIsLostAtEdgesAndCorners) {
    EXPECT_EQ(lost_of(4000, false, 3), 0);
}

/// Where a ray meets a face at a small angle, its start may lie as far as this from the true place.
TEST(MeshEdge, NoCrossingIsLostBesideEdges) {
    EXPECT_EQ(lost_of(20000, true, 5), 0);
}

}  // namespace
}  // namespace lancer
