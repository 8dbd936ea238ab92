// Reads STL, text and binary.
#pragma once

#include <string>
#include <string_view>

#include "model/io/polygon_soup.h"

namespace lancer::io {

/// Corners at exactly the same place become one vertex, so that a closed surface stays closed. The
/// format's normals are those of the triangles and are ignored. A file is binary when its length
/// fits its number of triangles, whatever its first bytes are (3D Systems, StereoLithography
/// Interface Specification, 1989). Bytes after the triangles cause a warning. Throws FileError,
/// which names `name` and the line or byte.
PolygonSoup read_stl(std::string_view bytes, const std::string& name);

}  // namespace lancer::io
