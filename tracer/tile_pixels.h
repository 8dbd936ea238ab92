// In which order a tile's pixels are taken.
#pragma once

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

/// Calls use(x, y) for the pixels of a tile in this order.
template <class Use>
void for_each_pixel(int width, int height, Use&& use) {
    for (int i = 0; i < tile_size * tile_size; ++i) {
        const auto [x, y] = tile_pixel(i);
        if (x < width && y < height) use(x, y);
    }
}

}  // namespace lancer
