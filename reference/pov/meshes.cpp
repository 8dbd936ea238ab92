// Meshes and triangles. POV-Ray stores mesh data in single precision and separate triangles in
// double.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "model/bodies.h"
#include "reference/pov/choices.h"
#include "reference/pov/materials.h"
#include "reference/pov/shapes.h"

namespace lancer::reference::pov {

namespace {

/// A normal whose length is twice the area of the face.
Vec3d face_normal(const Mesh& mesh, const Mesh::Corners& face) {
    const Vec3d& a = mesh.vertices[face[0]];
    return cross(mesh.vertices[face[1]] - a, mesh.vertices[face[2]] - a);
}

/// For a mesh without normals: the mean normal of the faces around each vertex, weighted by area.
std::vector<Vec3d> vertex_normals(const Mesh& mesh) {
    std::vector<Vec3d> sum(mesh.vertices.size(), Vec3d(0.0));
    for (const Mesh::Corners& face : mesh.faces)
        for (const std::uint32_t corner : face) sum[corner] += face_normal(mesh, face);
    return sum;
}

/// A mesh2 that is being built: lists of lines, each with its count.
struct Mesh2 {
    std::vector<std::string> vertices, normals, uvs, faces, normal_indices, uv_indices;
    std::vector<Color> colors;  ///< each once; faces refer to them
    Affine<double> place;       ///< to be applied to the vertices

    static std::string corners(const Mesh::Corners& c) {
        return fmt::format("<{},{},{}>", c[0], c[1], c[2]);
    }
    static void list(Text& text, const std::string& word, const std::vector<std::string>& items) {
        if (items.empty()) return;
        text.open(fmt::format("{} {{ {},", word, items.size()));
        text.list(items);
        text.close();
    }
    /// \param material  the one with vertex colours, or null
    void write(Writer& writer, bool closed, const Material* material) const {
        Text& text = writer.text;
        list(text, "vertex_vectors", vertices);
        list(text, "normal_vectors", normals);
        list(text, "uv_vectors", uvs);
        if (material != nullptr) write_vertex_textures(writer, *material, colors);
        list(text, "face_indices", faces);
        list(text, "uv_indices", uv_indices);
        list(text, "normal_indices", normal_indices);
        // With inside_vector, POV-Ray can tell whether the camera is inside. It must precede any
        // transform.
        if (closed) text.line(fmt::format("inside_vector {}", way_out));
        const std::string moved = transform(place);
        if (!moved.empty()) text.line(moved);
    }
};

/// A face without a normal at some corner is flat: it gets a normal of its own, after the given
/// list.
void add_normals(Mesh2& out, const Mesh& mesh) {
    const std::vector<Vec3d> normals = mesh.normals.empty() ? vertex_normals(mesh) : mesh.normals;
    const std::vector<Mesh::Corners>& indices =
        mesh.normals.empty() || mesh.normal_faces.empty() ? mesh.faces : mesh.normal_faces;
    const auto has_length = [](const Vec3d& n) { return length(n) > 0; };
    // A normal that no face uses may be zero; POV-Ray accepts it.
    const auto add = [&](const Vec3d& n) {
        out.normals.push_back(mesh_vector(has_length(n) ? normalize(n) : n));
    };
    for (const Vec3d& n : normals) add(n);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        Mesh::Corners corners = indices[f];
        const bool complete = std::all_of(corners.begin(), corners.end(), [&](std::uint32_t c) {
            return c != none && has_length(normals[c]);
        });
        if (!complete) {
            corners.fill(static_cast<std::uint32_t>(out.normals.size()));
            add(face_normal(mesh, mesh.faces[f]));
        }
        out.normal_indices.push_back(Mesh2::corners(corners));
    }
}

void add_uvs(Mesh2& out, const Mesh& mesh) {
    for (const Vec2d& uv : mesh.uvs) out.uvs.push_back(mesh_vector(uv));
    for (const Mesh::Corners& face : mesh.uv_faces.empty() ? mesh.faces : mesh.uv_faces)
        out.uv_indices.push_back(Mesh2::corners(face));
}

/// Refers to the colours at each face's corners. POV-Ray shades the whole face in each of the three
/// colours and interpolates the results with the same weights.
void add_colors(Mesh2& out, const Mesh& mesh) {
    std::map<std::array<double, 3>, std::size_t> numbers;
    std::vector<std::size_t> of_vertex;
    for (const Color& color : mesh.colors) {
        const auto [at, is_new] =
            numbers.try_emplace({color.x, color.y, color.z}, out.colors.size());
        if (is_new) out.colors.push_back(color);
        of_vertex.push_back(at->second);
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (const std::uint32_t corner : mesh.faces[f])
            out.faces[f] += fmt::format(",{}", of_vertex[corner]);
}

/// The mesh's position in multiples of about its size, so that subtracting it is exact. Then the
/// mesh alone uses single precision, and a `translate` in double precision moves it to its place.
Vec3d coarse_place(const Mesh& mesh, PowerOfTen own) {
    Bounds bounds;
    for (const Vec3d& p : mesh.vertices) bounds.add(own.plainly(p));
    const double step = step_for(bounds.diagonal());
    const Vec3d steps = bounds.center() / step;
    return Vec3d(std::round(steps.x), std::round(steps.y), std::round(steps.z)) * step;
}

Mesh2 convert(const Mesh& mesh, bool smooth, PowerOfTen own) {
    Mesh2 out;
    out.place.shift = coarse_place(mesh, own);
    for (const Vec3d& p : mesh.vertices)
        out.vertices.push_back(mesh_vector(own.plainly(p) - out.place.shift));
    for (const Mesh::Corners& face : mesh.faces) out.faces.push_back(Mesh2::corners(face));
    if (smooth) add_normals(out, mesh);
    if (is_mapped(mesh)) add_uvs(out, mesh);
    return out;
}

double mean_edge(const Mesh& mesh) {
    double sum = 0;
    for (const Mesh::Corners& face : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i)
            sum += length(mesh.vertices[face[i]] - mesh.vertices[face[(i + 1) % 3]]);
    return sum / (3 * static_cast<double>(mesh.faces.size()));
}

/// Sorts the faces into cubes whose size is a few edges.
std::vector<Mesh> pieces_of(const Mesh& mesh) {
    const double cell = step_for(mean_edge(mesh) * edges_of_a_piece);
    std::map<std::array<double, 3>, std::vector<std::size_t>> cells;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const Mesh::Corners& face = mesh.faces[f];
        const Vec3d middle =
            (mesh.vertices[face[0]] + mesh.vertices[face[1]] + mesh.vertices[face[2]]) / 3.0;
        cells[{std::round(middle.x / cell), std::round(middle.y / cell),
               std::round(middle.z / cell)}]
            .push_back(f);
    }
    std::vector<Mesh> pieces;
    // For a mesh without normals, the normals come from all its faces.
    const std::vector<Vec3d> normals = mesh.normals.empty() ? vertex_normals(mesh) : mesh.normals;
    const auto& normal_faces =
        mesh.normals.empty() || mesh.normal_faces.empty() ? mesh.faces : mesh.normal_faces;
    for (const auto& [place, faces] : cells) {
        Mesh piece;
        std::map<std::uint32_t, std::uint32_t> vertices;
        std::map<std::uint32_t, std::uint32_t> kept_normals;
        const auto index_in = [](auto& indices, std::uint32_t old, const auto& from, auto& to) {
            const auto [at, is_new] =
                indices.try_emplace(old, static_cast<std::uint32_t>(to.size()));
            if (is_new) to.push_back(from[old]);
            return at->second;
        };
        for (const std::size_t f : faces) {
            Mesh::Corners corners{};
            Mesh::Corners of_normals{};
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = index_in(vertices, mesh.faces[f][i], mesh.vertices, piece.vertices);
                const std::uint32_t normal = normal_faces[f][i];
                of_normals[i] =
                    normal == none ? none : index_in(kept_normals, normal, normals, piece.normals);
            }
            piece.faces.push_back(corners);
            piece.normal_faces.push_back(of_normals);
        }
        // Without a list, POV-Ray would compute normals from the piece's own faces.
        if (piece.normals.empty()) piece.normals.emplace_back(0.0);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// POV-Ray stores the plane of a triangle in single precision. In a large mesh of small triangles,
/// a shadow ray that grazes one therefore meets it again, further away than the distance at which
/// POV-Ray drops hits. Pieces that are each near their own origin avoid this. Pieces have no
/// inside, so a mesh that light enters stays whole.
bool is_in_pieces(const Writer& writer, const Object& object, const Mesh& mesh) {
    return !writer.in_composite && mesh.faces.size() > most_faces_of_a_piece && !is_mapped(mesh) &&
           !is_of_vertices(writer.scene, writer.scene.materials[object.material]) &&
           !lets_light_pass(writer.scene, writer.scene.materials[object.material]);
}

MeshKey mesh_key(const Writer& writer, const Object& object, const MeshRef& shape, PowerOfTen own) {
    const bool colored = is_of_vertices(writer.scene, writer.scene.materials[object.material]);
    return {shape.mesh,
            own.exponent,
            shape.smooth && writer.scene.settings.smooth,
            is_in_pieces(writer, object, *writer.scene.meshes[shape.mesh]),
            colored ? object.material : none,
            shape.inside};
}

}  // namespace

bool is_mapped(const Mesh& mesh) {
    const auto lacks_uv = [](const Mesh::Corners& corners) {
        return std::find(corners.begin(), corners.end(), none) != corners.end();
    };
    return !mesh.uvs.empty() && std::none_of(mesh.uv_faces.begin(), mesh.uv_faces.end(), lacks_uv);
}

void declare_mesh(Writer& writer, const Object& object, PowerOfTen own) {
    const auto* shape = std::get_if<MeshRef>(&object.shape);
    if (!shape) return;
    const Mesh& mesh = *writer.scene.meshes[shape->mesh];
    const MeshKey key = mesh_key(writer, object, *shape, own);
    if (writer.mesh_names.contains(key)) return;
    const bool smooth = std::get<2>(key);
    const bool in_pieces = std::get<3>(key);
    const std::string name = fmt::format("Mesh{}", writer.mesh_names.size());
    writer.text.open(fmt::format("#declare {} = {} {{  // {} vertices, {} faces", name,
                                 in_pieces ? "union" : "mesh2", mesh.vertices.size(),
                                 mesh.faces.size()));
    const std::uint32_t material = std::get<4>(key);
    if (!in_pieces) {
        Mesh2 whole = convert(mesh, smooth, own);
        if (material != none) add_colors(whole, mesh);
        whole.write(writer, is_body(writer.scene, *shape),
                    material != none ? &writer.scene.materials[material] : nullptr);
    }
    if (in_pieces)
        for (const Mesh& piece : pieces_of(mesh)) {
            writer.text.open("mesh2 {");
            convert(piece, smooth, own).write(writer, false, nullptr);
            writer.text.close();
        }
    writer.text.close();
    writer.mesh_names.emplace(key, name);
}

bool open_mesh(Writer& writer, const Object& object, const MeshRef& shape, PowerOfTen own) {
    writer.text.open("object { " + writer.mesh_names.at(mesh_key(writer, object, shape, own)));
    return true;
}

bool open_triangle(Writer& writer, const Object& object, const Triangle& shape, PowerOfTen own) {
    const Scene& scene = writer.scene;
    const TriangleAttributes* attributes =
        shape.attributes == none ? nullptr : &scene.triangle_attributes[shape.attributes];
    const bool smooth = attributes && attributes->normals && scene.settings.smooth;
    const bool mapped =
        attributes && attributes->uvs && depends_on_shape(scene, scene.materials[object.material]);
    if (!smooth && !mapped) {
        std::string corners;
        for (const Vec3d& p : shape.points)
            corners += (corners.empty() ? "" : ", ") + vector(own(p));
        writer.text.open("triangle { " + corners);
        return true;
    }
    // POV-Ray drops a single smooth_triangle whose normals point to different sides, but keeps it
    // within a mesh.
    Mesh mesh;
    mesh.vertices.assign(shape.points.begin(), shape.points.end());
    mesh.faces = {{0, 1, 2}};
    if (smooth) mesh.normals.assign(attributes->normals->begin(), attributes->normals->end());
    if (mapped) mesh.uvs.assign(attributes->uvs->begin(), attributes->uvs->end());
    writer.text.open("mesh2 {");
    convert(mesh, smooth, own).write(writer, is_closed(mesh), nullptr);
    return true;
}

}  // namespace lancer::reference::pov
