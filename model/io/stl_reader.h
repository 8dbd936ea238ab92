// STL, text and binary.
#pragma once

#include <string>
#include <string_view>

#include "model/io/polygon_soup.h"

namespace lancer::io {

/// Corners at exactly the same place become one vertex, so a closed surface is closed. Normals are
/// not read: those of the format are the triangles' own. A file is binary when its length is the
/// one that its number of triangles asks for, whatever it begins with (3D Systems,
/// StereoLithography Interface Specification, 1989); bytes behind the triangles are a warning.
/// Throws FileError naming `name` and the line or
/// byte.
PolygonSoup read_stl(std::string_view bytes, const std::string& name);

}  // namespace lancer::io
