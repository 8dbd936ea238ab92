// Reads JPEG files with libjpeg.
#pragma once

#include <string>
#include <string_view>

#include "model/io/stored_image.h"

namespace lancer::io {

/// 8 bits, grey or RGB; CMYK is converted. Returns the reason when the file cannot be read,
/// otherwise an empty text. Damage that libjpeg would only warn about and fill in counts as a
/// reason, too.
std::string read_jpeg(std::string_view bytes, PictureSink& sink);

}  // namespace lancer::io
