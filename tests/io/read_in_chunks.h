// What reading an OBJ file gives, as text to compare.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "model/diagnostic.h"
#include "model/io/mesh_file.h"

namespace lancer::io {

/// All of the mesh, digit by digit, or the message of the mistake.
inline std::string told(std::string_view text, const MeshReading& reading) {
    std::string all;
    const auto add = [&](const auto&... parts) { ((all += fmt::format("{} ", parts)), ...); };
    const auto add_vectors = [&](const auto& list) {
        all += fmt::format("\n{}: ", list.size());
        for (const auto& vector : list)
            for (int k = 0; k < static_cast<int>(vector.length()); ++k)
                add(static_cast<double>(vector[k]));
    };
    const auto add_faces = [&](const std::vector<Mesh::Corners>& list) {
        all += fmt::format("\n{}: ", list.size());
        for (const auto& [a, b, c] : list) add(a, b, c);
    };
    try {
        const LoadedMesh loaded = read_mesh(text, "t.obj", reading);
        add_vectors(loaded.mesh.vertices);
        add_vectors(loaded.mesh.normals);
        add_vectors(loaded.mesh.uvs);
        add_vectors(loaded.mesh.colors);
        add_faces(loaded.mesh.faces);
        add_faces(loaded.mesh.normal_faces);
        add_faces(loaded.mesh.uv_faces);
        add(loaded.degenerate, loaded.face_materials.size());
        for (const std::uint32_t material : loaded.face_materials) add(material);
        for (const std::string& name : loaded.materials) add("material", name);
        for (const LibraryStatement& library : loaded.libraries) add(library.names, library.line);
        for (const std::string& warning : loaded.warnings) add("\n", warning);
    } catch (const FileError& error) {
        return error.what();
    }
    return all;
}

}  // namespace lancer::io
