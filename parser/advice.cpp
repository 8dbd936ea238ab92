#include "parser/advice.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

#include "model/empty_bodies.h"
#include "model/open_edges.h"
#include "model/requirements.h"
#include "parser/value.h"

namespace lancer {
namespace {

std::string place_of(const Vec3d& p) {
    return fmt::format("[{}, {}, {}]", to_text(p.x), to_text(p.y), to_text(p.z));
}

/// "1 of its edges belongs to only one face", "12 of its edges do not belong to exactly two faces".
std::string count_of(const OpenEdges& open) {
    if (open.count != 1)
        return fmt::format("{} of its edges do not belong to exactly two faces", open.count);
    return open.faces == 1 ? "1 of its edges belongs to only one face"
                           : fmt::format("1 of its edges belongs to {} faces", open.faces);
}

/// Describes a mesh that holds the faces of one material of a file.
std::string piece_of(const Scene& scene, const Object& object) {
    const bool named = object.material < scene.material_names.size();
    return fmt::format("the faces of this mesh that are '{}'",
                       named ? scene.material_names[object.material] : "");
}

/// Finds transparent meshes that have no inside.
class MeshAdvice {
  public:
    MeshAdvice(const Scene& scene, const std::unordered_set<const Mesh*>& pieces)
        : scene_(scene), pieces_(pieces) {}

    void add(const Object& object, std::vector<Diagnostic>& found) {
        const auto* mesh = std::get_if<MeshRef>(&object.shape);
        if (mesh == nullptr || mesh->inside != Inside::if_closed) return;
        const Material& material = scene_.materials[object.material];
        const bool bends = material.ior != 1;
        if (!bends && !(max_component(material.absorption) > 0)) return;
        if (!lets_light_through(scene_, material, true)) return;
        const auto [at, is_new] = known_.try_emplace(mesh->mesh);
        if (is_new) at->second = open_edges(*scene_.meshes[mesh->mesh]);
        const OpenEdges& open = at->second;
        if (open.count == 0) return;
        const bool is_piece = pieces_.contains(scene_.meshes[mesh->mesh].get());
        found.push_back(
            {Severity::warning,
             object.place,
             fmt::format("light passes through {}, but this surface is not closed: {}, the first "
                         "from {} to {}; it has no inside, so its {} has no effect",
                         is_piece ? piece_of(scene_, object) : "this mesh", count_of(open),
                         place_of(open.begin), place_of(open.end), bends ? "ior" : "absorption"),
             is_piece ? "a mesh with several materials becomes one object for each of them: put "
                        "the glass into a file of its own, or give the mesh one 'material'"
                      : "close the gap: vertices that belong together must be at exactly the same "
                        "place; or write 'body true' in the mesh, but rays that meet the gap then "
                        "go wrong",
             {}});
    }

  private:
    const Scene& scene_;
    const std::unordered_set<const Mesh*>& pieces_;
    std::map<std::uint32_t, OpenEdges> known_;  // by mesh
};

void add_empty_body(const Scene& scene, const Object& object, std::vector<Diagnostic>& found) {
    const auto* whole = std::get_if<CompositeRef>(&object.shape);
    if (whole == nullptr) return;
    const Emptiness why = emptiness_of(scene, scene.composites[whole->composite]);
    if (why == Emptiness::not_known) return;
    const std::string name =
        object.name == none ? "" : fmt::format(" '{}'", scene.names[object.name]);
    found.push_back({Severity::warning,
                     object.place,
                     fmt::format("nothing is left of this body{}", name),
                     why == Emptiness::apart
                         ? "parts of the intersection have no space in common"
                         : "the parts that are cut away contain the whole first part; a difference "
                           "is its first part minus all others",
                     {}});
}

}  // namespace

std::vector<Diagnostic> advice_on(const Scene& scene,
                                  const std::unordered_set<const Mesh*>& pieces) {
    std::vector<Diagnostic> found;
    MeshAdvice meshes(scene, pieces);
    std::set<std::pair<std::uint32_t, std::uint32_t>> told;
    for (const Object& object : scene.objects) {
        const std::pair<std::uint32_t, std::uint32_t> place{object.place.file, object.place.offset};
        if (told.contains(place)) continue;
        const std::size_t before = found.size();
        meshes.add(object, found);
        add_empty_body(scene, object, found);
        if (found.size() > before) told.insert(place);
    }
    return found;
}

}  // namespace lancer
