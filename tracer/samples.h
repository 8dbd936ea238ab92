// Where in a pixel its rays go, and in which order a tile's pixels are taken.
#pragma once

#include "model/settings.h"
#include "model/sobol.h"

namespace lancer {

/// Width and height of the tiles that threads are dealt.
inline constexpr int tile_size = 16;

struct TilePixel {
    int x, y;
};

/// The pixel `index` of a tile: neighbours, which rays side by side like, follow each other in
/// blocks of 4 x 2 within blocks of 8 x 8.
constexpr TilePixel tile_pixel(int index) {
    const int block = index / 64;
    const int part = index % 64 / 8;
    return {block % 2 * 8 + part % 2 * 4 + index % 4, block / 2 * 8 + part / 2 * 2 + index / 4 % 2};
}

/// Calls use(x, y) for the points of the pixel at column x, row y of the whole picture that rays go
/// through, in the order in which their light is summed.
template <class Real, class Use>
void for_each_sample(const Settings& settings, int x, int y, Use&& use) {
    const int n = settings.samples;
    if (n > 1 && settings.sampling == Sampling::sobol) {
        const SobolPoints points(pixel_key(settings.seed, x, y));
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n * n); ++i) {
            const SquarePoint at = points[i];
            use(static_cast<Real>(x + at.x), static_cast<Real>(y + at.y));
        }
        return;
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            use(static_cast<Real>(x) + (static_cast<Real>(i) + Real(0.5)) / static_cast<Real>(n),
                static_cast<Real>(y) + (static_cast<Real>(j) + Real(0.5)) / static_cast<Real>(n));
        }
    }
}

}  // namespace lancer
