#include "reference/compare/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/elementary.h"

namespace lancer::reference {

namespace {

/// Eleven evenly spaced entries of the published table of 256, in sRGB. Linear interpolation
/// between them is within 3/255 of the table.
constexpr std::array<std::array<int, 3>, 11> samples = {{{0x00, 0x00, 0x04},
                                                         {0x15, 0x0e, 0x37},
                                                         {0x3b, 0x0f, 0x70},
                                                         {0x64, 0x1a, 0x80},
                                                         {0x8c, 0x29, 0x81},
                                                         {0xb6, 0x36, 0x79},
                                                         {0xde, 0x49, 0x68},
                                                         {0xf7, 0x6f, 0x5c},
                                                         {0xfe, 0x9f, 0x6d},
                                                         {0xfe, 0xce, 0x91},
                                                         {0xfc, 0xfd, 0xbf}}};

/// The decoding function of sRGB, IEC 61966-2-1.
double linear_from_srgb(double v) {
    return v <= 0.04045 ? v / 12.92 : elementary::pow((v + 0.055) / 1.055, 2.4);
}

}  // namespace

Color magma(double t) {
    const double place = std::clamp(t, 0.0, 1.0) * (samples.size() - 1);
    const auto lower = std::min(static_cast<std::size_t>(place), samples.size() - 2);
    const double share = place - static_cast<double>(lower);
    const auto channel = [&](std::size_t c) {
        const double value =
            samples[lower][c] + share * (samples[lower + 1][c] - samples[lower][c]);
        return linear_from_srgb(value / 255.0);
    };
    return {channel(0), channel(1), channel(2)};
}

}  // namespace lancer::reference
