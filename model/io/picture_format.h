// The format of a picture file, and its encoded bytes.
#pragma once

#include <string>

#include "model/io/image_file.h"
#include "model/io/row_functions.h"
#include "model/io/stored_image.h"

namespace lancer::io {

/// The format for writing, as the image module calls it, by the ending of the name. PNG for a
/// device or pipe without an ending. Empty for other endings.
std::string format_of_name(const std::string& path);

/// The bytes that write_image() would write. Throws FileError.
std::string encode_image(const std::string& path, const Image& image,
                         const ImageWriteOptions& options);
/// Both for encoded rows: `shape` is that of a RowEncoder for this format and these options.
std::string encode_image(const std::string& path, const StoredShape& shape, const RowOf& row,
                         const ImageWriteOptions& options);
void write_image(const std::string& path, const StoredShape& shape, const RowOf& row,
                 const ImageWriteOptions& options);

}  // namespace lancer::io
