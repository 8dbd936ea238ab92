// JPEG files read by libjpeg.
#pragma once

#include <string>
#include <string_view>

#include "model/io/stored_image.h"

namespace lancer::io {

/// 8 bits, grey or RGB; CMYK is converted. Returns why the file cannot be read; damage that libjpeg
/// would only warn of and paint over is a reason, too. Empty when all is well.
std::string read_jpeg(std::string_view bytes, PictureSink& sink);

}  // namespace lancer::io
