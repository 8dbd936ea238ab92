// Reads PLY: text, and binary in either byte order.
#pragma once

#include <string>
#include <string_view>

#include "model/io/polygon_soup.h"

namespace lancer::io {

/// Reads the vertices (x y z, normals nx ny nz, texture coordinates s t or u v or texture_u
/// texture_v) and the faces (the list vertex_indices or vertex_index). Scalar types and the order
/// of properties and elements are arbitrary; everything else is skipped (G. Turk, The PLY Polygon
/// File Format, 1994). Throws FileError, which names `name` and the line or byte.
PolygonSoup read_ply(std::string_view bytes, const std::string& name);

}  // namespace lancer::io
