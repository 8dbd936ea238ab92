#include <algorithm>

#include "model/io/png_file.h"
#include "reference/report/report.h"

namespace lancer::reference {

namespace {

/// Each pixel the mean of four; an odd last row or column counts twice.
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

}  // namespace

Preview preview_of(const Image& image, std::size_t most_bytes) {
    Preview preview{{}, image.width, image.height};
    if (image.width < 1 || image.height < 1) return preview;
    Image shown = image;
    preview.png = io::encode_png(shown, {}, "preview");
    while (preview.png.size() > most_bytes && shown.width > 32) {
        shown = halved(shown);
        preview.png = io::encode_png(shown, {}, "preview");
    }
    return preview;
}

}  // namespace lancer::reference
