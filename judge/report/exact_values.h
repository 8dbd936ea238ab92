// The values of two pictures in a form that a page's script can read, for its loupe.
#pragma once

#include <string>

#include "model/image.h"

namespace lancer::judge {

/// Two 8-bit PNGs: the high and the low bytes of 16-bit values. The canvas of a browser gives only
/// 8 bits per channel, whatever the file holds.
struct ExactValues {
    std::string high;  ///< empty: not given
    std::string low;

    std::size_t bytes() const { return high.size() + low.size(); }
};

/// `image` (linear light, 3 channels, clipped to 0..1) in steps of 1/65535.
ExactValues exact_values(const Image& image);

}  // namespace lancer::judge
