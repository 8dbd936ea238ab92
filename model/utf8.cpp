#include "model/utf8.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace lancer {
namespace {

/// Length of the valid sequence at the start of `text`; 0: there is none.
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) -> unsigned {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
    };
    const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0) == 0x80; };
    const unsigned a = byte(0);
    const unsigned b = byte(1);
    if (a == 0) return 0;
    if (a < 0x80) return 1;
    if (a < 0xC2 || a > 0xF4) return 0;
    if (a < 0xE0) return continues(1) ? 2 : 0;
    if (a < 0xF0) {
        const unsigned low = a == 0xE0 ? 0xA0 : 0x80;
        const unsigned high = a == 0xED ? 0x9F : 0xBF;
        return b >= low && b <= high && continues(2) ? 3 : 0;
    }
    const unsigned low = a == 0xF0 ? 0x90 : 0x80;
    const unsigned high = a == 0xF4 ? 0x8F : 0xBF;
    return b >= low && b <= high && continues(2) && continues(3) ? 4 : 0;
}

/// Eight bytes of ASCII without NUL.
bool is_plain(std::uint64_t bytes) {
    constexpr std::uint64_t tops = 0x8080808080808080;
    constexpr std::uint64_t ones = 0x0101010101010101;
    return ((bytes | (bytes - ones)) & tops) == 0;
}

}  // namespace

std::size_t find_invalid_utf8(std::string_view text, std::size_t from) {
    std::size_t at = from;
    while (at < text.size()) {
        std::uint64_t eight = 0;
        if (at + sizeof eight <= text.size()) {
            std::memcpy(&eight, text.data() + at, sizeof eight);
            if (is_plain(eight)) {
                at += sizeof eight;
                continue;
            }
        }
        const std::size_t length = sequence_length(text.substr(at));
        if (length == 0) return at;
        at += length;
    }
    return std::string_view::npos;
}

std::size_t count_characters(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

}  // namespace lancer
