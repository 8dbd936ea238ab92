// Light that overflows the number type is an error, not a black or white pixel.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "model/diagnostic.h"
#include "tracer/render.h"

namespace lancer {

/// Whether light has overflowed: it is then infinite, or NaN after a multiplication by 0.
inline bool overflows(const double* pixel) {
    return !(std::isfinite(pixel[0]) && std::isfinite(pixel[1]) && std::isfinite(pixel[2]));
}
/// The index of the tile's first pixel that overflows, in rows of the tile's width; nothing if none
/// does.
inline std::optional<int> first_overflow(const Image& tile) {
    for (int i = 0; i < tile.width * tile.height; ++i)
        if (overflows(tile.data.data() + std::ptrdiff_t(i) * tile.channels)) return i;
    return std::nullopt;
}
[[noreturn]] inline void refuse_overflow(std::int64_t x, std::int64_t y) {
    throw SceneError({},
                     "lights and colours are so bright that their product leaves the range of "
                     "the chosen precision, first at pixel " +
                         std::to_string(x) + ", " + std::to_string(y));
}

}  // namespace lancer
