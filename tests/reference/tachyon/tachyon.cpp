#include "tests/reference/tachyon/tachyon.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "model/io/file.h"
#include "model/io/temporary_file.h"
#include "reference/povray/process.h"

namespace lancer {
namespace {

std::string vector(const Vec3d& v) {
    return fmt::format("{} {} {}", v.x, v.y, v.z);
}

Vec3d mirrored(const Vec3d& v) {
    return {-v.x, v.y, v.z};
}

/// A place or a direction in Tachyon's space.
std::string place(const Vec3d& v) {
    return vector(mirrored(v));
}

/// Writes a shape; false where there is no word for it.
struct ShapeWriter {
    const Scene& scene;
    std::string material;
    std::string& out;

    bool line(const std::string& words) const {
        out += words + " " + material + "\n";
        return true;
    }
    bool operator()(const Sphere& s) const {
        return line(fmt::format("SPHERE CENTER {} RAD {}", place(s.center), s.radius));
    }
    bool operator()(const Box& b) const {
        return line(fmt::format("BOX MIN {} MAX {}", vector({-b.max.x, b.min.y, b.min.z}),
                                vector({-b.min.x, b.max.y, b.max.z})));
    }
    bool operator()(const Cylinder& c) const {
        line(
            fmt::format("FCYLINDER BASE {} APEX {} RAD {}", place(c.base), place(c.top), c.radius));
        if (!c.capped) return true;
        const Vec3d axis = normalize(c.top - c.base);
        for (const auto& [at, normal] : {std::pair{c.base, -axis}, {c.top, axis}})
            line(fmt::format("RING CENTER {} NORMAL {} INNER 0 OUTER {}", place(at), place(normal),
                             c.radius));
        return true;
    }
    bool operator()(const Plane& p) const {
        const Vec3d n = normalize(p.normal);
        return line(fmt::format("PLANE CENTER {} NORMAL {}", place(n * p.offset), place(n)));
    }
    bool operator()(const Triangle& t) const {
        if (t.attributes != none && scene.triangle_attributes[t.attributes].normals) {
            const auto& n = *scene.triangle_attributes[t.attributes].normals;
            return smooth_triangle({t.points[0], t.points[1], t.points[2]}, {n[0], n[1], n[2]});
        }
        return triangle(t.points[0], t.points[1], t.points[2]);
    }
    bool operator()(const MeshRef& ref) const {
        const Mesh& mesh = *scene.meshes[ref.mesh];
        const auto& corners = mesh.normal_faces.empty() ? mesh.faces : mesh.normal_faces;
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
            const Mesh::Corners& f = mesh.faces[i];
            const Mesh::Corners& n = corners[i];
            const bool flat =
                !ref.smooth || mesh.normals.empty() || n[0] == none || n[1] == none || n[2] == none;
            if (flat) {
                triangle(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]);
            } else {
                smooth_triangle({mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]},
                                {mesh.normals[n[0]], mesh.normals[n[1]], mesh.normals[n[2]]});
            }
        }
        return true;
    }
    template <class Other>
    bool operator()(const Other&) const {
        return false;
    }
    bool triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
        return line(fmt::format("TRI V0 {} V1 {} V2 {}", place(a), place(b), place(c)));
    }
    /// Tachyon determines a triangle's sides by the order of its corners, which the mirroring
    /// reverses.
    bool smooth_triangle(const std::array<Vec3d, 3>& p, const std::array<Vec3d, 3>& n) const {
        const auto normal = [&](int i) { return place(normalize(n[static_cast<std::size_t>(i)])); };
        return line(fmt::format("STRI V0 {} V1 {} V2 {} N0 {} N1 {} N2 {}", place(p[2]),
                                place(p[1]), place(p[0]), normal(2), normal(1), normal(0)));
    }
};

void write_camera(const Scene& scene, std::string& out) {
    const Camera& camera = scene.cameras[0];
    const bool parallel = std::holds_alternative<OrthographicProjection>(camera.projection);
    // ZOOM z shows 1/z in height: at distance 1, or for parallel rays.
    const double zoom =
        parallel
            ? 1 / std::get<OrthographicProjection>(camera.projection).height
            : 0.5 / std::tan(radians(std::get<PerspectiveProjection>(camera.projection).fov / 2));
    out += fmt::format(
        "CAMERA PROJECTION {} ZOOM {} ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH {}\n"
        "CENTER {} VIEWDIR {} UPDIR {}\nEND_CAMERA\n",
        parallel ? "ORTHOGRAPHIC" : "PERSPECTIVE", zoom, scene.settings.max_depth,
        place(camera.position), place(normalize(camera.look_at - camera.position)),
        place(camera.up));
}

/// 2/(1 + (d/distance)^power) as 1/(constant + linear d + quadratic d²); false for other powers.
bool write_fade(const std::optional<Fade>& fade, std::string& out) {
    if (!fade) return true;
    if (fade->power != 1 && fade->power != 2) return false;
    const double share =
        0.5 / (fade->power == 1 ? fade->distance : fade->distance * fade->distance);
    out += fmt::format(" ATTENUATION CONSTANT 0.5 LINEAR {} QUADRATIC {}",
                       fade->power == 1 ? share : 0, fade->power == 2 ? share : 0);
    return true;
}

bool write_light(const Scene& scene, const Light& light, std::string& out) {
    // A zero radius would give no light; otherwise the size only matters when the light is visible.
    const double size = 1e-9 * length(scene.cameras[0].look_at - scene.cameras[0].position);
    if (!light.shadows) return false;
    if (const auto* point = std::get_if<PointLight>(&light.kind)) {
        std::string fade;
        if (!write_fade(point->fade, fade)) return false;
        out += fmt::format("LIGHT CENTER {} RAD {}{} COLOR {}\n", place(point->position), size,
                           fade, vector(light.color));
        return true;
    }
    const auto* sun = std::get_if<DirectionalLight>(&light.kind);
    if (sun == nullptr) return false;
    out += fmt::format("DIRECTIONAL_LIGHT DIRECTION {} COLOR {}\n",
                       place(normalize(sun->direction)), vector(light.color));
    return true;
}

bool is_glass(const Material& m) {
    return m.filter + m.transmission > 0;
}

/// Whether Tachyon has words for the whole material.
bool has_words(const Material& m) {
    return !is_glass(m) && m.texture == none && m.blinn == 0 && m.fresnel == 0 && m.metallic == 0 &&
           m.reflection.x == m.reflection.y && m.reflection.y == m.reflection.z &&
           m.diffuse_transmission == 0 && m.phong_transmission == 0 &&
           max_component(m.emission) == 0;
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

TachyonScene tachyon_scene(const Scene& scene) {
    std::string out = fmt::format("BEGIN_SCENE\nRESOLUTION {} {}\n", scene.width, scene.height);
    std::size_t not_said = scene.sky ? 1 : 0;
    write_camera(scene, out);
    out += fmt::format("BACKGROUND {}\n", vector(scene.background));
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& m = scene.materials[i];
        out += fmt::format(
            "TEXDEF m{} AMBIENT {} DIFFUSE {} SPECULAR {} OPACITY 1 PHONG PLASTIC {} PHONG_SIZE {} "
            "COLOR {} TEXFUNC 0\n",
            i, m.ambient * max_component(scene.ambient), m.diffuse, m.reflection.x, m.phong,
            m.shininess, vector(m.color));
    }
    for (const Light& light : scene.lights) not_said += write_light(scene, light, out) ? 0 : 1;
    for (const Object& object : scene.objects) {
        const Material& m = scene.materials[object.material];
        const bool written =
            object.transform == 0 && !is_glass(m) &&
            std::visit(ShapeWriter{scene, fmt::format("m{}", object.material), out}, object.shape);
        not_said += written && has_words(m) ? 0 : 1;
    }
    return {out + "END_SCENE\n", not_said};
}

std::optional<std::string> run_tachyon(const std::string& program, const Scene& scene,
                                       const std::filesystem::path& folder,
                                       const std::string& format) {
    std::ofstream(folder / "scene.dat") << tachyon_scene(scene).text;
    const reference::ProcessResult result =
        reference::run_process({program, "scene.dat", "-shade_phong", "-format", format, "-o",
                                "scene.ppm", "-numthreads", "1"},
                               folder, 60);
    const std::filesystem::path picture = folder / "scene.ppm";
    std::error_code ignored;
    if (result.exit_code != 0 || !std::filesystem::exists(picture, ignored)) return std::nullopt;
    return picture.string();
}

std::optional<Image> tachyon_picture(const std::string& program, const Scene& scene) {
    const io::TemporaryFolder folder;
    const auto picture = run_tachyon(program, scene, folder.path());
    if (!picture) return std::nullopt;
    return read_ppm48(io::read_file(*picture));
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

}  // namespace lancer
