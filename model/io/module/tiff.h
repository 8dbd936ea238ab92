// TIFF files read by libtiff, strip by strip or tile by tile.
#pragma once

#include <string>
#include <string_view>

#include "model/io/stored_image.h"

namespace lancer::io {

/// The first picture of the file: grey, RGB, palettes, CMYK (converted) and YCbCr, 1 to 16 bits and
/// floats, in planes too. Returns why it cannot be read; strips that end beyond the file and what
/// libtiff merely warns of while decoding are reasons. Empty when all is well.
std::string read_tiff(std::string_view bytes, PictureSink& sink);

}  // namespace lancer::io
