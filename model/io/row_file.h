// Writes pictures that are larger than memory row by row, with the same bytes as write_image().
#pragma once

#include <functional>
#include <string>

#include "model/image.h"
#include "model/io/image_file.h"

namespace lancer::io {

/// Gives the next row, in the layout of Image::data.
using NextRow = std::function<void(double* pixels)>;

/// Writes the rows atomically, from the top, in the format of the name's ending. Only a few are
/// held at a time. For formats other than PNG and PPM, the picture library is loaded into this
/// process. Throws FileError, and what `next` throws; then no file is written.
///
/// \param like  a picture of the same form; its pixels are not used
void write_rows(const std::string& path, const Image& like, const ImageWriteOptions& options,
                const NextRow& next);

}  // namespace lancer::io
