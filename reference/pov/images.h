// Writes images as PNG files that POV-Ray decodes to the scene's values.
#pragma once

#include "reference/pov/writer.h"

namespace lancer::reference::pov {

/// `png "scene-0.png" gamma srgb`: the words that name image `index` in an image_map. The first
/// call makes the asset with 16 bits. It is sRGB if that holds every value exactly, so that
/// POV-Ray's own curve checks the one by which the image was read; otherwise linear.
std::string image_file_words(Writer& writer, std::uint32_t index, const SourceSpan& where);

}  // namespace lancer::reference::pov
