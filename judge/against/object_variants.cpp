#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "judge/against/scene_variants.h"
#include "judge/validate/place_words.h"

namespace lancer::judge {

namespace {

// In the order of the alternatives of Shape.
constexpr std::array<std::string_view, std::variant_size_v<Shape>> kinds{
    "spheres",   "boxes",  "cylinders", "cones",  "tori",   "planes",
    "triangles", "meshes", "patches",   "lathes", "prisms", "composites"};

/// Lights the object as if its normals were reversed. Most programs then find no light at all,
/// because the body is in the way; light may reach a sheet from behind.
void turn_material(Scene& scene, Object& turned, bool from_behind) {
    Material material = scene.materials[turned.material];
    material.diffuse_transmission = from_behind ? material.diffuse : 0;
    material.phong_transmission = 0;
    material.diffuse = material.phong = material.blinn = 0;
    turned.material = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(material);
}

void turn_normals(Scene& scene, std::size_t object, bool from_behind) {
    Object& turned = scene.objects[object];
    if (const auto* solid = std::get_if<CompositeRef>(&turned.shape)) {
        for (Composite::Leaf& leaf : scene.composites[solid->composite].leaves)
            turn_material(scene, leaf.object, from_behind);
    } else {
        turn_material(scene, turned, from_behind);
    }
}

/// The kinds that several objects have, but not all.
std::vector<std::size_t> common_kinds(const Scene& scene) {
    std::array<std::size_t, kinds.size()> counts{};
    for (const Object& object : scene.objects) ++counts[object.shape.index()];
    std::vector<std::size_t> common;
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        if (counts[kind] > 1 && counts[kind] < scene.objects.size()) common.push_back(kind);
    return common;
}

void add_normals(std::vector<SceneVariant>& variants, const ValidationJob& job,
                 const std::vector<std::size_t>& suspects) {
    for (const bool from_behind : {false, true}) {
        for (const std::size_t object : suspects) {
            variants.push_back(
                {fmt::format("the normals of {} are flipped: it is lit from the wrong side",
                             object_words(job, object)),
                 [object, from_behind](Scene& scene) {
                     turn_normals(scene, object, from_behind);
                 }});
        }
        for (const std::size_t kind : common_kinds(*job.scene)) {
            variants.push_back(
                {fmt::format("the normals of all {} are flipped: they are lit from the wrong side",
                             kinds[kind]),
                 [kind, from_behind](Scene& scene) {
                     for (std::size_t i = 0; i < scene.objects.size(); ++i)
                         if (scene.objects[i].shape.index() == kind)
                             turn_normals(scene, i, from_behind);
                 }});
        }
        if (job.scene->objects.size() < 2) continue;
        variants.push_back({"all normals are flipped: everything is lit from the wrong side",
                            [from_behind](Scene& scene) {
                                for (std::size_t i = 0; i < scene.objects.size(); ++i)
                                    turn_normals(scene, i, from_behind);
                            }});
    }
}

void add_missing(std::vector<SceneVariant>& variants, const ValidationJob& job,
                 const std::vector<std::size_t>& suspects) {
    for (const std::size_t object : suspects) {
        variants.push_back({object_words(job, object) + " is missing", [object](Scene& scene) {
                                scene.objects.erase(scene.objects.begin() +
                                                    static_cast<std::ptrdiff_t>(object));
                            }});
    }
    for (const std::size_t kind : common_kinds(*job.scene)) {
        variants.push_back({fmt::format("all {} are missing", kinds[kind]), [kind](Scene& scene) {
                                std::erase_if(scene.objects, [kind](const Object& object) {
                                    return object.shape.index() == kind;
                                });
                            }});
    }
}

}  // namespace

void add_object_variants(std::vector<SceneVariant>& variants, const ValidationJob& job,
                         const std::vector<std::size_t>& suspects) {
    add_normals(variants, job, suspects);
    add_missing(variants, job, suspects);
}

}  // namespace lancer::judge
