#include "parser/advice.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

#include "model/open_edges.h"
#include "model/requirements.h"
#include "parser/value.h"

namespace lancer {
namespace {

std::string place_of(const Vec3d& p) {
    return fmt::format("[{}, {}, {}]", to_text(p.x), to_text(p.y), to_text(p.z));
}

/// "1 of its edges has one face only", "12 of its edges do not have two faces".
std::string count_of(const OpenEdges& open) {
    if (open.count != 1) return fmt::format("{} of its edges do not have two faces", open.count);
    return open.faces == 1 ? "1 of its edges has one face only"
                           : fmt::format("1 of its edges has {} faces", open.faces);
}

/// A mesh that is one material's share of a file's.
std::string piece_of(const Scene& scene, const Object& object) {
    const bool named = object.material < scene.material_names.size();
    return fmt::format("the faces of this mesh that are '{}'",
                       named ? scene.material_names[object.material] : "");
}

}  // namespace

std::vector<Diagnostic> advice_on(const Scene& scene,
                                  const std::unordered_set<const Mesh*>& pieces) {
    std::vector<Diagnostic> found;
    std::map<std::uint32_t, OpenEdges> known;  // by mesh
    std::set<std::pair<std::uint32_t, std::uint32_t>> places;
    for (const Object& object : scene.objects) {
        const auto* mesh = std::get_if<MeshRef>(&object.shape);
        if (mesh == nullptr) continue;
        const Material& material = scene.materials[object.material];
        const bool bends = material.ior != 1;
        if (!bends && !(max_component(material.absorption) > 0)) continue;
        if (!lets_light_through(scene, material, true)) continue;
        const auto [at, is_new] = known.try_emplace(mesh->mesh);
        if (is_new) at->second = open_edges(*scene.meshes[mesh->mesh]);
        const OpenEdges& open = at->second;
        if (open.count == 0 || !places.emplace(object.place.file, object.place.offset).second)
            continue;
        const bool is_piece = pieces.contains(scene.meshes[mesh->mesh].get());
        found.push_back(
            {Severity::warning,
             object.place,
             fmt::format("light passes through {}, but it is not closed: {}, the first from "
                         "{} to {}; so it has no inside, and its {} does nothing",
                         is_piece ? piece_of(scene, object) : "this mesh", count_of(open),
                         place_of(open.begin), place_of(open.end), bends ? "ior" : "absorption"),
             is_piece
                 ? "a mesh with several materials is one object for each of them: give glass a "
                   "file of its own, or the mesh one 'material'"
                 : "close the gap: vertices that ought to be one must be at exactly the same place",
             {}});
    }
    return found;
}

}  // namespace lancer
