#include "model/io/part_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/sha256.h"

namespace lancer::io {
namespace {

using namespace std::string_view_literals;

constexpr int most_strip_rows = 16;  // the renderer's tiles
constexpr int least_strips = 4;      // for each part, so that costly rows are shared

// The file layout is that of https://openexr.com/en/latest/OpenEXRFileLayout.html, with several
// parts. Numbers are little-endian.
constexpr std::string_view magic = "\x76\x2F\x31\x01\x02\x10\x00\x00"sv;
constexpr std::string_view first_line = "lancer part 1\n";
constexpr std::size_t row_head_size = 12;

template <class Number>
void put(std::string& bytes, Number number) {
    static_assert(std::endian::native == std::endian::little);
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    bytes.append(raw, sizeof number);
}

void attribute(std::string& bytes, std::string_view name, std::string_view type,
               std::string_view value) {
    bytes.append(name).push_back('\0');
    bytes.append(type).push_back('\0');
    put(bytes, static_cast<std::int32_t>(value.size()));
    bytes.append(value);
}

/// A channel of the file: its name, and the one of the picture that it holds.
struct Channel {
    std::string name;
    int source;
    bool exact;  ///< holds the remainder to the double
};

/// Sorted by name, as the format requires.
std::vector<Channel> channels_of(const PartHead& head) {
    std::vector<Channel> channels;
    for (int c = 0; c < 3; ++c) {
        const std::string name(1, "RGB"[c]);
        channels.push_back({name, c, false});
        channels.push_back({"exact." + name, c, true});
    }
    for (std::size_t i = 0; i < head.extra_names.size(); ++i)
        channels.push_back({head.extra_names[i], 3 + static_cast<int>(i), false});
    std::sort(channels.begin(), channels.end(),
              [](const Channel& a, const Channel& b) { return a.name < b.name; });
    return channels;
}

std::string channel_list(const PartHead& head) {
    std::string list;
    for (const Channel& channel : channels_of(head)) {
        list.append(channel.name).push_back('\0');
        put(list, std::int32_t{channel.exact ? 0 : 2});  // UINT or FLOAT
        put(list, std::int32_t{0});                      // not perceptually linear, and reserved
        put(list, std::int32_t{1});
        put(list, std::int32_t{1});
    }
    list.push_back('\0');
    return list;
}

std::string window(int left, int top, int right, int bottom) {
    std::string box;
    for (const int side : {left, top, right, bottom}) put(box, std::int32_t{side});
    return box;
}

std::string text_of(const PartHead& head, const std::string& seal) {
    return sealed_text(head) + "seal " + seal + "\n";
}

std::string strip_head(const PartHead& head, const Strip& strip, std::size_t index,
                       const std::string& text) {
    std::string bytes;
    if (index == 0) attribute(bytes, "lancer:part", "string", text);
    attribute(bytes, "channels", "chlist", channel_list(head));
    attribute(bytes, "chunkCount", "int", [&] {
        std::string value;
        put(value, std::int32_t{strip.rows});
        return value;
    }());
    attribute(bytes, "compression", "compression", "\0"sv);
    attribute(bytes, "dataWindow", "box2i",
              window(0, strip.first, head.width - 1, strip.first + strip.rows - 1));
    attribute(bytes, "displayWindow", "box2i", window(0, 0, head.width - 1, head.height - 1));
    attribute(bytes, "lineOrder", "lineOrder", "\0"sv);
    attribute(bytes, "name", "string", fmt::format("rows from {}", strip.first));
    std::string one;
    put(one, 1.0F);
    attribute(bytes, "pixelAspectRatio", "float", one);
    attribute(bytes, "screenWindowCenter", "v2f", std::string(8, '\0'));
    attribute(bytes, "screenWindowWidth", "float", one);
    attribute(bytes, "type", "string", "scanlineimage");
    bytes.push_back('\0');
    return bytes;
}

std::optional<int> number_in(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// `a b`
bool two_numbers(std::string_view text, int& a, int& b) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const auto first = number_in(text.substr(0, blank));
    const auto second = number_in(text.substr(std::min(blank + 1, text.size())));
    if (!first || !second) return false;
    a = *first;
    b = *second;
    return true;
}

/// The remainder of a double after rounding to float, in units of its last place. 0 where the float
/// has no such digits: there both are infinite, or both round to the same.
std::int32_t beyond(double value, float rounded) {
    if (!std::isfinite(rounded)) return 0;
    const std::int64_t distance = std::bit_cast<std::int64_t>(value) -
                                  std::bit_cast<std::int64_t>(static_cast<double>(rounded));
    return std::abs(distance) <= std::numeric_limits<std::int32_t>::max()
               ? static_cast<std::int32_t>(distance)
               : 0;
}

double put_together(float rounded, std::int32_t distance) {
    const double value = static_cast<double>(rounded);
    return std::isfinite(rounded)
               ? std::bit_cast<double>(std::bit_cast<std::int64_t>(value) + distance)
               : value;
}

}  // namespace

std::vector<Strip> strips_of(const PartHead& head) {
    const int rows = std::clamp(head.height / (least_strips * head.count), 1, most_strip_rows);
    std::vector<Strip> strips;
    std::int64_t first = std::int64_t{rows} * (head.number - 1);
    for (; first < head.height; first += std::int64_t{rows} * head.count) {
        const int begin = static_cast<int>(first);
        strips.push_back({begin, std::min(rows, head.height - begin)});
    }
    return strips;
}

std::size_t pixel_bytes(const PartHead& head) {
    return 4 * (static_cast<std::size_t>(head.channels()) + 3);
}

std::string row_head(const PartHead& head, int strip, int row) {
    std::string bytes;
    put(bytes, std::int32_t{strip});
    put(bytes, std::int32_t{row});
    put(bytes, static_cast<std::int32_t>(static_cast<std::size_t>(head.width) * pixel_bytes(head)));
    return bytes;
}

std::string sealed_text(const PartHead& head) {
    std::string extras;
    for (const std::string& name : head.extra_names) extras += " " + name;
    const std::string note = head.note.empty() ? "" : "note " + head.note + "\n";
    return fmt::format("{}part {} {}\nsize {} {}\nextra{}\n{}{}", first_line, head.number,
                       head.count, head.width, head.height, extras, note, to_text(head.origin));
}

std::string file_head(const PartHead& head, const std::string& seal) {
    const std::vector<Strip> strips = strips_of(head);
    const std::string text = text_of(head, seal);
    std::string bytes(magic);
    for (std::size_t i = 0; i < strips.size(); ++i) bytes += strip_head(head, strips[i], i, text);
    bytes.push_back('\0');
    std::uint64_t rows = 0;
    for (const Strip& strip : strips) rows += static_cast<std::uint64_t>(strip.rows);
    const std::uint64_t first = bytes.size() + 8 * rows;
    const std::uint64_t step =
        row_head_size + static_cast<std::uint64_t>(head.width) * pixel_bytes(head);
    for (std::uint64_t row = 0; row < rows; ++row) put(bytes, first + row * step);
    return bytes;
}

std::optional<ToldHead> told_head(std::string_view begin) {
    const std::string before = std::string(magic) + "lancer:part" + '\0' + "string" + '\0';
    if (!begin.starts_with(before)) return std::nullopt;
    begin.remove_prefix(std::min(begin.size(), before.size() + 4));
    if (!begin.starts_with(first_line)) return std::nullopt;
    begin.remove_prefix(first_line.size());
    const auto line = [&](std::string_view key) -> std::optional<std::string_view> {
        const std::size_t end = begin.find('\n');
        if (end == std::string_view::npos || !begin.starts_with(key)) return std::nullopt;
        const std::string_view value = begin.substr(key.size(), end - key.size());
        begin.remove_prefix(end + 1);
        return value;
    };
    ToldHead told;
    PartHead& head = told.head;
    const auto part = line("part ");
    const auto size = line("size ");
    const auto extra = line("extra");
    if (!part || !size || !extra || !two_numbers(*part, head.number, head.count) ||
        !two_numbers(*size, head.width, head.height))
        return std::nullopt;
    for (std::string_view rest = *extra; rest.starts_with(' ');) {
        rest.remove_prefix(1);
        const std::size_t end = std::min(rest.find(' '), rest.size());
        head.extra_names.emplace_back(rest.substr(0, end));
        rest.remove_prefix(end);
    }
    if (const auto note = line("note ")) head.note = *note;
    const std::size_t seal = begin.find("seal ");
    if (seal == std::string_view::npos) return std::nullopt;
    const auto origin = origin_of_text(begin.substr(0, seal));
    begin.remove_prefix(seal);
    const auto digits = line("seal ");
    constexpr int largest = 65535;
    if (!origin || !digits || head.width < 1 || head.height < 1 || head.width > largest ||
        head.height > largest || head.count < 1 || head.count > head.height || head.number < 1 ||
        head.number > head.count || head.extra_names.size() > 16)
        return std::nullopt;
    head.origin = *origin;
    told.seal = *digits;
    return told;
}

void encode_row(const PartHead& head, const double* pixels, std::string& bytes) {
    const int channels = head.channels();
    const std::size_t begin = bytes.size();
    bytes.resize(begin + static_cast<std::size_t>(head.width) * pixel_bytes(head));
    char* to = bytes.data() + begin;
    const auto put_next = [&to](auto number) {
        std::memcpy(to, &number, sizeof number);
        to += sizeof number;
    };
    for (const Channel& channel : channels_of(head)) {
        const double* value = pixels + channel.source;
        for (int x = 0; x < head.width; ++x, value += channels) {
            const auto rounded = static_cast<float>(*value);
            if (channel.exact) {
                put_next(beyond(*value, rounded));
            } else {
                put_next(rounded);
            }
        }
    }
}

void decode_row(const PartHead& head, const std::string& bytes, double* pixels) {
    const std::vector<Channel> order = channels_of(head);
    const int channels = head.channels();
    const std::size_t width = static_cast<std::size_t>(head.width);
    std::vector<float> rounded(width);
    // The floats of a colour come before its exact channels: capitals sort before small letters.
    for (const bool exact : {false, true}) {
        for (std::size_t c = 0; c < order.size(); ++c) {
            if (order[c].exact != exact) continue;
            const char* from = bytes.data() + 4 * width * c;
            double* to = pixels + order[c].source;
            for (std::size_t x = 0; x < width; ++x, from += 4, to += channels) {
                if (exact) {
                    std::int32_t distance = 0;
                    std::memcpy(&distance, from, sizeof distance);
                    *to = put_together(static_cast<float>(*to), distance);
                } else {
                    float value = 0;
                    std::memcpy(&value, from, sizeof value);
                    *to = static_cast<double>(value);
                }
            }
        }
    }
}

}  // namespace lancer::io
