#include <algorithm>

#include "judge/report/report.h"
#include "model/io/png_file.h"

namespace lancer::judge {

namespace {

/// Each pixel is the mean of four; an odd last row or column counts twice.
Image halved(const Image& image) {
    Image half((image.width + 1) / 2, (image.height + 1) / 2, image.channels);
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            const int right = std::min(2 * x + 1, image.width - 1);
            const int below = std::min(2 * y + 1, image.height - 1);
            for (int c = 0; c < image.channels; ++c) {
                half.pixel(x, y)[c] =
                    0.25 * (image.pixel(2 * x, 2 * y)[c] + image.pixel(right, 2 * y)[c] +
                            image.pixel(2 * x, below)[c] + image.pixel(right, below)[c]);
            }
        }
    }
    return half;
}

/// Encodes `image`, halved until it fits.
std::string encoded(Image image, std::size_t most_bytes) {
    std::string png = io::encode_png(image, {}, "preview");
    while (png.size() > most_bytes && image.width > 32) {
        image = halved(image);
        png = io::encode_png(image, {}, "preview");
    }
    return png;
}

}  // namespace

Preview preview_of(const Image& image, std::size_t most_bytes) {
    if (image.width < 1 || image.height < 1) return {};
    return {encoded(image, most_bytes), image.width, image.height};
}

void shrink(Preview& preview, std::size_t most_bytes) {
    const Image image = io::decode_png(preview.png, "preview", io::ColorSpace::automatic);
    preview.png = encoded(image, most_bytes);
}

}  // namespace lancer::judge
