#include "model/io/mesh_file.h"

#include <fmt/format.h>

#include "model/diagnostic.h"
#include "model/io/file.h"
#include "model/io/obj_reader.h"
#include "model/io/ply_reader.h"
#include "model/io/polygon_soup.h"
#include "model/io/stl_reader.h"

namespace lancer::io {

LoadedMesh read_mesh(const std::string& path) {
    return read_mesh(read_file(path), path);
}

LoadedMesh read_mesh(std::string_view bytes, const std::string& name) {
    const std::size_t dot = name.rfind('.');
    std::string ending = dot == std::string::npos ? "" : name.substr(dot + 1);
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (ending == "obj") return build_mesh(read_obj(bytes, name), name);
    if (ending == "ply") return build_mesh(read_ply(bytes, name), name);
    if (ending == "stl") return build_mesh(read_stl(bytes, name), name);
    throw FileError(fmt::format("cannot read '{}': a mesh file ends in .obj, .ply or .stl", name));
}

}  // namespace lancer::io
