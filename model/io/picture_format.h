// Which format a picture file has, and its bytes before they are in a file.
#pragma once

#include <string>

#include "model/io/image_file.h"

namespace lancer::io {

/// The format to write, by the name that the image module knows: by the ending of the name; PNG for
/// a device or pipe that has none. Empty for other endings.
std::string format_of_name(const std::string& path);

/// The bytes that write_image() would write. Throws FileError.
std::string encode_image(const std::string& path, const Image& image,
                         const ImageWriteOptions& options);

}  // namespace lancer::io
