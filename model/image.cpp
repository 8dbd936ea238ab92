#include "model/image.h"

#include <algorithm>

namespace lancer {

Image in_color(Image image) {
    const int given = image.color_channels();
    if (given == image.channels && given >= 3) return image;
    Image result(image.width, image.height, std::max(given, 3));
    double* out = result.data.data();
    for (std::size_t at = 0; at < image.data.size();
         at += static_cast<std::size_t>(image.channels)) {
        for (int channel = 0; channel < result.channels; ++channel)
            *out++ = image.data[at + static_cast<std::size_t>(given < 3 ? 0 : channel)];
    }
    return result;
}

}  // namespace lancer
