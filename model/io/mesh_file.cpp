#include "model/io/mesh_file.h"

#include <fmt/format.h>

#include <functional>

#include "model/diagnostic.h"
#include "model/io/file.h"
#include "model/io/obj_reader.h"
#include "model/io/ply_reader.h"
#include "model/io/polygon_soup.h"
#include "model/io/stl_reader.h"

namespace lancer::io {

namespace {

/// Calls `is_read` when the bytes are not needed any more.
LoadedMesh read(std::string_view bytes, const std::string& name, const MeshReading& reading,
                const std::function<void()>& is_read) {
    const std::size_t dot = name.rfind('.');
    std::string ending = dot == std::string::npos ? "" : name.substr(dot + 1);
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    PolygonSoup soup;
    if (ending == "obj") {
        std::vector<ObjChunk> chunks = read_obj(bytes, name, reading);
        is_read();
        soup = join_obj(std::move(chunks));
    } else if (ending == "ply") {
        soup = read_ply(bytes, name);
        is_read();
    } else if (ending == "stl") {
        soup = read_stl(bytes, name);
        is_read();
    } else {
        throw FileError(
            fmt::format("cannot read '{}': a mesh file ends in .obj, .ply or .stl", name));
    }
    return build_mesh(std::move(soup), name);
}

}  // namespace

LoadedMesh read_mesh(const std::string& path, const MeshReading& reading) {
    std::string bytes = read_file(path);
    return read(bytes, path, reading, [&] { std::string().swap(bytes); });
}

LoadedMesh read_mesh(std::string_view bytes, const std::string& name, const MeshReading& reading) {
    return read(bytes, name, reading, [] {});
}

}  // namespace lancer::io
