// Prefetches the part of an image that a tile fills.
#pragma once

#include <cstddef>

#include "model/image.h"
#include "tracer/render.h"

namespace lancer {

/// Prefetches the memory of a tile, so that it is in the cache when the tile's rays have been
/// traced.
inline void expect_memory(Image& image, const Crop& tile) {
    constexpr std::ptrdiff_t line = 64 / sizeof(double);
    for (int y = tile.y; y < tile.y + tile.height; ++y) {
        const double* pixels = image.pixel(tile.x, y);
        const std::ptrdiff_t count = std::ptrdiff_t(tile.width) * image.channels;
        for (std::ptrdiff_t i = 0; i < count; i += line) __builtin_prefetch(pixels + i, 1);
    }
}

}  // namespace lancer
