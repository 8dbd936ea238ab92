#include "tests/reference/pov/pair_scenes.h"

#include <memory>

#include "model/io/image_file.h"

namespace lancer::reference {

namespace {

std::uint32_t add(Scene& scene, Material material, const std::string& name) {
    scene.materials.push_back(material);
    scene.material_names.resize(scene.materials.size());
    scene.material_names.back() = name;
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

std::uint32_t plain(Scene& scene, const std::string& name, Color color, double ambient,
                    double diffuse) {
    Material material;
    material.color = color;
    material.ambient = ambient;
    material.diffuse = diffuse;
    return add(scene, material, name);
}

Object& show(Scene& scene, Shape shape, std::uint32_t material) {
    Object object;
    object.shape = shape;
    object.material = material;
    return scene.objects.emplace_back(object);
}

void look(Scene& scene, Vec3d from, Vec3d at, double fov) {
    Camera camera;
    camera.name = "main";
    camera.position = from;
    camera.look_at = at;
    camera.projection = PerspectiveProjection{fov};
    scene.cameras = {camera};
    scene.width = 160;
    scene.height = 120;
    scene.settings.min_contribution = 0;
}

void point_light(Scene& scene, Vec3d position, Color color) {
    Light light;
    light.kind = PointLight{position, {}};
    light.color = color;
    scene.lights.push_back(light);
}

Affine<double> scale(double x, double y, double z) {
    return {{Vec3d(x, 0, 0), Vec3d(0, y, 0), Vec3d(0, 0, z)}, Vec3d(0.0)};
}

Affine<double> translate(double x, double y, double z) {
    Affine<double> map;
    map.shift = {x, y, z};
    return map;
}

Affine<double> rotate(std::size_t axis, double angle) {
    const auto [s, c] = elementary::sine_cosine_of_degrees(angle);
    switch (axis) {
        case 0:
            return {{Vec3d(1, 0, 0), Vec3d(0, c, -s), Vec3d(0, s, c)}, Vec3d(0.0)};
        case 1:
            return {{Vec3d(c, 0, s), Vec3d(0, 1, 0), Vec3d(-s, 0, c)}, Vec3d(0.0)};
        default:
            return {{Vec3d(c, -s, 0), Vec3d(s, c, 0), Vec3d(0, 0, 1)}, Vec3d(0.0)};
    }
}

/// Applied in the order written, as in a script.
template <class... Maps>
Affine<double> in_turn(const Affine<double>& first, const Maps&... more) {
    Affine<double> map = first;
    ((map = compose(more, map)), ...);
    return map;
}

std::uint32_t add(Scene& scene, const Affine<double>& transform) {
    scene.transforms.push_back(transform);
    return static_cast<std::uint32_t>(scene.transforms.size() - 1);
}

std::uint32_t add_motif(Scene& scene, bool srgb) {
    const Image image = io::read_image(LANCER_SOURCE_DIR "/tests/pairs/motif.png",
                                       srgb ? io::ColorSpace::automatic : io::ColorSpace::linear);
    scene.images.push_back({"motif.png", srgb, std::make_shared<const Image>(image)});
    return static_cast<std::uint32_t>(scene.images.size() - 1);
}

}  // namespace

Scene solids_scene() {
    Scene scene;
    look(scene, {0.7, 5.3, 9.1}, {0.13, 0.55, 0.1}, 38);
    scene.settings.max_depth = 4;
    scene.background = {0.05, 0.09, 0.17};
    point_light(scene, {-5.2, 9.3, 6.1}, {0.85, 0.82, 0.75});
    const auto ground = plain(scene, "ground", {0.55, 0.6, 0.5}, 0.15, 0.6);
    const auto red = plain(scene, "red", {0.9, 0.2, 0.15}, 0.2, 0.7);
    const auto blue = plain(scene, "blue", {0.2, 0.35, 0.9}, 0.2, 0.7);
    const auto sand = plain(scene, "sand", {0.9, 0.75, 0.3}, 0.2, 0.7);
    show(scene, Plane{{0, 2, 0}, -0.53}, ground);
    show(scene, Sphere{{-2.6, 0.55, 1.2}, 0.83}, red);
    show(scene, Box{{-1.35, -0.4, 1.3}, {-0.35, 0.47, 2.2}}, blue);
    show(scene, Cylinder{{0.35, -0.31, 2.1}, {0.75, 0.72, 1.7}, 0.47, true}, sand);
    show(scene, Cylinder{{2.1, -0.42, 1.7}, {2.1, 0.61, 1.7}, 0.66, false}, red);
    show(scene, Cone{{-2.3, -0.44, -1.4}, {-2.3, 1.73, -1.4}, 0.82, 0, true}, blue);
    show(scene, Cone{{-0.3, -0.41, -1.1}, {-0.1, 1.12, -1.2}, 0.79, 0.31, true}, sand);
    show(scene, Cone{{1.9, 1.12, -0.9}, {2.1, -0.37, -1.2}, 0.86, 0.4, false}, blue);
    show(scene, Triangle{{Vec3d(0.1, 0.9, 0.2), Vec3d(1.3, 0.75, -0.1), Vec3d(0.6, 1.85, -0.35)}},
         red);
    return scene;
}

Scene glass_nested_scene() {
    Scene scene;
    look(scene, {-0.5, 2.2, 7.6}, {0, 0.35, 0}, 34);
    scene.settings.max_depth = 14;
    scene.background = {0.3, 0.4, 0.55};
    point_light(scene, {3.9, 8.8, 5.1}, {0.65, 0.65, 0.6});
    scene.textures.push_back({Checker{{0.75, 0.75, 0.65}, {0.15, 0.2, 0.35}},
                              in_turn(scale(1.4, 1.4, 1.4), translate(0.11, 0.27, 0.05))});
    Material floor;
    floor.texture = 0;
    floor.ambient = 0.15;
    floor.diffuse = 0.6;
    Material crown;
    crown.color = {0.95, 1, 0.95};
    crown.ambient = 0;
    crown.diffuse = 0.1;
    crown.transmission = 0.7;
    crown.filter = 0.25;
    crown.ior = 1.5;
    crown.phong = 0.35;
    crown.shininess = 60;
    Material flint;
    flint.color = {1, 0.75, 0.5};
    flint.ambient = 0;
    flint.diffuse = 0.1;
    flint.transmission = 0.2;
    flint.filter = 0.75;
    flint.ior = 1.8;
    Material air;
    air.ambient = 0;
    air.diffuse = 0;
    air.transmission = 1;
    const auto floor_id = add(scene, floor, "floor");
    const auto crown_id = add(scene, crown, "crown");
    const auto flint_id = add(scene, flint, "flint");
    const auto air_id = add(scene, air, "air");
    const auto bead_id = plain(scene, "bead", {0.9, 0.2, 0.3}, 0.2, 0.6);
    show(scene, Plane{{0, 1, 0}, -1.05}, floor_id);
    show(scene, Sphere{{-1.3, 0.35, 0.2}, 1.2}, crown_id);
    show(scene, Sphere{{-1.72, 0.55, 0.45}, 0.42}, air_id);
    show(scene, Sphere{{-0.87, 0.15, 0.35}, 0.44}, flint_id);
    show(scene, Sphere{{-1.3, 1.13, 0.2}, 0.19}, bead_id);
    show(scene, Sphere{{1.35, 0.3, 0.3}, 1.15}, flint_id);
    show(scene, Sphere{{1.3, 0.25, 0.4}, 0.8}, crown_id);
    show(scene, Sphere{{1.42, 0.4, 0.5}, 0.45}, air_id);
    return scene;
}

Scene tex_planar_scene() {
    Scene scene;
    look(scene, {0.3, 1.9, 8.3}, {0.05, 0.35, 0}, 36);
    scene.settings.max_depth = 5;
    scene.background = {0.15, 0.2, 0.3};
    point_light(scene, {-2.6, 6.1, 7.9}, {0.7, 0.7, 0.7});
    const std::uint32_t srgb = add_motif(scene, true);
    const std::uint32_t linear = add_motif(scene, false);
    using Image = ImageTexture;
    constexpr auto planar = Image::Mapping::planar;
    const auto nearest = Image::Filter::nearest;
    const auto bilinear = Image::Filter::bilinear;
    const auto repeat = Image::Wrap::repeat;
    const auto once = Image::Wrap::once;
    scene.textures = {{Image{srgb, planar, nearest, repeat},
                       in_turn(scale(1.37, 0.91, 1), translate(0.13, 0.07, 0))},
                      {Image{srgb, planar, bilinear, repeat},
                       in_turn(rotate(2, 24), scale(1.43, 1.43, 1.43), translate(0.31, -0.2, 0))},
                      {Image{srgb, planar, nearest, once},
                       in_turn(translate(-0.5, -0.5, 0), scale(1.63, 1.21, 1))},
                      {Image{linear, planar, bilinear, once},
                       in_turn(translate(-0.47, -0.52, 0), scale(1.7, 1.7, 1.7))},
                      {Image{srgb, planar, bilinear, repeat},
                       in_turn(rotate(0, -90), scale(2.6, 2.6, 2.6), translate(0.4, 0, 0.3))}};
    std::vector<std::uint32_t> materials;
    for (std::uint32_t i = 0; i < 5; ++i) {
        Material material;
        material.texture = i;
        material.ambient = 0.2;
        material.diffuse = i == 4 ? 0.5 : 0.7;
        material.reflection = Color(i == 4 ? 0.1 : 0.0);
        materials.push_back(add(scene, material, std::string("m") + "abcde"[i]));
    }
    show(scene, Plane{{0, 1, 0}, -0.83}, materials[4]);
    show(scene, Box{{-0.8, -0.7, -0.5}, {0.8, 0.9, 0.5}}, materials[0]).transform =
        add(scene, in_turn(rotate(1, 24), scale(0.9, 0.9, 0.9), translate(-2.1, 0.05, 0.3)));
    show(scene, Sphere{{0, 0, 0}, 0.75}, materials[1]).transform =
        add(scene, in_turn(rotate(2, 30), translate(-0.35, 0.1, 0.7)));
    Mesh front;
    front.vertices = {{-1, -0.8, 0}, {1, -0.8, 0}, {1, 0.85, 0}, {-1, 0.85, 0}};
    front.faces = {{0, 1, 2}, {0, 2, 3}};
    Mesh back;
    back.vertices = {{-1, -0.95, 0}, {1.1, -0.9, 0}, {1.1, 1, 0}, {-1.1, 1, 0}};
    back.faces = front.faces;
    scene.meshes = {std::make_shared<Mesh>(front), std::make_shared<Mesh>(back)};
    show(scene, MeshRef{0, false}, materials[2]).transform =
        add(scene, in_turn(rotate(1, -12), translate(1.55, 0.35, 0.9)));
    show(scene, MeshRef{1, false}, materials[3]).transform = add(scene, translate(0.6, 1.1, -1.6));
    return scene;
}

}  // namespace lancer::reference
