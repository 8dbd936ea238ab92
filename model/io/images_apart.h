// Reads and writes pictures in the formats that only the picture process handles.
#pragma once

#include <string>

#include "model/image.h"
#include "model/io/image_file.h"
#include "model/io/row_functions.h"
#include "model/io/stored_image.h"

namespace lancer::io {

/// Reads the picture from the file that is open as `input`. `format` is that of work_on_picture().
/// Throws FileError, whose message names `path`.
Image read_apart(const std::string& path, const std::string& format, int input, ColorSpace space);

/// The bytes of a file with these rows. Throws FileError, whose message names `path`.
std::string encode_apart(const StoredShape& shape, const RowOf& row, const std::string& format,
                         const std::string& path);

}  // namespace lancer::io
