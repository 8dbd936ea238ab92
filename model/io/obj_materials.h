// Finds the materials of an OBJ file in the libraries that it names.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/io/mesh_file.h"
#include "model/io/mtl_reader.h"

namespace lancer::io {

struct ObjMaterials {
    /// One for each of LoadedMesh::materials; empty when no library has it. Image paths can be
    /// opened as they are.
    std::vector<std::optional<MtlMaterial>> materials;
    /// What could not be read, found or understood, one sentence each, with the file.
    std::vector<std::string> warnings;
};

/// Reads the file with this path. Throws FileError.
using ReadFile = std::function<std::string(const std::string& path)>;

/// Reads the libraries of a mesh that was loaded from `path`. Their names are relative to its
/// folder; image names are relative to the library's. The first library that defines a material is
/// used.
ObjMaterials find_materials(const LoadedMesh& loaded, const std::string& path,
                            const ReadFile& read_file);

}  // namespace lancer::io
