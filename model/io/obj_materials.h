// The materials of an OBJ file, looked up in the libraries that it names.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/io/mesh_file.h"
#include "model/io/mtl_reader.h"

namespace lancer::io {

struct ObjMaterials {
    /// One for each of LoadedMesh::materials; empty where no library has it. Paths of images are
    /// those that a file is opened by.
    std::vector<std::optional<MtlMaterial>> materials;
    /// What could not be read, found or understood, one sentence each with the file.
    std::vector<std::string> warnings;
};

/// Reads the file of a path. Throws FileError.
using ReadFile = std::function<std::string(const std::string& path)>;

/// Reads the libraries of a mesh that was loaded from `path`: names are relative to its folder,
/// those of images to their library's. The first library that has a material gives it.
ObjMaterials find_materials(const LoadedMesh& loaded, const std::string& path,
                            const ReadFile& read_file);

}  // namespace lancer::io
