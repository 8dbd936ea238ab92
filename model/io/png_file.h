// PNG through libpng alone, so that plain use of Lancer loads nothing heavier.
#pragma once

#include <string>
#include <string_view>

#include "model/image.h"
#include "model/io/image_file.h"
#include "model/io/row_functions.h"

namespace lancer::io {

bool is_png(std::string_view bytes);

/// The whole file. The same picture gives the same bytes. 1 channel is grey, 3 are RGB, 4 are RGBA;
/// channels beyond are left out. Throws FileError naming `name`.
std::string encode_png(const Image& image, const ImageWriteOptions& options,
                       const std::string& name);

/// The same row by row: `row` is asked for each from the top, and what it gives holds until the
/// next; the pixels of `like` are not looked at. Throws what `row` and `add` throw too.
void encode_png(const Image& like, const ImageWriteOptions& options, const std::string& name,
                const RowOf& row, const AddBytes& add);

/// The curve that decode_png decodes this file's colours by: "sRGB", "linear" (gAMA 1), or a gAMA
/// chunk with its number, as "gAMA 0.45455". Empty when the file cannot be read.
std::string png_curve(std::string_view bytes);

/// A whole PNG with one more text chunk before its end. No picture depends on it.
std::string with_png_text(std::string png, const std::string& keyword, const std::string& text);

/// 1 channel (grey), 3 (RGB) or 4 (RGBA, grey with alpha too). Colour in linear light by the rules
/// POV-Ray 3.7 has: an sRGB chunk or none means the sRGB curve, for 16 bits too; a gAMA chunk alone
/// means its power law. Throws FileError naming `name`.
Image decode_png(std::string_view bytes, const std::string& name, ColorSpace space);

}  // namespace lancer::io
