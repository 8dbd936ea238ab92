#include "model/mesh_pieces.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/math.h"

namespace lancer {
namespace {

/// Copies the elements that the faces of each piece use, numbered in the order of use.
template <class Attribute>
class Compactor {
  public:
    explicit Compactor(const std::vector<Attribute>& from) : from_(from) {}

    /// Copies the faces `which` of `faces`; their indices into `from` become indices into `to`.
    void compact(const std::vector<Mesh::Corners>& faces, std::span<const std::uint32_t> which,
                 std::vector<Attribute>& to, std::vector<Mesh::Corners>& to_faces) {
        number_.resize(from_.size(), none);
        for (const std::uint32_t face : which) {
            Mesh::Corners corners = faces[face];
            for (std::uint32_t& corner : corners) {
                if (corner == none) continue;
                std::uint32_t& number = number_[corner];
                if (number == none) {
                    number = static_cast<std::uint32_t>(to.size());
                    to.push_back(from_[corner]);
                    used_.push_back(corner);
                }
                corner = number;
            }
            to_faces.push_back(corners);
        }
        for (const std::uint32_t corner : used_) number_[corner] = none;
        used_.clear();
        if (to.empty()) to_faces.clear();  // all corners are `none`
    }

  private:
    const std::vector<Attribute>& from_;
    std::vector<std::uint32_t> number_;
    std::vector<std::uint32_t> used_;
};

}  // namespace

std::vector<Mesh> split(const Mesh& mesh, std::span<const std::uint32_t> numbers,
                        std::uint32_t count) {
    assert(numbers.size() == mesh.faces.size());
    std::vector<std::vector<std::uint32_t>> faces_of(count);
    for (std::uint32_t face = 0; face < numbers.size(); ++face)
        faces_of[numbers[face]].push_back(face);
    Compactor<Vec3d> vertices(mesh.vertices);
    Compactor<Vec3d> normals(mesh.normals);
    Compactor<Vec2d> uvs(mesh.uvs);
    Compactor<Vec3d> colors(mesh.colors);
    const auto& normal_faces = mesh.normal_faces.empty() ? mesh.faces : mesh.normal_faces;
    const auto& uv_faces = mesh.uv_faces.empty() ? mesh.faces : mesh.uv_faces;
    std::vector<Mesh> pieces(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        Mesh& piece = pieces[i];
        vertices.compact(mesh.faces, faces_of[i], piece.vertices, piece.faces);
        if (!mesh.normals.empty())
            normals.compact(normal_faces, faces_of[i], piece.normals, piece.normal_faces);
        if (!mesh.uvs.empty()) uvs.compact(uv_faces, faces_of[i], piece.uvs, piece.uv_faces);
        std::vector<Mesh::Corners> as_vertices;
        if (!mesh.colors.empty())
            colors.compact(mesh.faces, faces_of[i], piece.colors, as_vertices);
        if (piece.normal_faces == piece.faces) piece.normal_faces = {};
        if (piece.uv_faces == piece.faces) piece.uv_faces = {};
    }
    return pieces;
}

Mesh with_averaged_normals(const Mesh& mesh) {
    assert(mesh.normals.empty());
    double largest = 0;
    for (const Vec3d& v : mesh.vertices) largest = std::max(largest, max_component(absolute(v)));
    // Scaling by powers of two causes no overflow and no rounding.
    const int exponent = largest > 0 ? -std::ilogb(largest) : 0;
    const auto scaled = [exponent](const Vec3d& v) {
        return Vec3d(std::ldexp(v.x, exponent), std::ldexp(v.y, exponent),
                     std::ldexp(v.z, exponent));
    };
    Mesh result = mesh;
    result.normals.assign(mesh.vertices.size(), Vec3d(0.0));
    for (const Mesh::Corners& face : mesh.faces) {
        const Vec3d a = scaled(mesh.vertices[face[0]]);
        const Vec3d twice_area =
            cross(scaled(mesh.vertices[face[1]]) - a, scaled(mesh.vertices[face[2]]) - a);
        for (const std::uint32_t corner : face) result.normals[corner] += twice_area;
    }
    for (Vec3d& normal : result.normals) {
        const double size = max_component(absolute(normal));
        if (size > 0) normal = normalize(normal / size);
    }
    return result;
}

}  // namespace lancer
