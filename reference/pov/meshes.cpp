// Meshes and triangles. POV-Ray keeps mesh data in single precision, stand-alone triangles in
// double.
#include <fmt/format.h>

#include <algorithm>

#include "model/bodies.h"
#include "reference/pov/choices.h"
#include "reference/pov/materials.h"
#include "reference/pov/shapes.h"

namespace lancer::reference::pov {

namespace {

/// Twice the area long, at right angles to the face.
Vec3d face_normal(const Mesh& mesh, const Mesh::Corners& face) {
    const Vec3d& a = mesh.vertices[face[0]];
    return cross(mesh.vertices[face[1]] - a, mesh.vertices[face[2]] - a);
}

/// For a mesh that gives no normals: the mean of the faces round each vertex, weighted by area.
std::vector<Vec3d> vertex_normals(const Mesh& mesh) {
    std::vector<Vec3d> sum(mesh.vertices.size(), Vec3d(0.0));
    for (const Mesh::Corners& face : mesh.faces)
        for (const std::uint32_t corner : face) sum[corner] += face_normal(mesh, face);
    return sum;
}

/// A mesh2 in the making: lists of lines, each with its count.
struct Mesh2 {
    std::vector<std::string> vertices, normals, uvs, faces, normal_indices, uv_indices;
    Affine<double> place;  ///< to be applied to the vertices

    static std::string corners(const Mesh::Corners& c) {
        return fmt::format("<{},{},{}>", c[0], c[1], c[2]);
    }
    static void list(Text& text, const std::string& word, const std::vector<std::string>& items) {
        if (items.empty()) return;
        text.open(fmt::format("{} {{ {},", word, items.size()));
        text.list(items);
        text.close();
    }
    void write(Text& text, bool closed) const {
        list(text, "vertex_vectors", vertices);
        list(text, "normal_vectors", normals);
        list(text, "uv_vectors", uvs);
        list(text, "face_indices", faces);
        list(text, "uv_indices", uv_indices);
        list(text, "normal_indices", normal_indices);
        // Lets POV-Ray tell whether the camera is inside. It must stand before any transform.
        if (closed) text.line(fmt::format("inside_vector {}", way_out));
        const std::string moved = transform(place);
        if (!moved.empty()) text.line(moved);
    }
};

/// A face that lacks a normal at a corner is flat: it gets one of its own, behind the given list.
void add_normals(Mesh2& out, const Mesh& mesh) {
    const std::vector<Vec3d> normals = mesh.normals.empty() ? vertex_normals(mesh) : mesh.normals;
    const std::vector<Mesh::Corners>& indices =
        mesh.normals.empty() || mesh.normal_faces.empty() ? mesh.faces : mesh.normal_faces;
    const auto has_length = [](const Vec3d& n) { return length(n) > 0; };
    // One that no face has may be nought, which POV-Ray takes for some direction.
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

/// Where a mesh stands, in steps of about its size, so that subtracting it loses nothing: single
/// precision is then spent on the mesh alone, and a `translate` of double precision on its place.
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

MeshKey mesh_key(const MeshRef& shape, bool smooth, PowerOfTen own) {
    return {shape.mesh, own.exponent, smooth};
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
    const bool smooth = shape->smooth && writer.scene.settings.smooth;
    const MeshKey key = mesh_key(*shape, smooth, own);
    if (writer.mesh_names.contains(key)) return;
    const std::string name = fmt::format("Mesh{}", writer.mesh_names.size());
    writer.text.open(fmt::format("#declare {} = mesh2 {{  // {} vertices, {} faces", name,
                                 mesh.vertices.size(), mesh.faces.size()));
    convert(mesh, smooth, own).write(writer.text, is_closed(mesh));
    writer.text.close();
    writer.mesh_names.emplace(key, name);
}

bool open_mesh(Writer& writer, const Object&, const MeshRef& shape, PowerOfTen own) {
    const bool smooth = shape.smooth && writer.scene.settings.smooth;
    writer.text.open("object { " + writer.mesh_names.at(mesh_key(shape, smooth, own)));
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
    // A smooth_triangle on its own is dropped when its normals point to different sides; within a
    // mesh it is not.
    Mesh mesh;
    mesh.vertices.assign(shape.points.begin(), shape.points.end());
    mesh.faces = {{0, 1, 2}};
    if (smooth) mesh.normals.assign(attributes->normals->begin(), attributes->normals->end());
    if (mapped) mesh.uvs.assign(attributes->uvs->begin(), attributes->uvs->end());
    writer.text.open("mesh2 {");
    convert(mesh, smooth, own).write(writer.text, is_closed(mesh));
    return true;
}

}  // namespace lancer::reference::pov
