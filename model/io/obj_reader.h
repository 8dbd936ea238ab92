// Reads Wavefront OBJ.
#pragma once

#include <string>
#include <string_view>

#include "model/io/polygon_soup.h"

namespace lancer::io {

/// Reads `v`, `vt`, `vn` and `f` (Wavefront, Advanced Visualizer manual, appendix B1); skips the
/// other statements of the format. Negative indices count back from the last element. Throws
/// FileError, which names `name` and the line, for an invalid or non-finite number, for a statement
/// that OBJ does not have, and for an index that is 0 or before the first.
PolygonSoup read_obj(std::string_view bytes, const std::string& name);

}  // namespace lancer::io
