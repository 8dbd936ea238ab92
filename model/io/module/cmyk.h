// Converts CMYK to RGB: four samples per pixel become three.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace lancer::io {

/// Converts in place: four samples for each of `pixels` pixels become three, (1 - ink) (1 - black),
/// rounded to a step of the file.
template <class Value>
void rgb_from_cmyk(Value* samples, std::size_t pixels) {
    constexpr std::uint64_t top = std::numeric_limits<Value>::max();
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        const Value* ink = samples + 4 * pixel;
        const std::uint64_t black = top - ink[3];
        const Value light[3] = {static_cast<Value>(((top - ink[0]) * black + top / 2) / top),
                                static_cast<Value>(((top - ink[1]) * black + top / 2) / top),
                                static_cast<Value>(((top - ink[2]) * black + top / 2) / top)};
        for (std::size_t c = 0; c < 3; ++c) samples[3 * pixel + c] = light[c];
    }
}

}  // namespace lancer::io
