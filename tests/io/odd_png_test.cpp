// PNG files byte by byte, of kinds that our own writer does not write.
#include <gtest/gtest.h>

#include <string_view>

#include "tests/io/odd_pictures.h"

namespace lancer::io {
namespace {

std::string number(std::uint32_t n) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((n >> shift) & 0xFF);
    return bytes;
}

std::string chunk_of(const std::string& type, const std::string& data) {
    std::uint32_t c = 0xFFFFFFFF;
    for (const char byte : type + data) {
        c ^= static_cast<unsigned char>(byte);
        for (int i = 0; i < 8; ++i) c = (c & 1) != 0 ? 0xEDB88320 ^ (c >> 1) : c >> 1;
    }
    return number(static_cast<std::uint32_t>(data.size())) + type + data + number(~c);
}

/// A stream of zlib's format that stores the bytes as they are.
std::string stored(const std::string& bytes) {
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const char c : bytes) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = static_cast<std::uint16_t>(bytes.size());
    const auto two = [](std::uint16_t n) {
        return std::string{static_cast<char>(n & 0xFF), static_cast<char>(n >> 8)};
    };
    return "\x78\x01\x01" + two(size) + two(static_cast<std::uint16_t>(~size)) + bytes +
           number(b << 16 | a);
}

enum Kind : char { gray = 0, colors = 2, palette = 3, gray_alpha = 4, colors_alpha = 6 };

/// The head, `middle` chunks, and `data`: the rows, each behind the number of its filter.
std::string png(std::uint32_t width, std::uint32_t height, int bits, Kind kind,
                const std::string& middle, const std::string& data, bool interlaced = false) {
    const std::string head = number(width) + number(height) +
                             std::string{static_cast<char>(bits), kind, 0, 0, interlaced};
    return "\x89PNG\r\n\x1a\n" + chunk_of("IHDR", head) + middle + chunk_of("IDAT", stored(data)) +
           chunk_of("IEND", "");
}

std::string repeat(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}
std::string bytes_of(std::initializer_list<int> values) {
    std::string bytes;
    for (const int value : values) bytes += static_cast<char>(value);
    return bytes;
}

TEST(OddFiles, TenPng) {
    const std::string pixel = bytes_of({200, 100, 50});
    const std::string row = bytes_of({0}) + repeat(pixel, 3);
    const std::vector<double> color{200 / 255.0, 100 / 255.0, 50 / 255.0};
    const std::string plain = png(3, 2, 8, colors, "", row + row);

    std::string in_pieces = plain.substr(0, 33);
    for (const char byte : stored(row + row))
        in_pieces += chunk_of("IDAT", "") + chunk_of("IDAT", {byte});
    in_pieces += chunk_of("IEND", "");

    // The same row five times: as it is, by what is left of it, above it, their mean, Paeth's.
    const std::string by_filters =
        row + bytes_of({1}) + pixel + std::string(6, '\0') + bytes_of({2}) + std::string(9, '\0') +
        bytes_of({3, 100, 50, 25}) + std::string(6, '\0') + bytes_of({4}) + std::string(9, '\0');
    const std::string talk =
        chunk_of("gAMA", number(45455)) + chunk_of("sBIT", bytes_of({5, 6, 5})) +
        chunk_of("bKGD", std::string(6, '\0')) + chunk_of("pHYs", std::string(9, '\1')) +
        chunk_of("tEXt", std::string("Comment\0by hand", 15)) +
        chunk_of("tIME", bytes_of({7, 208, 2, 29, 0, 0, 0})) + chunk_of("laNc", "nobody knows");
    const std::string few = chunk_of("PLTE", pixel + bytes_of({1, 2, 3}));
    const std::string many = chunk_of("PLTE", repeat(pixel, 200));
    const std::string first_is_clear = chunk_of("tRNS", bytes_of({51}));
    std::vector<double> clear = color;
    clear.push_back(0.2);
    std::vector<double> opaque = color;
    opaque.push_back(1);

    expect_read(
        {{"one bit a pixel, and blanks in the last byte",
          png(9, 2, 1, gray, "", repeat(bytes_of({0, 0xFF, 0xFF}), 2)),
          9,
          2,
          {1}},
         {"two bits a pixel", png(5, 1, 2, gray, "", bytes_of({0, 0xAA, 0xAA})), 5, 1, {2 / 3.0}},
         {"four bits a pixel", png(3, 1, 4, gray, "", bytes_of({0, 0x33, 0x30})), 3, 1, {0.2}},
         {"a palette of two with one bit a pixel", png(10, 1, 1, palette, few, bytes_of({0, 0, 0})),
          10, 1, color},
         {"a palette that is longer than it needs be",
          png(3, 1, 8, palette, many, bytes_of({0, 0, 99, 199})), 3, 1, color},
         {"a palette whose first colour alone is clear",
          png(3, 1, 8, palette, few + first_is_clear, bytes_of({0, 0, 0, 0})), 3, 1, clear},
         {"one colour that is clear, which no pixel has",
          png(3, 1, 8, colors, chunk_of("tRNS", bytes_of({0, 1, 0, 1, 0, 1})), row), 3, 1, opaque},
         {"grey of 16 bits with one that is clear",
          png(2, 1, 16, gray, chunk_of("tRNS", bytes_of({0x33, 0x33})),
              bytes_of({0, 0x33, 0x33, 0x33, 0x33})),
          2,
          1,
          {0.2, 0.2, 0.2, 0}},
         {"data of a byte, and of none, in a chunk", in_pieces, 3, 2, color},
         {"each row by another filter", png(3, 5, 8, colors, "", by_filters), 3, 5, color},
         {"chunks of all kinds", png(3, 1, 8, colors, talk, row), 3, 1, color},
         {"bytes behind its end", plain + "and a comment", 3, 2, color},
         {"one pixel, interlaced", png(1, 1, 8, colors, "", bytes_of({0}) + pixel, true), 1, 1,
          color},
         {"interlaced, with passes that are empty",
          png(2, 1, 8, colors, "", repeat(bytes_of({0}) + pixel, 2), true), 2, 1, color}});
}

}  // namespace
}  // namespace lancer::io
