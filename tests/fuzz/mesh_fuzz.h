// What must hold for every mesh that a reader accepts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "model/diagnostic.h"
#include "model/io/degenerate.h"
#include "model/io/mesh_file.h"

namespace lancer::io {

inline void require(bool condition) {
    if (!condition) std::abort();
}

inline void require_indices(const std::vector<Mesh::Corners>& faces, std::size_t count,
                            bool none_allowed) {
    for (const Mesh::Corners& face : faces) {
        for (const std::uint32_t corner : face) {
            require(corner < count || (none_allowed && corner == none));
        }
    }
}

/// Reads the bytes as a file of this name: a valid mesh or a FileError that names it.
inline int fuzz_mesh(const std::uint8_t* data, std::size_t size, const char* name) {
    try {
        const Mesh mesh =
            read_mesh(std::string_view(reinterpret_cast<const char*>(data), size), name).mesh;
        for (const Vec3d& vertex : mesh.vertices) require(is_finite(vertex));
        for (const Vec3d& normal : mesh.normals) require(is_finite(normal));
        require_indices(mesh.faces, mesh.vertices.size(), false);
        require_indices(mesh.normal_faces, mesh.normals.size(), true);
        require_indices(mesh.uv_faces, mesh.uvs.size(), true);
        require(mesh.normal_faces.empty() || mesh.normal_faces.size() == mesh.faces.size());
        require(mesh.uv_faces.empty() || mesh.uv_faces.size() == mesh.faces.size());
        for (const auto& [a, b, c] : mesh.faces) {
            require(!is_degenerate(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]));
        }
        if (mesh.normal_faces.empty() && !mesh.normals.empty()) {
            require_indices(mesh.faces, mesh.normals.size(), false);
        }
        if (mesh.uv_faces.empty() && !mesh.uvs.empty()) {
            require_indices(mesh.faces, mesh.uvs.size(), false);
        }
    } catch (const FileError& error) {
        require(std::string_view(error.what()).starts_with(name));
    }
    return 0;
}

}  // namespace lancer::io
