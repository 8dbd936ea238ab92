// The format of a picture file, and its encoded bytes.
#pragma once

#include <string>

#include "model/io/image_file.h"

namespace lancer::io {

/// The format for writing, as the image module calls it, by the ending of the name. PNG for a
/// device or pipe without an ending. Empty for other endings.
std::string format_of_name(const std::string& path);

/// The bytes that write_image() would write. Throws FileError.
std::string encode_image(const std::string& path, const Image& image,
                         const ImageWriteOptions& options);

}  // namespace lancer::io
