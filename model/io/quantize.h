// Between linear light and the whole numbers of a file.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "model/srgb.h"

namespace lancer::io {

/// The step nearest to `light` of a format with steps 0..`top`. What is outside [0, 1] is clamped;
/// NaN, which no renderer should produce, becomes 0.
inline std::uint16_t quantize(double light, int top, bool linear) {
    if (!(light > 0)) return 0;
    if (light >= 1) return static_cast<std::uint16_t>(top);
    const double encoded = linear ? light : srgb_encode(light);
    return static_cast<std::uint16_t>(std::floor(encoded * top + 0.5));
}

/// Linear light for each of the steps 0..`top` of a format that encodes light as `curve`(light);
/// `decode` is its inverse, on [0, 1].
template <class Decode>
std::vector<double> decoding_table(int top, Decode decode) {
    std::vector<double> light(static_cast<std::size_t>(top) + 1);
    for (int step = 0; step <= top; ++step) {
        light[static_cast<std::size_t>(step)] = decode(static_cast<double>(step) / top);
    }
    return light;
}

}  // namespace lancer::io
