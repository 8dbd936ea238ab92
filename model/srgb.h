// The sRGB transfer curve, IEC 61966-2-1, between encoded values and light.
#pragma once

#include <cstdint>

#include "model/elementary.h"
#include "model/math.h"

namespace lancer {

/// Linear light in [0, 1] to the sRGB-encoded value in [0, 1].
inline double srgb_encode(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * elementary::pow(light, 1.0 / 2.4) - 0.055;
}

/// The sRGB-encoded value in [0, 1] to linear light in [0, 1].
inline double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : elementary::pow((encoded + 0.055) / 1.055, 2.4);
}

/// Linear light of a colour 0xrrggbb.
inline Vec3d srgb_color(std::uint32_t rgb) {
    const auto part = [rgb](int shift) {
        return srgb_decode(static_cast<double>((rgb >> shift) & 0xFF) / 255.0);
    };
    return {part(16), part(8), part(0)};
}

}  // namespace lancer
