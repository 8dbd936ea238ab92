// The transfer curve of a picture file.
#pragma once

#include <string>

namespace lancer::io {

/// The curve by which read_image() decodes the colours of this file: "sRGB", "linear", or for a PNG
/// the value of its gAMA chunk, as "gAMA 0.45455". The file must be one that read_image() has read.
/// Empty when the curve is not known, as for a pipe. Throws FileError when the file cannot be read.
std::string curve_of(const std::string& path);

}  // namespace lancer::io
