// Portable float maps: pictures of floats that are easy to write in any language (netpbm: pfm(5)).
#pragma once

#include <string>
#include <string_view>

#include "model/image.h"

namespace lancer::io {

bool is_pfm(std::string_view bytes);

/// Encodes `count` channels (1 or 3) of an image, from `first` on: "PF" (three) or "Pf" (one),
/// width and height, "-1.0" for little-endian, then 32-bit floats, the bottom row first.
std::string encode_pfm(const Image& image, int first, int count);

/// 1 or 3 channels in linear light. Throws FileError, which names `name`.
Image decode_pfm(std::string_view bytes, const std::string& name);

}  // namespace lancer::io
