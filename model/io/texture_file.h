// Reads image files for textures, and checks what shading requires of them.
#pragma once

#include <string>

#include "model/image.h"
#include "model/io/image_file.h"

namespace lancer::io {

/// read_image() with colour and alpha only. Throws FileError, which names the pixel, when a value
/// is infinite or NaN.
Image read_texture(const std::string& path, ColorSpace space);

}  // namespace lancer::io
