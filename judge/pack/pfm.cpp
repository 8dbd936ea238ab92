#include "judge/pack/pfm.h"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <cstdint>

namespace lancer::judge {

std::string pfm_bytes(const Image& image, int first, int count) {
    assert((count == 1 || count == 3) && first + count <= image.channels);
    std::string bytes =
        fmt::format("{}\n{} {}\n-1.0\n", count == 3 ? "PF" : "Pf", image.width, image.height);
    bytes.reserve(bytes.size() + 4 * static_cast<std::size_t>(count) *
                                     static_cast<std::size_t>(image.width) *
                                     static_cast<std::size_t>(image.height));
    for (int y = image.height - 1; y >= 0; --y) {
        for (int x = 0; x < image.width; ++x) {
            const double* pixel = image.pixel(x, y) + first;
            for (int c = 0; c < count; ++c) {
                const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(pixel[c]));
                for (int shift = 0; shift < 32; shift += 8)
                    bytes += static_cast<char>((bits >> shift) & 0xFF);
            }
        }
    }
    return bytes;
}

}  // namespace lancer::judge
