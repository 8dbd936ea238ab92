#include "parser/vertex_colors.h"

#include "model/parts.h"

namespace lancer {

void check_vertex_colors(const Scene& scene, Report& report) {
    std::vector<bool> of_vertices;  // by material
    bool any = false;
    for (const Material& material : scene.materials) {
        of_vertices.push_back(
            material.texture != none &&
            std::holds_alternative<VertexColors>(scene.textures[material.texture].pattern));
        any = any || of_vertices.back();
    }
    if (!any) return;
    for (const Object& object : scene.objects) {
        for_each_part(scene, object, [&](const Object& part) {
            if (!of_vertices[part.material]) return;
            const auto* mesh = std::get_if<MeshRef>(&part.shape);
            if (mesh != nullptr && !scene.meshes[mesh->mesh]->colors.empty()) return;
            Diagnostic* error =
                report.error(Message::no_vertex_colors, part.place,
                             mesh != nullptr ? "this mesh has none" : "only meshes have them");
            if (error == nullptr || mesh == nullptr) return;
            error->hint =
                "give the mesh 'colors [...]', one for each vertex, or read a PLY or OBJ file that "
                "has colours";
        });
    }
}

}  // namespace lancer
