// Checks for damage that the picture libraries do not detect, or only after allocating gigabytes.
#pragma once

#include <string>
#include <string_view>

namespace lancer::io {

/// Why these bytes are not a complete JPEG file; empty when they are. libjpeg itself fills in
/// whatever is missing from a truncated file.
std::string jpeg_problem(std::string_view bytes);

/// Why these bytes have no valid EXR header; empty when they do. OpenEXR trusts the lengths and
/// sizes in the header.
std::string exr_problem(std::string_view bytes);

}  // namespace lancer::io
