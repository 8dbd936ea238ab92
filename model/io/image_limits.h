// Limits on the size of pictures, checked before memory is allocated.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace lancer::io {

/// 2^27: 16384 x 8192. In double, RGB, that is 3.2 GB.
inline constexpr std::uint64_t most_pixels = std::uint64_t{1} << 27;
inline constexpr std::uint64_t longest_side = std::uint64_t{1} << 17;
inline constexpr int most_channels = 64;
/// The most memory for a strip or tile: that of a whole picture of most_pixels in RGB floats.
inline constexpr std::uint64_t most_strip_bytes = std::uint64_t{1} << 31;

/// Why a picture of this size is refused; empty when it is allowed.
inline std::string size_problem(std::uint64_t width, std::uint64_t height, int channels) {
    if (width == 0 || height == 0 || channels < 1) return "the picture has no pixels";
    if (channels > most_channels) {
        return fmt::format("{} channels are more than the {} allowed", channels, most_channels);
    }
    if (width > longest_side || height > longest_side) {
        return fmt::format("{} x {} pixels: a side is longer than the {} allowed", width, height,
                           longest_side);
    }
    if (width * height > most_pixels) {
        return fmt::format("{} x {} pixels are more than the {} allowed", width, height,
                           most_pixels);
    }
    return {};
}

}  // namespace lancer::io
