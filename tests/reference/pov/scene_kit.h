// Small scenes for the exporter's tests.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/scene.h"

namespace lancer::reference {

/// A scene with one camera at (0, 0.6, 6) looking at the origin, one lamp, and nothing in it.
inline Scene empty_scene() {
    Scene scene;
    Camera camera;
    camera.position = {0, 0.6, 6};
    camera.look_at = {0, 0, 0};
    camera.projection = PerspectiveProjection{30};
    scene.cameras = {camera};
    scene.background = {0.1, 0.15, 0.2};
    Light light;
    light.kind = PointLight{{4, 6, 5}, {}};
    light.color = {0.7, 0.7, 0.7};
    scene.lights = {light};
    scene.settings.min_contribution = 0;
    return scene;
}

inline std::uint32_t add_material(Scene& scene, const Material& material) {
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

inline std::uint32_t add_transform(Scene& scene, const Affine<double>& transform) {
    scene.transforms.push_back(transform);
    return static_cast<std::uint32_t>(scene.transforms.size() - 1);
}

inline Object& add_object(Scene& scene, const Shape& shape, std::uint32_t material = 0) {
    Object object;
    object.shape = shape;
    object.material = material;
    object.place = {0, static_cast<std::uint32_t>(scene.objects.size()), 1};
    return scene.objects.emplace_back(object);
}

inline std::uint32_t add_texture(Scene& scene, const Texture& texture) {
    scene.textures.push_back(texture);
    Material material;
    material.texture = static_cast<std::uint32_t>(scene.textures.size() - 1);
    material.ambient = 0.3;
    return add_material(scene, material);
}

/// One composite with two parts of the same material.
inline Object& add_composite(Scene& scene, Composite::Kind kind, const Shape& first,
                             const Shape& second, std::uint32_t material = 0,
                             std::uint32_t transform = 0) {
    Composite made;
    made.nodes = {{kind, {}, 0, 2}};
    for (const Shape& shape : {first, second}) {
        Composite::Leaf leaf;
        leaf.object.shape = shape;
        leaf.object.material = material;
        leaf.object.transform = leaf.texture_space = transform;
        leaf.place = {0, made.leaves.empty()};
        made.leaves.push_back(leaf);
    }
    scene.composites.push_back(made);
    return add_object(scene, CompositeRef{static_cast<std::uint32_t>(scene.composites.size() - 1)},
                      material);
}

/// A smooth picture of 7 x 5 pixels, exact in 8 bits; with alpha on demand.
inline std::uint32_t add_image(Scene& scene, bool alpha = false) {
    auto image = std::make_shared<Image>(7, 5, alpha ? 4 : 3);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x) {
            double* p = image->pixel(x, y);
            p[0] = (20 + 30 * x) / 255.0;
            p[1] = (40 + 40 * y) / 255.0;
            p[2] = (200 - 20 * x - 10 * y) / 255.0;
            if (alpha) p[3] = (55 + 50 * y) / 255.0;
        }
    scene.images.push_back({"made.png", false, image});
    return static_cast<std::uint32_t>(scene.images.size() - 1);
}

/// One shape of each kind, each about 1 in size round the origin.
inline std::vector<Shape> all_shapes(Scene& scene) {
    Mesh tetrahedron;
    tetrahedron.vertices = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    tetrahedron.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    tetrahedron.uvs = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    Mesh open = tetrahedron;
    open.faces.pop_back();
    open.uvs.clear();
    scene.meshes.push_back(std::make_shared<Mesh>(tetrahedron));
    scene.meshes.push_back(std::make_shared<Mesh>(open));
    Mesh shifted = tetrahedron;
    for (Vec3d& v : shifted.vertices) v.y -= 10;
    scene.meshes.push_back(std::make_shared<Mesh>(shifted));
    const auto mesh = static_cast<std::uint32_t>(scene.meshes.size() - 3);
    TriangleAttributes attributes;
    attributes.normals = {Vec3d(0, 0, 1), Vec3d(0.3, 0, 1), Vec3d(0, 0.3, 1)};
    attributes.uvs = {Vec2d(0, 0), Vec2d(1, 0), Vec2d(0.5, 1)};
    scene.triangle_attributes.push_back(attributes);
    const auto attribute = static_cast<std::uint32_t>(scene.triangle_attributes.size() - 1);
    const std::array<Vec3d, 3> corners{Vec3d(-1, -1, 0), Vec3d(1, -1, 0.2), Vec3d(0, 1, 0)};
    std::vector<Shape> shapes{
        Sphere{{0.1, 0, 0}, 0.9},
        Box{{-0.7, -0.6, -0.8}, {0.7, 0.5, 0.8}},
        Cylinder{{0, -0.8, 0}, {0.2, 0.8, 0.1}, 0.6, true},
        Cylinder{{0, -0.8, 0}, {0.2, 0.8, 0.1}, 0.6, false},
        Cone{{0, -0.8, 0}, {0, 0.8, 0}, 0.7, 0, true},
        Cone{{0, -0.8, 0}, {0, 0.8, 0}, 0.7, 0.3, true},
        Cone{{0, -0.8, 0}, {0, 0.8, 0}, 0.3, 0.7, false},
        Cone{{0, -0.8, 0}, {0, 0.8, 0}, 0.5, 0.5, true},
        Plane{{0, 1, 0.2}, -1},
        Triangle{corners, none},
        Triangle{corners, attribute},
        MeshRef{mesh, true},
        MeshRef{mesh, false},
        MeshRef{mesh + 1, true},
        MeshRef{mesh + 2, true},
    };
    Patch patch;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            patch.control.push_back({-0.9 + 0.6 * j, -0.9 + 0.6 * i, 0.3 * ((i + j) % 3)});
    scene.patches.push_back(patch);
    Patch net;
    net.basis = Patch::Basis::bspline;
    net.rows = 5;
    net.columns = 6;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 6; ++j)
            net.control.push_back({-1.5 + 0.6 * j, -1.2 + 0.6 * i, 0.2 * ((i * j) % 3)});
    scene.patches.push_back(net);
    shapes.push_back(PatchRef{static_cast<std::uint32_t>(scene.patches.size() - 2)});
    shapes.push_back(PatchRef{static_cast<std::uint32_t>(scene.patches.size() - 1)});
    const std::vector<std::pair<Spline, std::vector<Vec2d>>> profiles{
        {Spline::linear, {{0, -0.8}, {0.7, -0.5}, {0.4, 0.2}, {0, 0.8}}},
        {Spline::bezier,
         {{0, -0.8}, {0.9, -0.8}, {0.9, 0}, {0.5, 0.2}, {0.2, 0.4}, {0.2, 0.8}, {0, 0.8}}},
        {Spline::bspline, {{0.4, -1.2}, {0.8, -0.8}, {0.3, 0}, {0.7, 0.6}, {0.4, 0.9}}},
        {Spline::catmull_rom, {{0.4, -1.2}, {0.8, -0.8}, {0.3, 0}, {0.7, 0.6}, {0.4, 0.9}}}};
    for (const auto& [spline, profile] : profiles) {
        scene.lathes.push_back({profile, spline, {}});
        shapes.push_back(LatheRef{static_cast<std::uint32_t>(scene.lathes.size() - 1)});
    }
    const std::vector<Vec2d> outline{{-0.8, -0.6}, {0.1, -0.9}, {0.8, -0.4},
                                     {0.7, 0.5},   {0, 0.8},    {-0.7, 0.6}};
    for (const Spline spline :
         {Spline::linear, Spline::bezier, Spline::bspline, Spline::catmull_rom}) {
        scene.prisms.push_back({outline, spline, -0.6, 0.6, spline != Spline::bspline, {}});
        shapes.push_back(PrismRef{static_cast<std::uint32_t>(scene.prisms.size() - 1)});
    }
    return shapes;
}

}  // namespace lancer::reference
