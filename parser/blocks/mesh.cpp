#include "model/io/mesh_file.h"

#include "parser/blocks/attributes.h"
#include "parser/blocks/blocks.h"

namespace lancer::blocks {
namespace {

struct MeshSpec {
    std::string file;
    std::vector<Vec3d> vertices;
    std::vector<std::vector<std::uint32_t>> faces;
    std::vector<Vec3d> normals;
    std::vector<Vec2d> uvs;
    bool smooth = true;
};

constexpr Field mesh_fields[] = {
    field<&MeshSpec::file, rules::String>("file", "none", "an OBJ, PLY or STL file"),
    field<&MeshSpec::vertices, rules::Points>("vertices", "none", "the places of its corners"),
    field<&MeshSpec::faces, rules::Faces>(
        "faces", "none", "for each face the indices, from 0, of its vertices in order"),
    field<&MeshSpec::normals, rules::Points>("normals", "averages of the faces",
                                             "a normal for each vertex"),
    field<&MeshSpec::uvs, rules::PlanePoints>("uvs", "none", "texture coordinates of each vertex"),
    field<&MeshSpec::smooth, rules::Flag>("smooth", "true", "false: flat faces"),
};

std::string count_of(std::size_t count, std::string_view one, std::string_view more) {
    return std::to_string(count) + " " + std::string(count == 1 ? one : more);
}

void warn_degenerate(BlockReader& block, const SourceSpan& place, std::uint64_t count) {
    if (count == 0) return;
    block.warning(Message::degenerate_triangles, place,
                  count_of(count, "degenerate triangle", "degenerate triangles"));
}

void check_counts(BlockReader& block, const MeshSpec& spec) {
    const auto one_each = [&](std::string_view property, std::size_t count) {
        if (block.has(property) && count != spec.vertices.size())
            block.error(Message::element_count, block.place(property), property,
                        count_of(count, "element", "elements"),
                        count_of(spec.vertices.size(), "vertex", "vertices"));
    };
    one_each("normals", spec.normals.size());
    one_each("uvs", spec.uvs.size());
    for (std::size_t i = 0; i < spec.faces.size(); ++i) {
        for (const std::uint32_t corner : spec.faces[i]) {
            if (corner < spec.vertices.size()) continue;
            block.error(Message::face_index, block.place("faces"), i, corner,
                        count_of(spec.vertices.size(), "vertex", "vertices"));
            return;
        }
    }
}

void add_mesh(BlockReader& block, const std::shared_ptr<const Mesh>& mesh, const MeshSpec& spec,
              const Attributes& attributes) {
    auto& meshes = block.builder().scene.meshes;
    // Instances of one file follow each other or not: the pointer tells them.
    const auto [at, is_new] =
        block.builder().mesh_indices.emplace(mesh.get(), static_cast<std::uint32_t>(meshes.size()));
    if (is_new) meshes.push_back(mesh);
    block.builder().add(MeshRef{at->second, spec.smooth}, attributes, block.place());
}

void add_inline(BlockReader& block, MeshSpec& spec, const Attributes& attributes) {
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = std::move(spec.vertices);
    mesh->normals = std::move(spec.normals);
    mesh->uvs = std::move(spec.uvs);
    std::uint64_t degenerate = 0;
    std::vector<Mesh::Corners> triangles;
    for (const auto& face : spec.faces) {
        triangles.clear();
        io::triangulate(mesh->vertices, face, triangles);
        degenerate += face.size() - 2 - std::min(triangles.size(), face.size() - 2);
        for (const Mesh::Corners& t : triangles)
            mesh->faces.push_back({face[t[0]], face[t[1]], face[t[2]]});
    }
    warn_degenerate(block, block.place("faces"), degenerate);
    if (!mesh->faces.empty()) add_mesh(block, mesh, spec, attributes);
}

}  // namespace

const BlockInfo mesh{"mesh", "", mesh_fields, attribute_fields,
                     "triangles and polygons, from a file or in place"};

void make_mesh(BlockReader& block, std::uint32_t&) {
    MeshSpec spec;
    Attributes attributes;
    block.read(&spec, &attributes);
    const bool in_place =
        block.has("vertices") || block.has("faces") || block.has("normals") || block.has("uvs");
    if (block.has("file") == in_place ||
        (in_place && !(block.has("vertices") && block.has("faces")))) {
        if (block.good()) block.error(Message::mesh_two_ways, block.place());
        return;
    }
    if (in_place && block.good()) check_counts(block, spec);
    if (!block.good()) return;
    if (in_place) {
        add_inline(block, spec, attributes);
        return;
    }
    const auto loaded =
        block.evaluator().load_mesh(block.resolve_path(spec.file), block.place("file"));
    if (loaded == nullptr) return;
    for (const std::string& text : loaded->warnings)
        block.warning(Message::mesh_file, block.place("file"), text);
    warn_degenerate(block, block.place("file"), loaded->degenerate);
    const std::shared_ptr<const Mesh> shared(loaded, &loaded->mesh);
    if (!shared->faces.empty()) add_mesh(block, shared, spec, attributes);
}

}  // namespace lancer::blocks
