// Pictures larger than memory: written row by row, the same bytes as write_image() writes.
#pragma once

#include <functional>
#include <string>

#include "model/image.h"
#include "model/io/image_file.h"

namespace lancer::io {

/// Gives the next row, as it stands in Image::data.
using NextRow = std::function<void(double* pixels)>;

/// Writes the rows atomically, from the top, in the format that the name asks for. Only a few are
/// held at a time, but for formats other than PNG and PPM the picture library is loaded into this
/// process. Throws FileError, and what `next` throws; then nothing is written.
///
/// \param like  a picture of the same shape; its pixels are not looked at
void write_rows(const std::string& path, const Image& like, const ImageWriteOptions& options,
                const NextRow& next);

}  // namespace lancer::io
