// Scenes for the tests of extremes, built in C++.
#pragma once

#include <string>

#include "model/scene.h"
#include "model/similar.h"

namespace lancer::extremes {

/// A part of a body: a shape, the material of its faces, its transform.
struct Part {
    Shape shape;
    std::uint32_t material = 0;
    Affine<double> map{};
};

/// A scene under construction: 128 x 96 pixels, one ray each, nothing cut.
class Stage {
  public:
    Stage();

    std::uint32_t material(const Material& m);
    std::uint32_t matt(const Color& color);
    std::uint32_t mirror();
    std::uint32_t glass(double ior, const Color& color = {1, 1, 1});
    Object& add(const Shape& shape, std::uint32_t material, const Affine<double>& map = {});
    Object& add(const Mesh& mesh, std::uint32_t material, const Affine<double>& map = {});
    /// One body made of these, whose inside is `material`.
    Object& add_body(Composite::Kind kind, const std::vector<Part>& parts, std::uint32_t material);
    void look(const Vec3d& from, const Vec3d& at, double fov, const Vec3d& up = {0, 1, 0});
    void look_parallel(const Vec3d& from, const Vec3d& at, double height,
                       const Vec3d& up = {0, 1, 0});
    void lamp(const Vec3d& position, const Color& color = {1, 1, 1});
    void sun(const Vec3d& direction, const Color& color = {1, 1, 1});

    Scene scene;
};

/// A plane with a sphere, mirror, box, cylinder, cone, mesh and glass, and two lamps. All
/// coordinates are multiples of 1/256.
Stage base_stage();

/// Icosahedron, its faces split in four `levels` times, on the sphere around `center`.
Mesh icosphere(const Vec3d& center, double radius, int levels);
Mesh cube(const Vec3d& min, const Vec3d& max);

/// The scene with `map` put on every object, camera and light as a group's transform would be.
Scene under(Scene scene, const Affine<double>& map);

/// Half as wide and as tall, for slow comparisons.
Scene half_size(Scene scene);

Affine<double> stretched(double x, double y, double z);
Affine<double> shift(const Vec3d& by);
/// About `axis` (0, 1, 2), degrees.
Affine<double> turn(int axis, double angle);

inline double power10(int k) {
    return std::stod("1e" + std::to_string(k));
}

}  // namespace lancer::extremes
