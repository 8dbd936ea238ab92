// Image files as textures: what shading asks of them is checked where they are read.
#pragma once

#include <string>

#include "model/image.h"
#include "model/io/image_file.h"

namespace lancer::io {

/// read_image() with colour and alpha alone. Throws FileError, which names the pixel, when a value
/// is infinite or not a number.
Image read_texture(const std::string& path, ColorSpace space);

}  // namespace lancer::io
