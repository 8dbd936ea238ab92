#include "model/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace lancer {
namespace {

/// The length of the valid sequence at the start of `text`; 0 when there is none.
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

/// The code point of a valid sequence.
std::uint32_t code_point(std::string_view sequence) {
    constexpr unsigned char first_bits[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
    std::uint32_t code = static_cast<unsigned char>(sequence[0]) & first_bits[sequence.size()];
    for (const char c : sequence.substr(1))
        code = code << 6 | (static_cast<unsigned char>(c) & 0x3F);
    return code;
}

/// Control characters, line separators, and marks that change the direction of writing.
bool is_unseen(std::uint32_t code) {
    return (code >= 0x80 && code < 0xA0) || code == 0x061C || code == 0x200E || code == 0x200F ||
           (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

/// Whether all eight bytes are ASCII and none is NUL.
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

std::string printable(std::string_view text) {
    std::string shown;
    for (std::size_t at = 0; at < text.size();) {
        const auto plain = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(),
                                        [](char c) { return c < ' ' || c > '~'; });
        if (const auto end = static_cast<std::size_t>(plain - text.begin()); end > at) {
            shown += text.substr(at, end - at);
            at = end;
            continue;
        }
        const std::size_t length = sequence_length(text.substr(at));
        const std::string_view character = text.substr(at, std::max<std::size_t>(length, 1));
        const auto first = static_cast<unsigned char>(character[0]);
        if (character == "\n") {
            shown += "\\n";
        } else if (character == "\t") {
            shown += "\\t";
        } else if (length == 0 || first < 0x20 || first == 0x7F) {
            shown += fmt::format("\\x{:02x}", first);
        } else if (const std::uint32_t code = code_point(character); is_unseen(code)) {
            shown += fmt::format("\\u{:04x}", code);
        } else {
            shown += character;
        }
        at += character.size();
    }
    return shown;
}

std::size_t count_characters(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

}  // namespace lancer
