#include "cli/mesh_hints.h"

#include <fmt/format.h>

#include <set>

#include "model/parts.h"
#include "model/smoothing.h"

namespace lancer::cli {

std::vector<Diagnostic> smoothed_edges(const Scene& scene) {
    constexpr double sharp = 60;
    std::vector<Diagnostic> found;
    std::set<std::uint32_t> seen;  // meshes
    for_each_part(scene, [&](const Object& object) {
        const auto* ref = std::get_if<MeshRef>(&object.shape);
        if (ref == nullptr || !ref->smooth || !seen.insert(ref->mesh).second) return;
        const Mesh& mesh = *scene.meshes[ref->mesh];
        if (!mesh.normals.empty()) return;
        const std::size_t count = count_sharp_edges(mesh, sharp);
        if (count == 0) return;
        found.push_back({Severity::warning,
                         object.place,
                         fmt::format("this mesh has no normals, so it is smoothed over all edges, "
                                     "{} of them sharper than {} degrees",
                                     count, sharp),
                         "use 'smooth 40' to keep sharp edges, or 'smooth false' to keep all edges",
                         {}});
    });
    return found;
}

}  // namespace lancer::cli
