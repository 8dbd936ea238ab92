// Reads TIFF files with libtiff, strip by strip or tile by tile.
#pragma once

#include <string>
#include <string_view>

#include "model/io/stored_image.h"

namespace lancer::io {

/// Reads the first picture of the file: grey, RGB, palettes, CMYK (converted) and YCbCr, 1 to 16
/// bits and floats, also in separate planes. Returns the reason when it cannot be read, otherwise
/// an empty text. Strips that end after the file, and warnings of libtiff while decoding, count as
/// reasons.
std::string read_tiff(std::string_view bytes, PictureSink& sink);

}  // namespace lancer::io
