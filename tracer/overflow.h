// Light that overflows the number type is an error, not a black or white pixel.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "model/diagnostic.h"
#include "tracer/render.h"

namespace lancer {

/// Whether light has overflowed: it is then infinite, or NaN after a multiplication by 0.
inline bool overflows(const double* pixel) {
    return !(std::isfinite(pixel[0]) && std::isfinite(pixel[1]) && std::isfinite(pixel[2]));
}
/// The index in the image of the tile's first pixel that overflows; the largest number if none
/// does.
inline std::int64_t first_overflow(Image& image, const Crop& tile) {
    for (int y = tile.y; y < tile.y + tile.height; ++y) {
        for (int x = tile.x; x < tile.x + tile.width; ++x) {
            if (overflows(image.pixel(x, y))) return std::int64_t(y) * image.width + x;
        }
    }
    return std::numeric_limits<std::int64_t>::max();
}
[[noreturn]] inline void refuse_overflow(std::int64_t x, std::int64_t y) {
    throw SceneError({},
                     "lights and colours are so bright that their product leaves the range of "
                     "the chosen precision, first at pixel " +
                         std::to_string(x) + ", " + std::to_string(y));
}

}  // namespace lancer
