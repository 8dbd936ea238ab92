#include "tests/bench/accuracy/tachyon.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "model/io/file.h"
#include "model/io/temporary_file.h"
#include "reference/povray/process.h"

namespace lancer::bench {
namespace {

std::string vector(const Vec3d& v) {
    return fmt::format("{} {} {}", v.x, v.y, v.z);
}

struct ShapeWriter {
    const Scene& scene;
    std::string material;
    std::string& out;

    void line(const std::string& words) const { out += words + " " + material + "\n"; }
    void operator()(const Sphere& s) const {
        line(fmt::format("SPHERE CENTER {} RAD {}", vector(s.center), s.radius));
    }
    void operator()(const Box& b) const {
        line(fmt::format("BOX MIN {} MAX {}", vector(b.min), vector(b.max)));
    }
    void operator()(const Cylinder& c) const {
        line(fmt::format("FCYLINDER BASE {} APEX {} RAD {}", vector(c.base), vector(c.top),
                         c.radius));
        if (!c.capped) return;
        const Vec3d axis = normalize(c.top - c.base);
        for (const auto& [at, normal] : {std::pair{c.base, -axis}, {c.top, axis}})
            line(fmt::format("RING CENTER {} NORMAL {} INNER 0 OUTER {}", vector(at),
                             vector(normal), c.radius));
    }
    void operator()(const Cone&) const {}
    void operator()(const Torus&) const {}
    void operator()(const Plane& p) const {
        const Vec3d n = normalize(p.normal);
        line(fmt::format("PLANE CENTER {} NORMAL {}", vector(n * p.offset), vector(n)));
    }
    void operator()(const Triangle& t) const { triangle(t.points[0], t.points[1], t.points[2]); }
    void operator()(const MeshRef& ref) const {
        const Mesh& mesh = *scene.meshes[ref.mesh];
        for (const Mesh::Corners& f : mesh.faces)
            triangle(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]);
    }
    void operator()(const PatchRef&) const {}
    void operator()(const LatheRef&) const {}
    void operator()(const PrismRef&) const {}
    void operator()(const CompositeRef&) const {}
    void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
        line(fmt::format("TRI V0 {} V1 {} V2 {}", vector(a), vector(b), vector(c)));
    }
};

void write_camera(const Camera& camera, std::string& out) {
    const bool parallel = std::holds_alternative<OrthographicProjection>(camera.projection);
    // ZOOM z shows 2/z in height at distance 1, or in the scene's unit for parallel rays.
    const double zoom =
        parallel
            ? 2 / std::get<OrthographicProjection>(camera.projection).height
            : 1 / std::tan(radians(std::get<PerspectiveProjection>(camera.projection).fov / 2));
    out += fmt::format(
        "CAMERA PROJECTION {} ZOOM {} ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 12\n"
        "CENTER {} VIEWDIR {} UPDIR {}\nEND_CAMERA\n",
        parallel ? "ORTHOGRAPHIC" : "PERSPECTIVE", zoom, vector(camera.position),
        vector(normalize(camera.look_at - camera.position)), vector(camera.up));
}

void write_light(const Scene& scene, const Light& light, std::string& out) {
    // Zero radius would be no light; its size does not matter but for being seen.
    const double size = 1e-9 * length(scene.cameras[0].look_at - scene.cameras[0].position);
    if (const auto* point = std::get_if<PointLight>(&light.kind))
        out += fmt::format("LIGHT CENTER {} RAD {} COLOR {}\n", vector(point->position), size,
                           vector(light.color));
    if (const auto* sun = std::get_if<DirectionalLight>(&light.kind))
        out += fmt::format("DIRECTIONAL_LIGHT DIRECTION {} COLOR {}\n",
                           vector(normalize(sun->direction)), vector(light.color));
}

/// PPM with two bytes a value, the larger first.
std::optional<Image> read_ppm48(const std::string& bytes) {
    std::istringstream in(bytes);
    std::string magic;
    int width = 0;
    int height = 0;
    int most = 0;
    in >> magic >> width >> height >> most;
    in.get();
    if (magic != "P6" || most != 65535 || width < 1 || height < 1) return std::nullopt;
    Image image(width, height);
    for (double& value : image.data) {
        const int high = in.get();
        const int low = in.get();
        if (low < 0) return std::nullopt;
        value = (high * 256 + low) / 65535.0;
    }
    return image;
}

}  // namespace

std::string tachyon_scene(const Scene& scene) {
    std::string out = fmt::format("BEGIN_SCENE\nRESOLUTION {} {}\n", scene.width, scene.height);
    write_camera(scene.cameras[0], out);
    out += fmt::format("BACKGROUND {}\n", vector(scene.background));
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& m = scene.materials[i];
        out += fmt::format(
            "TEXDEF m{} AMBIENT {} DIFFUSE {} SPECULAR {} OPACITY 1 COLOR {} TEXFUNC 0\n", i,
            m.ambient * max_component(scene.ambient), m.diffuse, m.reflection.x, vector(m.color));
    }
    for (const Light& light : scene.lights) write_light(scene, light, out);
    for (const Object& object : scene.objects) {
        const Material& m = scene.materials[object.material];
        if (object.transform != 0 || m.filter + m.transmission > 0) continue;
        std::visit(ShapeWriter{scene, fmt::format("m{}", object.material), out}, object.shape);
    }
    return out + "END_SCENE\n";
}

std::optional<Image> run_tachyon(const std::string& program, const Scene& scene) {
    const io::TemporaryFolder folder;
    std::ofstream(folder.path() / "scene.dat") << tachyon_scene(scene);
    const reference::ProcessResult result = reference::run_process(
        {program, "scene.dat", "-format", "PPM48", "-o", "scene.ppm", "-numthreads", "1"},
        folder.path(), 60);
    std::error_code ignored;
    if (result.exit_code != 0 || !std::filesystem::exists(folder.path() / "scene.ppm", ignored))
        return std::nullopt;
    return read_ppm48(io::read_file((folder.path() / "scene.ppm").string()));
}

std::string find_tachyon() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::error_code ignored;
        const std::filesystem::path program = std::filesystem::path(folder) / "tachyon";
        if (std::filesystem::is_regular_file(program, ignored)) return program.string();
    }
    return "";
}

}  // namespace lancer::bench
