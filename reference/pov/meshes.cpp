// Meshes and triangles. POV-Ray stores mesh data in single precision and separate triangles in
// double.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "model/bodies.h"
#include "reference/pov/choices.h"
#include "reference/pov/materials.h"
#include "reference/pov/mesh_pieces.h"
#include "reference/pov/shapes.h"

namespace lancer::reference::pov {

namespace {

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

double largest_difference(const Vec3d& a, const Vec3d& b) {
    return max_component(absolute(a - b));
}

/// POV-Ray takes a face for flat, and ignores its normals, if the components of all three differ by
/// less than this.
constexpr double equal_normals = 1e-5;

/// Whether POV-Ray would show the face flat though its normals, all unit, are not the face's own.
bool is_taken_for_flat(const std::array<Vec3d, 3>& normals, const Vec3d& face) {
    if (!(length(face) > 0) || largest_difference(normals[0], normalize(face)) < equal_normals / 10)
        return false;
    return largest_difference(normals[0], normals[1]) < equal_normals &&
           largest_difference(normals[0], normals[2]) < equal_normals;
}

/// The unit normal n turned by half as much again as POV-Ray takes for nothing.
Vec3d turned_a_little(const Vec3d& n) {
    Vec3d axis(0.0);
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(n[i]) < std::abs(n[least])) least = i;
    axis[least] = 1;
    return normalize(n + 1.5 * equal_normals * normalize(axis - n * n[least]));
}

/// Adds the normals of the mesh. A face without a normal at some corner is flat: it gets a normal
/// of its own, after the given list.
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
        } else if (std::array<Vec3d, 3> at{normalize(normals[corners[0]]),
                                           normalize(normals[corners[1]]),
                                           normalize(normals[corners[2]])};
                   is_taken_for_flat(at, face_normal(mesh, mesh.faces[f]))) {
            corners[2] = static_cast<std::uint32_t>(out.normals.size());
            add(turned_a_little(at[2]));
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

Mesh2 mesh2_of(const Mesh& mesh, bool smooth, PowerOfTen own) {
    Mesh2 out;
    out.place.shift = coarse_place(mesh, own);
    for (const Vec3d& p : mesh.vertices)
        out.vertices.push_back(mesh_vector(own.plainly(p) - out.place.shift));
    for (const Mesh::Corners& face : mesh.faces) out.faces.push_back(Mesh2::corners(face));
    if (smooth) add_normals(out, mesh);
    if (is_mapped(mesh)) add_uvs(out, mesh);
    return out;
}

/// POV-Ray stores the plane of a triangle in single precision. In a large mesh of small triangles,
/// a shadow ray that grazes one therefore meets it again, further away than the distance at which
/// POV-Ray drops hits. Pieces that are each near their own origin avoid this. A mesh with colours
/// of vertices has other pieces: has_upright_face(). Pieces have no inside, so a mesh that light
/// enters stays whole.
bool is_in_pieces(const Writer& writer, const Object& object, const Mesh& mesh) {
    const Material& material = writer.scene.materials[object.material];
    if (writer.in_composite || lets_light_pass(writer.scene, material)) return false;
    if (is_of_vertices(writer.scene, material)) return has_upright_face(mesh);
    return mesh.faces.size() > most_faces_of_a_piece && !is_mapped(mesh);
}

/// \param back  turns the mesh to its place
void write_mesh(Writer& writer, const Mesh& mesh, const Affine<double>& back, bool smooth,
                PowerOfTen own, bool closed, const Material* material) {
    Mesh2 out = mesh2_of(mesh, smooth, own);
    if (material != nullptr) add_colors(out, mesh);
    out.place = compose(back, out.place);
    out.write(writer, closed, material);
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
    const std::uint32_t colored = std::get<4>(key);
    const Material* material = colored == none ? nullptr : &writer.scene.materials[colored];
    if (!in_pieces)
        write_mesh(writer, mesh, {}, smooth, own, is_body(writer.scene, *shape), material);
    if (in_pieces)
        for (const MeshPiece& piece : material ? pieces_by_axis(mesh) : pieces_by_place(mesh)) {
            writer.text.open("mesh2 {");
            write_mesh(writer, piece.mesh, piece.back, smooth, own, false, material);
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
    mesh2_of(mesh, smooth, own).write(writer, is_closed(mesh), nullptr);
    return true;
}

}  // namespace lancer::reference::pov
