// PPM and PGM, the simplest picture formats (netpbm: ppm(5), pgm(5)).
#pragma once

#include <string>
#include <string_view>

#include "model/image.h"
#include "model/io/image_file.h"
#include "model/io/row_functions.h"
#include "model/io/stored_image.h"

namespace lancer::io {

bool is_ppm(std::string_view bytes);

/// Encodes P6 with 8 or 16 bits, row by row.
void encode_ppm(const StoredShape& shape, const RowOf& row, const AddBytes& add);

/// Decodes P2, P3, P5 and P6 from sRGB: 1 or 3 channels. Throws FileError, which names `name`.
Image decode_ppm(std::string_view bytes, const std::string& name, ColorSpace space);

}  // namespace lancer::io
