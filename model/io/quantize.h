// Converts between linear light and the integers of a file.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/srgb.h"

namespace lancer::io {

/// Rounds light to the nearest step of a format with 8 or 16 bits. Values outside [0, 1] are
/// clamped; NaN, which no renderer should produce, becomes 0.
class Quantizer {
  public:
    Quantizer(int bits, bool linear) : top_(bits == 16 ? 65535 : 255), linear_(linear) {
        if (linear || bits == 16) return;
        for (int step = 1; step <= top_; ++step) {
            thresholds_.push_back(srgb_decode((step - 0.5) / top_));
        }
        thresholds_.push_back(2);  // light never reaches it
        for (int bin = 0; bin < bins; ++bin) {
            below_.push_back(static_cast<std::uint8_t>(
                std::upper_bound(thresholds_.begin(), thresholds_.end(), double(bin) / bins) -
                thresholds_.begin()));
        }
    }

    std::uint16_t encoded(double light) const {
        if (linear_ || !(light > 0) || light >= 1) return raw(light);
        if (thresholds_.empty()) return raw(srgb_encode(light));
        const std::uint8_t below = below_[static_cast<std::size_t>(light * bins)];
        return static_cast<std::uint16_t>(below + (light >= thresholds_[below] ? 1 : 0));
    }

    /// Without the sRGB curve, for alpha.
    std::uint16_t raw(double value) const {
        const double from_0 = value > 0 ? value : 0;
        const double to_1 = from_0 < 1 ? from_0 : 1;
        // Halves go up, and no number is below 0.
        return static_cast<std::uint16_t>(
            static_cast<int>(to_1 * top_ + 0.5));  // NOLINT(bugprone-incorrect-roundings)
    }

  private:
    /// A bin of light of this width holds one threshold at most: the nearest two, at black, are
    /// 1 / (255 * 12.92) apart.
    static constexpr int bins = 4096;

    int top_;
    bool linear_;
    std::vector<double> thresholds_;   ///< where the steps 1..top begin; empty: computed by a power
    std::vector<std::uint8_t> below_;  ///< of each bin, the number of thresholds up to its start
};

/// The linear light of each step 0..`top` of a format that encodes light as `curve`(light);
/// `decode` is the inverse of `curve` on [0, 1].
template <class Decode>
std::vector<double> decoding_table(int top, Decode decode) {
    std::vector<double> light(static_cast<std::size_t>(top) + 1);
    for (int step = 0; step <= top; ++step) {
        light[static_cast<std::size_t>(step)] = decode(static_cast<double>(step) / top);
    }
    return light;
}

}  // namespace lancer::io
