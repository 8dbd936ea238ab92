#include "judge/pack/pfm.h"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <cstdint>

namespace lancer::judge {

std::string pfm_bytes(const std::vector<double>& values, int width, int channels) {
    assert(channels == 1 || channels == 3);
    const std::size_t row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    const std::size_t height = values.size() / row;
    std::string bytes =
        fmt::format("{}\n{} {}\n-1.0\n", channels == 3 ? "PF" : "Pf", width, height);
    bytes.reserve(bytes.size() + 4 * values.size());
    for (std::size_t y = height; y-- > 0;) {
        for (std::size_t i = 0; i < row; ++i) {
            const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(values[y * row + i]));
            for (int shift = 0; shift < 32; shift += 8)
                bytes += static_cast<char>((bits >> shift) & 0xFF);
        }
    }
    return bytes;
}

}  // namespace lancer::judge
