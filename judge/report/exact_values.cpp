#include "judge/report/exact_values.h"

#include <algorithm>
#include <cmath>

#include "model/io/png_file.h"
#include "model/srgb.h"

namespace lancer::judge {

ExactValues exact_values(const Image& image) {
    if (image.channels != 3 || image.data.empty()) return {};
    Image high(image.width, image.height, 3);
    Image low(image.width, image.height, 3);
    for (std::size_t i = 0; i < image.data.size(); ++i) {
        const double value = std::isfinite(image.data[i]) ? std::clamp(image.data[i], 0.0, 1.0) : 0;
        const long steps = std::lround(value * 65535);
        // The file stores sRGB, so each byte is decoded to the light that encodes to it.
        high.data[i] = srgb_decode(static_cast<double>(steps / 256) / 255);
        low.data[i] = srgb_decode(static_cast<double>(steps % 256) / 255);
    }
    return {io::encode_png(high, {}, "values"), io::encode_png(low, {}, "values")};
}

}  // namespace lancer::judge
