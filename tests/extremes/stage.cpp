#include "tests/extremes/stage.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lancer::extremes {

Stage::Stage() {
    scene.width = 128;
    scene.height = 96;
    scene.settings.min_contribution = 0;
    scene.settings.max_depth = 12;
    scene.settings.threads = 1;
}

std::uint32_t Stage::material(const Material& m) {
    scene.materials.push_back(m);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}
std::uint32_t Stage::matt(const Color& color) {
    Material m;
    m.color = color;
    return material(m);
}
std::uint32_t Stage::mirror() {
    Material m;
    m.color = {0.5, 0.5, 0.5};
    m.ambient = 0;
    m.diffuse = 0.1;
    m.reflection = Color(0.8);
    return material(m);
}
std::uint32_t Stage::glass(double ior, const Color& color) {
    Material m;
    m.color = color;
    m.ambient = 0;
    m.diffuse = 0;
    m.filter = 1;
    m.ior = ior;
    return material(m);
}

Object& Stage::add(const Shape& shape, std::uint32_t material, const Affine<double>& map) {
    Object object;
    object.shape = shape;
    object.material = material;
    if (map != Affine<double>{}) {
        object.transform = static_cast<std::uint32_t>(scene.transforms.size());
        scene.transforms.push_back(map);
    }
    return scene.objects.emplace_back(object);
}
Object& Stage::add(const Mesh& mesh, std::uint32_t material, const Affine<double>& map) {
    scene.meshes.push_back(std::make_shared<Mesh>(mesh));
    return add(MeshRef{static_cast<std::uint32_t>(scene.meshes.size() - 1), false}, material, map);
}

Object& Stage::add_body(Composite::Kind kind, const std::vector<Part>& parts,
                        std::uint32_t material) {
    Composite made;
    made.nodes.push_back({kind, {}, 0, static_cast<std::uint32_t>(parts.size())});
    for (const Part& part : parts) {
        Composite::Leaf leaf;
        leaf.object = add(part.shape, part.material, part.map);
        scene.objects.pop_back();
        leaf.texture_space = leaf.object.transform;
        leaf.place = {0, made.leaves.empty()};
        made.leaves.push_back(leaf);
    }
    scene.composites.push_back(made);
    return add(CompositeRef{static_cast<std::uint32_t>(scene.composites.size() - 1)}, material);
}

void Stage::look(const Vec3d& from, const Vec3d& at, double fov, const Vec3d& up) {
    Camera camera;
    camera.position = from;
    camera.look_at = at;
    camera.up = up;
    camera.projection = PerspectiveProjection{fov};
    scene.cameras = {camera};
}
void Stage::look_parallel(const Vec3d& from, const Vec3d& at, double height, const Vec3d& up) {
    look(from, at, 1, up);
    scene.cameras[0].projection = OrthographicProjection{height};
}
void Stage::lamp(const Vec3d& position, const Color& color) {
    Light light;
    light.kind = PointLight{position, {}};
    light.color = color;
    scene.lights.push_back(light);
}
void Stage::sun(const Vec3d& direction, const Color& color) {
    Light light;
    light.kind = DirectionalLight{direction};
    light.color = color;
    scene.lights.push_back(light);
}

Stage base_stage() {
    Stage s;
    s.look({0.5, 2.75, 6.25}, {0, 0.75, 0}, 45);
    s.lamp({4, 6, 3}, {0.7, 0.7, 0.7});
    s.lamp({-5, 5, 4.5}, {0.3, 0.3, 0.4});
    s.scene.background = {0.1, 0.2, 0.4};
    s.add(Plane{{0, 1, 0}, 0}, s.matt({0.9, 0.9, 0.8}));
    s.add(Sphere{{-2.25, 0.75, 0}, 0.75}, s.matt({0.9, 0.2, 0.1}));
    s.add(Sphere{{0, 1, -1.75}, 1}, s.mirror());
    s.add(Box{{1.5, 0, -0.5}, {2.5, 1.25, 0.5}}, s.matt({0.2, 0.8, 0.2}));
    s.add(Cylinder{{-1, 0, 1.5}, {-1, 0.75, 1.75}, 0.375}, s.matt({0.3, 0.3, 0.9}));
    s.add(Cone{{0.75, 0, 1.5}, {0.75, 1, 1.5}, 0.5, 0}, s.matt({0.9, 0.8, 0.1}));
    s.add(icosphere({2.25, 0.5, 2}, 0.5, 1), s.matt({0.7, 0.2, 0.7}));
    s.add(Sphere{{0, 0.625, 0.5}, 0.5}, s.glass(1.5));
    return s;
}

Mesh cube(const Vec3d& min, const Vec3d& max) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back({(i & 1) != 0 ? max.x : min.x, (i & 2) != 0 ? max.y : min.y,
                                 (i & 4) != 0 ? max.z : min.z});
    }
    mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

Mesh icosphere(const Vec3d& center, double radius, int levels) {
    Mesh mesh;
    const double g = (1 + std::sqrt(5.0)) / 2;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.faces = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                  {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                  {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                  {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
        const auto between = [&](std::uint32_t a, std::uint32_t b) {
            const auto [it, fresh] = middle.try_emplace(
                {std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(mesh.vertices.size()));
            if (fresh)
                mesh.vertices.push_back(normalize(mesh.vertices[a] + mesh.vertices[b]) *
                                        std::sqrt(1 + g * g));
            return it->second;
        };
        std::vector<Mesh::Corners> finer;
        for (const Mesh::Corners& f : mesh.faces) {
            const std::uint32_t ab = between(f[0], f[1]);
            const std::uint32_t bc = between(f[1], f[2]);
            const std::uint32_t ca = between(f[2], f[0]);
            finer.insert(finer.end(),
                         {{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}});
        }
        mesh.faces = std::move(finer);
    }
    // Multiples of 2^-12 of the radius: translation then loses nothing.
    for (Vec3d& v : mesh.vertices) {
        v = normalize(v);
        for (int i = 0; i < 3; ++i) v[i] = std::round(v[i] * 256) / 256;
        v = center + radius * v;
    }
    return mesh;
}

Scene under(Scene scene, const Affine<double>& map) {
    const auto put = [&](const Vec3d& p) { return map_point(map, p); };
    for (Object& o : scene.objects) {
        const Affine<double> own = scene.transforms[o.transform];
        o.transform = static_cast<std::uint32_t>(scene.transforms.size());
        scene.transforms.push_back(compose(map, own));
    }
    for (Camera& c : scene.cameras) {
        c.position = put(c.position);
        c.look_at = put(c.look_at);
        c.up = map_vector(map, c.up);
        const double size = std::cbrt(std::abs(determinant(map)));
        if (auto* o = std::get_if<OrthographicProjection>(&c.projection)) o->height *= size;
    }
    for (Light& light : scene.lights) {
        if (auto* p = std::get_if<PointLight>(&light.kind)) p->position = put(p->position);
        if (auto* d = std::get_if<DirectionalLight>(&light.kind))
            d->direction = map_vector(map, d->direction);
    }
    return scene;
}

Scene half_size(Scene scene) {
    scene.width /= 2;
    scene.height /= 2;
    return scene;
}

Affine<double> stretched(double x, double y, double z) {
    return {{Vec3d(x, 0, 0), Vec3d(0, y, 0), Vec3d(0, 0, z)}, Vec3d(0.0)};
}
Affine<double> shift(const Vec3d& by) {
    Affine<double> m;
    m.shift = by;
    return m;
}
Affine<double> turn(int axis, double angle) {
    const auto [s, c] = elementary::sine_cosine_of_degrees(angle);
    if (axis == 0) return {{Vec3d(1, 0, 0), Vec3d(0, c, -s), Vec3d(0, s, c)}, Vec3d(0.0)};
    if (axis == 1) return {{Vec3d(c, 0, s), Vec3d(0, 1, 0), Vec3d(-s, 0, c)}, Vec3d(0.0)};
    return {{Vec3d(c, -s, 0), Vec3d(s, c, 0), Vec3d(0, 0, 1)}, Vec3d(0.0)};
}

}  // namespace lancer::extremes
