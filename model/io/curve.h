// The curve by which a picture's file encodes its values.
#pragma once

#include <string>

namespace lancer::io {

/// What read_image decodes the colours of this file by: "sRGB", "linear", or of a PNG its gAMA
/// chunk with the number, as "gAMA 0.45455". For a file that read_image has read; empty when it
/// cannot be told, as of a pipe. Throws FileError when the file cannot be read.
std::string curve_of(const std::string& path);

}  // namespace lancer::io
