#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <type_traits>

#include "judge/pack/scene_json.h"
#include "model/mesh_pieces.h"
#include "model/shape_facts.h"

namespace lancer::judge {

namespace {

template <class List>
Json list_json(const List& list) {
    Json result = Json::array();
    for (const auto& item : list) result.push_back(to_json(item));
    return result;
}

const char* name_of(Spline spline) {
    switch (spline) {
        case Spline::linear:
            return "linear";
        case Spline::bezier:
            return "bezier";
        case Spline::bspline:
            return "bspline";
        case Spline::catmull_rom:
            return "catmull_rom";
    }
    return "";
}

std::string numbers_line(const char* word, std::initializer_list<double> numbers) {
    std::string line = word;
    for (const double number : numbers) line += fmt::format(" {}", number);
    return line + "\n";
}

/// A mesh as Wavefront OBJ, with as many digits as its numbers need. If it is smooth but has no
/// normals, the file has the averaged normals that a renderer would use.
std::string obj_text(const Mesh& given, bool smooth) {
    std::optional<Mesh> averaged;
    if (smooth && given.normals.empty()) averaged = with_averaged_normals(given);
    const Mesh& mesh = averaged ? *averaged : given;
    std::string text;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vec3d& v = mesh.vertices[i];
        if (mesh.colors.empty()) {
            text += numbers_line("v", {v.x, v.y, v.z});
        } else {
            const Vec3d& c = mesh.colors[i];
            text += numbers_line("v", {v.x, v.y, v.z, c.x, c.y, c.z});
        }
    }
    const bool normals = smooth && !mesh.normals.empty();
    if (normals)
        for (const Vec3d& n : mesh.normals) text += numbers_line("vn", {n.x, n.y, n.z});
    for (const Vec2d& uv : mesh.uvs) text += numbers_line("vt", {uv.x, uv.y});
    const auto index = [](const std::vector<Mesh::Corners>& faces, std::size_t face,
                          const Mesh::Corners& otherwise,
                          std::size_t k) { return faces.empty() ? otherwise[k] : faces[face][k]; };
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        text += "f";
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = mesh.faces[face][k];
            const std::uint32_t uv =
                mesh.uvs.empty() ? none : index(mesh.uv_faces, face, mesh.faces[face], k);
            const std::uint32_t n =
                normals ? index(mesh.normal_faces, face, mesh.faces[face], k) : none;
            text += fmt::format(" {}", v + 1);
            if (uv != none || n != none) text += "/";
            if (uv != none) text += fmt::format("{}", uv + 1);
            if (n != none) text += fmt::format("/{}", n + 1);
        }
        text += "\n";
    }
    return text;
}

class ShapeWriter {
  public:
    ShapeWriter(const Scene& scene, PackSink& sink) : scene_(scene), sink_(sink) {}

    /// A shape whose fields are plain numbers.
    Json operator()(const OneShape auto& shape) const {
        Json json;
        json["kind"] = facts_of(scene_, shape).name;
        fields(shape, [&json](const char* name, const auto& value) {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Vec3d>)
                json[name] = to_json(value);
            else
                json[name] = value;
        });
        return json;
    }
    // The other shapes refer to data stored elsewhere.
    Json operator()(const Triangle& t) const {
        Json json{{"kind", "triangle"}, {"points", list_json(t.points)}};
        if (t.attributes == none) return json;
        const TriangleAttributes& more = scene_.triangle_attributes[t.attributes];
        if (more.normals) json["normals"] = list_json(*more.normals);
        if (more.uvs) json["uvs"] = list_json(*more.uvs);
        return json;
    }
    Json operator()(const MeshRef& m) const {
        const std::string name = fmt::format("mesh-{}{}.obj", m.mesh, m.smooth ? "" : "-flat");
        const bool is_there = std::any_of(sink_.files.begin(), sink_.files.end(),
                                          [&](const PackedFile& f) { return f.name == name; });
        if (!is_there) sink_.files.push_back({name, obj_text(*scene_.meshes[m.mesh], m.smooth)});
        return {{"kind", "mesh"},
                {"file", name},
                {"smooth", m.smooth},
                {"body", sink_.bodies.holds(m)}};
    }
    Json operator()(const PatchRef& p) const {
        const Patch& patch = scene_.patches[p.patch];
        return {{"kind", "patch"},
                {"basis", patch.basis == Patch::Basis::bezier ? "bezier" : "bspline"},
                {"rows", patch.rows},
                {"columns", patch.columns},
                {"control", list_json(patch.control)}};
    }
    Json operator()(const LatheRef& l) const {
        const Lathe& lathe = scene_.lathes[l.lathe];
        return {{"kind", "lathe"},
                {"spline", name_of(lathe.spline)},
                {"profile", list_json(lathe.profile)}};
    }
    Json operator()(const PrismRef& p) const {
        const Prism& prism = scene_.prisms[p.prism];
        return {{"kind", "prism"},        {"spline", name_of(prism.spline)},
                {"bottom", prism.bottom}, {"top", prism.top},
                {"capped", prism.capped}, {"outline", list_json(prism.outline)}};
    }
    Json operator()(const CompositeRef& c) const {
        const Composite& composite = scene_.composites[c.composite];
        const auto place = [](Json json, const Composite::Place& p) {
            json["parent"] = p.parent == none ? Json(nullptr) : Json(p.parent);
            json["first"] = p.first;
            return json;
        };
        Json nodes = Json::array();
        for (const Composite::Node& node : composite.nodes) {
            const char* kind = node.kind == Composite::Kind::unite       ? "union"
                               : node.kind == Composite::Kind::intersect ? "intersection"
                                                                         : "difference";
            nodes.push_back(place({{"kind", kind}}, node.place));
        }
        Json leaves = Json::array();
        for (const Composite::Leaf& leaf : composite.leaves) {
            Json json = place(object_json(scene_, leaf.object, sink_), leaf.place);
            json["texture_space"] = leaf.texture_space;
            leaves.push_back(std::move(json));
        }
        return {{"kind", "composite"}, {"nodes", nodes}, {"leaves", leaves}};
    }

  private:
    const Scene& scene_;
    PackSink& sink_;
};

}  // namespace

Json shape_json(const Scene& scene, const Object& object, PackSink& sink) {
    return std::visit(ShapeWriter(scene, sink), object.shape);
}

}  // namespace lancer::judge
