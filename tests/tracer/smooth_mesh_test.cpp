// Glass meshes with interpolated normals where the shading normal sends a ray to the wrong side of
// the facet for its kind: docs/shading.md, "Smooth meshes".
#include "tests/tracer/scene_kit.h"

namespace lancer {
namespace {

using namespace kit;

constexpr double exact = 1e-12;

/// Adds a tetrahedron whose first face, (a, b, c), has `normal` in all its corners; the others are
/// flat.
void add_tetrahedron(Mesh& mesh, const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                     const Vec3d& normal) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c, d});
    const auto normal_index = static_cast<std::uint32_t>(mesh.normals.size());
    mesh.normals.push_back(normal);
    mesh.faces.push_back({first, first + 1, first + 2});
    mesh.normal_faces.push_back({normal_index, normal_index, normal_index});
    for (const Mesh::Corners& corners :
         {Mesh::Corners{0, 3, 1}, Mesh::Corners{1, 3, 2}, Mesh::Corners{0, 2, 3}}) {
        mesh.faces.push_back({first + corners[0], first + corners[1], first + corners[2]});
        mesh.normal_faces.push_back({none, none, none});
    }
}

Scene scene_of(const Mesh& mesh, const Material& material) {
    Scene scene;
    scene.settings.min_contribution = 0;
    scene.settings.max_depth = 10;
    scene.meshes.push_back(std::make_shared<Mesh>(mesh));
    show(scene, MeshRef{0, true}, material);
    return scene;
}

/// The direction behind a level surface, z up: Snell's law by the sines.
Vec3d bent_at_level(const Vec3d& d, double ratio) {
    const double x = ratio * d.x;
    return {x, 0, -std::sqrt(1 - x * x)};
}

/// A ray that is refracted back to the side from which it came still counts as having entered. When
/// it meets another face of the mesh, now from outside, it is bent as if it left.
TEST(SmoothMesh, ARefractedRayHasCrossedWhateverTheFacetSays) {
    const Vec3d shading = normalize(Vec3d(-1, 0, 1));
    Mesh mesh;
    // The facet's plane is x = -0.1 z, seen from its front at a grazing angle.
    add_tetrahedron(mesh, {-0.1, -2, 1}, {0.1, 0, -1}, {-0.1, 2, 1}, {-3, 0, 0}, shading);
    if (cross(mesh.vertices[1] - mesh.vertices[0], mesh.vertices[2] - mesh.vertices[0]).x < 0)
        std::swap(mesh.faces[0][1], mesh.faces[0][2]);
    // Below, a level face at z = -2, body underneath.
    add_tetrahedron(mesh, {-50, -50, -2}, {50, -50, -2}, {0, 80, -2}, {0, 0, -300}, {0, 0, 1});

    // Straight down the z axis: 45 degrees to the shading normal.
    const double sine = std::sqrt(0.5) / 1.5;
    const double turned = std::asin(std::sqrt(0.5)) - std::asin(sine);
    const Vec3d first(std::sin(turned), 0, -std::cos(turned));
    ASSERT_GT(dot(first, Vec3d(1, 0, 0.1)), 0) << "back in front of the facet";
    const Vec3d place = (2 / -first.z) * first;
    const Vec3d second = bent_at_level(first, 1.5);  // as out of glass
    Scene scene = scene_of(mesh, clear(1.5));
    show(scene, Sphere{place + 3.0 * second, 1e-6}, glowing(Color(1)));
    EXPECT_COLOR_NEAR(seen(scene, {0, 0, 5}, {0, 0, 0}), Color(1), exact);
}

/// A body with a slanted top around the origin, which carries `normal`, and a level bottom at
/// z = -30.
Mesh slanted_block(const Vec3d& normal) {
    Mesh mesh;
    mesh.vertices = {{-20, -20, 10},  {20, -20, -10}, {0, 40, 0},
                     {-90, -90, -30}, {90, -90, -30}, {0, 90, -30}};
    mesh.normals = {normal};
    mesh.faces = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1},
                  {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}};
    mesh.normal_faces.assign(8, {none, none, none});
    mesh.normal_faces[0] = {0, 0, 0};
    return mesh;
}

/// A ray that is mirrored through the facet still counts as outside. When it leaves the body that
/// it is in, it is bent as if it entered.
TEST(SmoothMesh, AMirroredRayHasNotCrossedWhateverTheFacetSays) {
    const Vec3d shading = normalize(Vec3d(1, 0, 0.2));
    Material m = clear(1.5);
    m.transmission = 0.5;
    m.reflection = Color(1);
    const Vec3d down(0, 0, -1);
    const Vec3d first = down - 2 * dot(down, shading) * shading;
    ASSERT_LT(dot(first, Vec3d(0.5, 0, 1)), 0) << "through the facet";
    const Vec3d place = (30 / -first.z) * first;
    const Vec3d second = bent_at_level(first, 1 / 1.5);  // as into glass
    Scene scene = scene_of(slanted_block(shading), m);
    show(scene, Sphere{place + 5.0 * second, 1e-6}, glowing(Color(1)));
    // Mirrored in full, then half passes the lower face.
    EXPECT_COLOR_NEAR(seen(scene, {0, 0, 25}, {0, 0, 0}), Color(0.5), exact);
}

/// Absorption depends on the place: light that is mirrored into the body is dimmed on its way
/// there.
TEST(SmoothMesh, AbsorptionIsThatOfThePlace) {
    const Vec3d shading = normalize(Vec3d(1, 0, 0.2));
    Material m = clear(1);
    m.transmission = 0.5;
    m.absorption = Color(0.1);
    m.reflection = Color(1);
    const Vec3d down(0, 0, -1);
    const Vec3d first = down - 2 * dot(down, shading) * shading;
    Scene scene = scene_of(slanted_block(shading), m);
    show(scene, Sphere{4.0 * first, 1}, glowing(Color(1)));
    // What passes the facet goes straight on, past the ball.
    EXPECT_COLOR_NEAR(seen(scene, {0, 0, 25}, {0, 0, 0}), Color(std::exp(-0.1 * 3)), exact);
}

}  // namespace
}  // namespace lancer
