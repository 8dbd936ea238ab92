#include "judge/against/scene_variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lancer::judge {

namespace {

bool is_parallel(const Vec3d& a, const Vec3d& b) {
    const Vec3d across = cross(a, b);
    return dot(across, across) < 1e-12 * dot(a, a) * dot(b, b);
}

void add_up_vectors(std::vector<SceneVariant>& variants, const Camera& seen, std::size_t camera) {
    const Vec3d view = seen.look_at - seen.position;
    const std::pair<const char*, Vec3d> axes[] = {
        {"x", {1, 0, 0}}, {"y", {0, 1, 0}}, {"z", {0, 0, 1}}};
    for (const auto& [name, up] : axes) {
        if (is_parallel(up, view) || is_parallel(up, seen.up)) continue;
        variants.push_back({fmt::format("{} is up in the other picture, but ({:g}, {:g}, {:g}) is "
                                        "up in the scene's camera",
                                        name, seen.up.x, seen.up.y, seen.up.z),
                            [camera, up = up](Scene& scene) { scene.cameras[camera].up = up; }});
    }
}

using Swap = Vec3d (*)(const Vec3d&);

/// Exchanging the axes of the world under a fixed camera gives the same picture as changing the
/// camera the other way.
SceneVariant axes_exchanged(std::size_t camera, const char* words, Swap back, bool mirrored) {
    return {words,
            [camera, back](Scene& scene) {
                Camera& seen = scene.cameras[camera];
                seen.position = back(seen.position);
                seen.look_at = back(seen.look_at);
                seen.up = back(seen.up);
            },
            mirrored};
}

void add_exchanged_axes(std::vector<SceneVariant>& variants, std::size_t camera) {
    variants.push_back(axes_exchanged(
        camera,
        "y and z are exchanged in the objects, not in the camera: (x, y, z) became "
        "(x, -z, y)",
        [](const Vec3d& v) { return Vec3d(v.x, v.z, -v.y); }, false));
    variants.push_back(axes_exchanged(
        camera,
        "y and z are exchanged in the objects, not in the camera: (x, y, z) became "
        "(x, z, -y)",
        [](const Vec3d& v) { return Vec3d(v.x, -v.z, v.y); }, false));
    variants.push_back(axes_exchanged(
        camera,
        "y and z are exchanged in the objects, not in the camera: (x, y, z) became "
        "(x, z, y)",
        [](const Vec3d& v) { return Vec3d(v.x, v.z, v.y); }, true));
    variants.push_back(axes_exchanged(
        camera, "z is reversed in the objects, not in the camera: (x, y, z) became (x, y, -z)",
        [](const Vec3d& v) { return Vec3d(v.x, v.y, -v.z); }, true));
}

void add_fields_of_view(std::vector<SceneVariant>& variants, const Camera& seen, std::size_t camera,
                        const reference::ExportView& view) {
    const auto* perspective = std::get_if<PerspectiveProjection>(&seen.projection);
    if (perspective == nullptr) return;
    const double fov = perspective->fov;
    const auto add = [&](std::string words, double other) {
        if (!(other > 0 && other < 180) || std::abs(other - fov) < 1e-6) return;
        variants.push_back({std::move(words), [camera, other](Scene& scene) {
                                scene.cameras[camera].projection = PerspectiveProjection{other};
                            }});
    };
    const double half = fov * std::numbers::pi / 360;
    const double shape = static_cast<double>(view.height) / view.width;
    add(fmt::format("fov {:g} is taken for the horizontal angle, but it is the vertical one", fov),
        2 * std::atan(std::tan(half) * shape) * 180 / std::numbers::pi);
    add(fmt::format("fov {:g} is taken for half the angle, but it is the full one", fov), 2 * fov);
    add(fmt::format("half of fov {:g} is taken for the full angle", fov), fov / 2);
}

void add_settings(std::vector<SceneVariant>& variants, const Scene& scene) {
    const auto add = [&](std::string words, auto change) {
        variants.push_back({std::move(words), change});
    };
    if (scene.settings.shadows) {
        add("there are no shadows", [](Scene& s) { s.settings.shadows = false; });
    }
    if (scene.settings.smooth && !scene.meshes.empty()) {
        add("meshes are flat: their vertices' normals are not interpolated",
            [](Scene& s) { s.settings.smooth = false; });
    }
    if (!scene.sky) return;
    add("the sky is left out: the background's colour is shown instead",
        [](Scene& s) { s.sky = std::nullopt; });
    add("the sky is upside down: its axis points the other way",
        [](Scene& s) { s.sky->axis = -s.sky->axis; });
}

/// Whether a ray can split in two: then each level may cost as much as all before it.
bool has_branches(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& m) {
        return (m.transmission > 0 || m.filter > 0) && max_component(m.reflection) > 0;
    });
}

/// The nearest depths first, then round numbers.
void add_depths(std::vector<SceneVariant>& variants, const Scene& scene) {
    const int depth = scene.settings.max_depth;
    const int most = has_branches(scene) ? std::max(10, depth + 1) : std::max(64, depth + 1);
    std::vector<int> depths{1, depth - 1, depth + 1, 2, 3, 4, 5, 6, 8, depth / 2};
    for (const int larger : {2 * depth, 10, 16, 32, 64}) depths.push_back(larger);
    std::vector<int> tried{depth};
    for (const int other : depths) {
        if (other < 1 || other > most) continue;
        if (std::find(tried.begin(), tried.end(), other) != tried.end()) continue;
        tried.push_back(other);
        variants.push_back({fmt::format("rays are followed {} level{} deep, but the scene says {}",
                                        other, other == 1 ? "" : "s", depth),
                            [other](Scene& s) { s.settings.max_depth = other; }});
    }
}

}  // namespace

std::vector<SceneVariant> scene_variants(const ValidationJob& job, std::size_t camera,
                                         const std::vector<std::size_t>& suspects) {
    std::vector<SceneVariant> variants;
    const Camera& seen = job.scene->cameras[camera];
    add_up_vectors(variants, seen, camera);
    add_exchanged_axes(variants, camera);
    add_fields_of_view(variants, seen, camera, job.view);
    add_settings(variants, *job.scene);
    add_depths(variants, *job.scene);
    add_object_variants(variants, job, suspects);
    add_material_variants(variants, *job.scene);
    add_texture_variants(variants, *job.scene);
    return variants;
}

}  // namespace lancer::judge
