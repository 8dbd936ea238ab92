#include "reference/compare/mask.h"

#include <algorithm>

namespace lancer::reference {

PixelMask mask_from(const Image& picture) {
    const int colors = std::min(3, picture.color_channels());
    const bool has_alpha = picture.color_channels() == 4;
    PixelMask mask{picture.width, picture.height};
    mask.flags.reserve(static_cast<std::size_t>(picture.width) *
                       static_cast<std::size_t>(picture.height));
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const double* pixel = picture.pixel(x, y);
            const bool shows = std::any_of(pixel, pixel + colors, [](double v) { return v > 0; });
            mask.flags.push_back(shows && !(has_alpha && pixel[3] <= 0) ? 1 : 0);
        }
    }
    return mask;
}

std::size_t counted_pixels(const PixelMask& mask, std::size_t pixels) {
    if (mask.flags.empty()) return pixels;
    return static_cast<std::size_t>(
        std::count(mask.flags.begin(), mask.flags.end(), std::uint8_t{1}));
}

Image blacked_out(Image picture, const PixelMask& mask) {
    for (std::size_t i = 0; i < picture.data.size(); ++i)
        if (!mask.counts(i / static_cast<std::size_t>(picture.channels))) picture.data[i] = 0;
    return picture;
}

}  // namespace lancer::reference
