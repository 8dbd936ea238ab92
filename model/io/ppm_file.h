// PPM and PGM, the simplest picture files there are (netpbm: ppm(5), pgm(5)).
#pragma once

#include <string>
#include <string_view>

#include "model/image.h"
#include "model/io/image_file.h"
#include "model/io/row_functions.h"

namespace lancer::io {

bool is_ppm(std::string_view bytes);

/// P6, 8 or 16 bits; grey becomes RGB, other channels are left out.
std::string encode_ppm(const Image& image, const ImageWriteOptions& options);

/// The same row by row, as encode_png() in png_file.h.
void encode_ppm(const Image& like, const ImageWriteOptions& options, const RowOf& row,
                const AddBytes& add);

/// P2, P3, P5 and P6: 1 channel or 3, decoded from sRGB. Throws FileError naming `name`.
Image decode_ppm(std::string_view bytes, const std::string& name, ColorSpace space);

}  // namespace lancer::io
