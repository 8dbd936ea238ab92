// Many small triangles in one mesh: POV-Ray stores their planes in single precision, and the
// exporter must make sure that this is not visible.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/judge/validate_fixture.h"
#include "tests/reference/pov/scene_kit.h"

namespace lancer::judge {
namespace {

Vec3d on_knot(double share) {
    const double a = tau * share;
    const double r = 1 + 0.45 * elementary::cos(3 * a);
    return {r * elementary::cos(2 * a), 0.45 * elementary::sin(3 * a), r * elementary::sin(2 * a)};
}

/// A torus knot as a tube of `along` rings of `around` corners, with the true normals.
std::shared_ptr<const Mesh> knot(std::uint32_t along, std::uint32_t around) {
    const auto mesh = std::make_shared<Mesh>();
    for (std::uint32_t j = 0; j < along; ++j) {
        const Vec3d center = on_knot(j / static_cast<double>(along));
        const Vec3d ahead = on_knot((j + 1e-4) / along) - on_knot((j - 1e-4) / along);
        const Vec3d u = normalize(cross(ahead, center));
        const Vec3d w = cross(normalize(ahead), u);
        for (std::uint32_t i = 0; i < around; ++i) {
            const double b = tau * i / around;
            const Vec3d normal = elementary::cos(b) * u + elementary::sin(b) * w;
            mesh->vertices.push_back(center + 0.18 * normal);
            mesh->normals.push_back(normal);
            const std::uint32_t next = (i + 1) % around;
            const std::uint32_t ring = j * around;
            const std::uint32_t beyond = (j + 1) % along * around;
            mesh->faces.push_back({ring + i, ring + next, beyond + next});
            mesh->faces.push_back({ring + i, beyond + next, beyond + i});
        }
    }
    return mesh;
}

class FineMesh : public WithPovRay {};

TEST_F(FineMesh, AKnotOfFiftyThousandTrianglesAgrees) {
    Scene scene = empty_scene();
    scene.background = {0.1, 0.12, 0.2};
    scene.cameras[0].position = {0, 1.6, 2.9};
    scene.cameras[0].look_at = {0, 0, 0};
    scene.cameras[0].projection = PerspectiveProjection{50};
    scene.lights.clear();
    for (const Vec3d& place : {Vec3d(5.47241, 6.63479, -3.43449), Vec3d(-4.98154, 5.84849, 3.3597),
                               Vec3d(2.03676, 2.15696, 2.05944)})
        scene.lights.push_back({PointLight{place, {}}, {0.5, 0.5, 0.5}});
    scene.meshes.push_back(knot(500, 50));
    Material blue;
    blue.color = {0.3, 0.5, 0.9};
    blue.phong = 0.4;
    add_object(scene, MeshRef{0, true}, add_material(scene, blue));
    add_object(scene, Plane{{0, 1, 0}, -0.8});
    ValidationJob job;
    job.name = "knot";
    job.scene = std::make_shared<const Scene>(scene);
    job.view = {0, 1024, 1024};
    const Validation v = validate_scene(job, render_ours, find_povray(), {});
    EXPECT_EQ(v.verdict, Verdict::agrees) << said(v);
    EXPECT_EQ(v.judgement.different.size(), 0u) << "nothing to explain";
}

}  // namespace
}  // namespace lancer::judge
