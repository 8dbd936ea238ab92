// The pixels of two pictures that are compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/image.h"

namespace lancer::reference {

/// 1 where a pixel is compared. Without flags, all pixels are.
struct PixelMask {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> flags{};  ///< rows from the top

    bool counts(std::size_t pixel) const { return flags.empty() || flags[pixel] != 0; }
};

/// A pixel is compared where the picture is neither black nor fully transparent.
PixelMask mask_from(const Image& picture);

/// How many of `pixels` pixels are compared.
std::size_t counted_pixels(const PixelMask& mask, std::size_t pixels);

/// Sets all pixels to black that are not compared.
Image blacked_out(Image picture, const PixelMask& mask);

}  // namespace lancer::reference
