#include "reference/pov/mesh_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "reference/pov/choices.h"

namespace lancer::reference::pov {

namespace {

using Cell = std::array<double, 3>;

double mean_edge(const Mesh& mesh) {
    double sum = 0;
    for (const Mesh::Corners& face : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i)
            sum += length(mesh.vertices[face[i]] - mesh.vertices[face[(i + 1) % 3]]);
    return sum / (3 * static_cast<double>(mesh.faces.size()));
}

Vec3d middle(const Mesh& mesh, const Mesh::Corners& face) {
    return (mesh.vertices[face[0]] + mesh.vertices[face[1]] + mesh.vertices[face[2]]) / 3.0;
}

/// The faces of each cell as a mesh of their own, with their normals and colours.
///
/// \param cell_of  a function of the face's corners
template <class CellOf>
std::map<Cell, Mesh> sorted_into_cells(const Mesh& mesh, const CellOf& cell_of) {
    std::map<Cell, std::vector<std::size_t>> cells;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) cells[cell_of(mesh.faces[f])].push_back(f);
    // For a mesh without normals, the normals come from all its faces.
    const std::vector<Vec3d> normals = mesh.normals.empty() ? vertex_normals(mesh) : mesh.normals;
    const auto& normal_faces =
        mesh.normals.empty() || mesh.normal_faces.empty() ? mesh.faces : mesh.normal_faces;
    std::map<Cell, Mesh> pieces;
    for (const auto& [cell, faces] : cells) {
        Mesh& piece = pieces[cell];
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
                const std::uint32_t vertex = mesh.faces[f][i];
                corners[i] = index_in(vertices, vertex, mesh.vertices, piece.vertices);
                if (!mesh.colors.empty() && piece.colors.size() < piece.vertices.size())
                    piece.colors.push_back(mesh.colors[vertex]);
                const std::uint32_t normal = normal_faces[f][i];
                of_normals[i] =
                    normal == none ? none : index_in(kept_normals, normal, normals, piece.normals);
            }
            piece.faces.push_back(corners);
            piece.normal_faces.push_back(of_normals);
        }
        // Without a list, POV-Ray would compute normals from the piece's own faces.
        if (piece.normals.empty()) piece.normals.emplace_back(0.0);
    }
    return pieces;
}

/// The axis nearest to the face's normal: 0, 1 or 2.
int nearest_axis(const Mesh& mesh, const Mesh::Corners& face) {
    const Vec3d n = absolute(face_normal(mesh, face));
    return n.z >= n.x && n.z >= n.y ? 2 : n.x >= n.y ? 0 : 1;
}

/// The coordinates exchanged in a circle, so that `axis` becomes z.
Vec3d turned(const Vec3d& v, int axis) {
    return {v[(axis + 1) % 3], v[(axis + 2) % 3], v[axis]};
}

Affine<double> turn_back(int axis) {
    Affine<double> map;
    for (int i = 0; i < 3; ++i)
        map.rows[static_cast<std::size_t>((axis + 1 + i) % 3)] =
            Vec3d(i == 0 ? 1 : 0, i == 1 ? 1 : 0, i == 2 ? 1 : 0);
    return map;
}

}  // namespace

Vec3d face_normal(const Mesh& mesh, const Mesh::Corners& face) {
    const Vec3d& a = mesh.vertices[face[0]];
    return cross(mesh.vertices[face[1]] - a, mesh.vertices[face[2]] - a);
}

std::vector<Vec3d> vertex_normals(const Mesh& mesh) {
    std::vector<Vec3d> sum(mesh.vertices.size(), Vec3d(0.0));
    for (const Mesh::Corners& face : mesh.faces)
        for (const std::uint32_t corner : face) sum[corner] += face_normal(mesh, face);
    return sum;
}

std::vector<MeshPiece> pieces_by_place(const Mesh& mesh) {
    const double size = step_for(mean_edge(mesh) * edges_of_a_piece);
    std::vector<MeshPiece> pieces;
    for (auto& [cell, piece] : sorted_into_cells(mesh, [&](const Mesh::Corners& face) {
             const Vec3d at = middle(mesh, face) / size;
             return Cell{std::round(at.x), std::round(at.y), std::round(at.z)};
         }))
        pieces.push_back({std::move(piece)});
    return pieces;
}

bool has_upright_face(const Mesh& mesh) {
    return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Mesh::Corners& face) {
        const Vec3d n = absolute(face_normal(mesh, face));
        const bool leans = (n.x > 0) + (n.y > 0) + (n.z > 0) > 1;
        return leans && n.z < 0.1 * length(n);
    });
}

std::vector<MeshPiece> pieces_by_axis(const Mesh& mesh) {
    std::vector<MeshPiece> pieces;
    for (auto& [cell, piece] : sorted_into_cells(mesh, [&](const Mesh::Corners& face) {
             return Cell{static_cast<double>(nearest_axis(mesh, face)), 0, 0};
         })) {
        const int axis = static_cast<int>(cell[0]);
        for (Vec3d& v : piece.vertices) v = turned(v, axis);
        for (Vec3d& n : piece.normals) n = turned(n, axis);
        pieces.push_back({std::move(piece), turn_back(axis)});
    }
    return pieces;
}

}  // namespace lancer::reference::pov
