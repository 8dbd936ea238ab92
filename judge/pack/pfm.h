// Floats as a file that any language reads in ten lines.
#pragma once

#include <string>

#include "model/image.h"

namespace lancer::judge {

/// `count` channels (1 or 3) of an image, from `first` on, as a portable float map: "PF" (three) or
/// "Pf" (one), width and height, "-1.0" for little-endian; then 32-bit floats, the bottom row
/// first.
std::string pfm_bytes(const Image& image, int first, int count);

}  // namespace lancer::judge
