#include "model/io/mesh_file.h"

#include "model/smoothing.h"
#include "parser/blocks/attributes.h"
#include "parser/blocks/blocks.h"
#include "parser/blocks/file_materials.h"

namespace lancer {
namespace {

/// The value of `smooth`.
struct Smoothing {
    bool on = true;
    std::optional<double> angle;
};

}  // namespace

namespace rules {

struct FlagOrAngle {
    static constexpr std::string_view takes = "true, false or an angle from 0 to 180 degrees";
    static bool read(const Value& value, Smoothing& out, std::string&) {
        if (value.is(Value::Kind::boolean)) {
            out = {value.boolean(), {}};
            return true;
        }
        if (!value.is_number() || !HalfAngle::holds(value.number())) return false;
        out = {true, value.number()};
        return true;
    }
};

struct HasInside {
    static constexpr std::string_view takes = "true or false";
    static bool read(const Value& value, Inside& out, std::string&) {
        if (!value.is(Value::Kind::boolean)) return false;
        out = value.boolean() ? Inside::always : Inside::never;
        return true;
    }
};

}  // namespace rules

namespace blocks {
namespace {

struct MeshSpec {
    std::string file;
    std::vector<Vec3d> vertices;
    std::vector<std::vector<std::uint32_t>> faces;
    std::vector<Vec3d> normals;
    std::vector<Vec2d> uvs;
    std::vector<Vec3d> colors;
    Smoothing smooth;
    Inside inside = Inside::if_closed;
};

constexpr Field mesh_fields[] = {
    field<&MeshSpec::file, rules::String>("file", "none", "an OBJ, PLY or STL file"),
    field<&MeshSpec::vertices, rules::Points>("vertices", "none", "positions of the vertices"),
    field<&MeshSpec::faces, rules::Faces>(
        "faces", "none",
        "for each face the indices of its vertices in order; the first vertex is 0"),
    field<&MeshSpec::normals, rules::Points>("normals", "averages of the faces' normals",
                                             "a normal for each vertex"),
    field<&MeshSpec::uvs, rules::PlanePoints>("uvs", "none", "texture coordinates of each vertex"),
    field<&MeshSpec::colors, rules::Colors>("colors", "none",
                                            "a colour for each vertex, for 'color vertex'"),
    field<&MeshSpec::smooth, rules::FlagOrAngle>("smooth", "true; for STL 40",
                                                 "false: flat faces; an angle: edges sharper than "
                                                 "that stay sharp where no normals are given"),
    field<&MeshSpec::inside, rules::HasInside>(
        "body", "true if it is closed", "true: has an inside in spite of gaps; false: has none"),
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
    one_each("colors", spec.colors.size());
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
    block.builder().add(MeshRef{mesh_index(block.builder(), mesh), spec.smooth.on, spec.inside},
                        attributes, block.place());
}

void add_inline(BlockReader& block, MeshSpec& spec, const Attributes& attributes) {
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = std::move(spec.vertices);
    mesh->normals = std::move(spec.normals);
    mesh->uvs = std::move(spec.uvs);
    mesh->colors = std::move(spec.colors);
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
    if (mesh->faces.empty()) return;
    if (mesh->normals.empty() && spec.smooth.angle)
        *mesh = with_sharp_edges(*mesh, *spec.smooth.angle);
    add_mesh(block, mesh, spec, attributes);
}

/// STL files never have vertex normals.
bool lacks_normals(std::string path) {
    for (char& c : path) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return path.ends_with(".stl");
}

/// The mesh of a file, with normals by the angle that the scene or the format asks for. It is made
/// once and stored beside the file's own mesh, under its path and the angle.
std::shared_ptr<const Mesh> smoothed(BlockReader& block,
                                     const std::shared_ptr<const io::LoadedMesh>& loaded,
                                     const std::string& path, std::optional<double> angle) {
    constexpr double of_formats_without_normals = 40;
    if (!block.has("smooth") && lacks_normals(path)) angle = of_formats_without_normals;
    if (!angle || !loaded->mesh.normals.empty()) return {loaded, &loaded->mesh};
    auto& made = block.context().program.meshes[path + '\n' + to_text(*angle)].content;
    if (made == nullptr) {
        auto fresh = std::make_shared<io::LoadedMesh>();
        fresh->mesh = with_sharp_edges(loaded->mesh, *angle);
        made = std::move(fresh);
    }
    return {made, &made->mesh};
}

}  // namespace

const BlockInfo mesh{"mesh", "", mesh_fields, attribute_fields,
                     "triangles and polygons, from a file or in place"};

void make_mesh(BlockReader& block, std::uint32_t&) {
    MeshSpec spec;
    Attributes attributes;
    block.read(&spec, &attributes);
    const bool in_place = block.has("vertices") || block.has("faces") || block.has("normals") ||
                          block.has("uvs") || block.has("colors");
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
    const std::string path = block.resolve_path(spec.file);
    const auto loaded = block.context().files.mesh(path, block.place("file"));
    if (loaded == nullptr) return;
    for (const std::string& text : loaded->warnings)
        block.warning(Message::mesh_file, block.place("file"), text);
    warn_degenerate(block, block.place("file"), loaded->degenerate);
    if (loaded->mesh.faces.empty()) return;
    const auto shown = smoothed(block, loaded, path, spec.smooth.angle);
    if (loaded->materials.empty()) {
        add_mesh(block, shown, spec, attributes);
        return;
    }
    const MeshWithMaterials whole{loaded,         path,        shown,
                                  spec.smooth.on, spec.inside, block.place("file")};
    block.builder().add(parts_of(block.context(), whole), attributes, block.place());
}

}  // namespace blocks
}  // namespace lancer
