// PNG with libpng alone, so that ordinary use of Lancer loads no larger library.
#pragma once

#include <string>
#include <string_view>

#include "model/image.h"
#include "model/io/image_file.h"
#include "model/io/row_functions.h"
#include "model/io/stored_image.h"

namespace lancer::io {

bool is_png(std::string_view bytes);

/// Encodes a whole file. The same picture gives the same bytes. 1 channel is grey, 3 are RGB, 4 are
/// RGBA; other channels are dropped. Throws FileError, which names `name`.
std::string encode_png(const Image& image, const ImageWriteOptions& options,
                       const std::string& name);

/// The same for encoded rows: `shape` is that of a RowEncoder with these options. Also throws what
/// `row` and `add` throw.
void encode_png(const StoredShape& shape, const ImageWriteOptions& options, const std::string& name,
                const RowOf& row, const AddBytes& add);

/// The curve by which decode_png() decodes this file's colours: "sRGB", "linear" (gAMA 1), or the
/// value of a gAMA chunk, as "gAMA 0.45455". Empty when the file cannot be read.
std::string png_curve(std::string_view bytes);

/// Adds a text chunk before the end of a PNG. It does not change the picture.
std::string with_png_text(std::string png, const std::string& keyword, const std::string& text);

/// 1 channel (grey), 3 (RGB) or 4 (RGBA, or grey with alpha). Colours are linear light by the rules
/// of POV-Ray 3.7: an sRGB chunk or none means the sRGB curve, also for 16 bits; a gAMA chunk alone
/// means its power law. Throws FileError, which names `name`.
Image decode_png(std::string_view bytes, const std::string& name, ColorSpace space);

}  // namespace lancer::io
