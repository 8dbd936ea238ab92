// Images as PNG files that POV-Ray decodes to what the scene holds.
#pragma once

#include "reference/pov/writer.h"

namespace lancer::reference::pov {

/// `png "scene-0.png" gamma srgb`: the words that name image `index` in an image_map. The first
/// call makes the asset: 16 bits, sRGB where they hold every value exactly, so that POV-Ray's own
/// curve judges the one that the image was read by; linear otherwise.
std::string image_file_words(Writer& writer, std::uint32_t index, const SourceSpan& where);

}  // namespace lancer::reference::pov
