#include "model/io/pfm_file.h"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "model/diagnostic.h"
#include "model/io/image_limits.h"
#include "model/io/text_scanner.h"

namespace lancer::io {

namespace {

/// A side of the picture; white space may precede it.
int side(TextScanner& scanner, const char* what) {
    scanner.at_end();
    const std::int64_t value = scanner.integer(what);
    if (value < 1 || value > static_cast<std::int64_t>(most_pixels))
        throw scanner.error(fmt::format("{} is out of range: {}", what, value));
    return static_cast<int>(value);
}

float float_at(const unsigned char* bytes, bool little_endian) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits = bits << 8 | bytes[little_endian ? 3 - i : i];
    return std::bit_cast<float>(bits);
}

}  // namespace

bool is_pfm(std::string_view bytes) {
    return bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == 'F' || bytes[1] == 'f') &&
           std::string_view(" \t\r\n").find(bytes[2]) != std::string_view::npos;
}

std::string encode_pfm(const Image& image, int first, int count) {
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

Image decode_pfm(std::string_view bytes, const std::string& name) {
    TextScanner scanner(bytes.substr(2), name);
    const int channels = bytes[1] == 'F' ? 3 : 1;
    const int width = side(scanner, "the width");
    const int height = side(scanner, "the height");
    scanner.at_end();
    const double scale = scanner.number("the scale, which is negative for little-endian floats");
    // For other numbers, programs disagree whether to multiply or to divide.
    if (std::abs(scale) != 1)
        throw scanner.error(fmt::format("the scale is {:g}, but must be 1 or -1", scale));
    const std::string excess = size_problem(static_cast<std::uint64_t>(width),
                                            static_cast<std::uint64_t>(height), channels);
    if (!excess.empty()) throw scanner.error(excess);
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                              static_cast<std::size_t>(channels);
    // The header ends with one byte of white space, or two if lines end with CR and LF. If bytes
    // were missing or left over, the start of the floats would be unknown.
    std::string_view raster = bytes.substr(bytes.size() - scanner.bytes_left());
    const std::size_t ending = raster.starts_with("\r\n") ? 2 : 1;
    if (raster.size() != ending + 4 * count)
        throw scanner.error(raster.size() < ending + 4 * count
                                ? "the file is truncated"
                                : "there are bytes after the picture");
    raster.remove_prefix(ending);

    Image image(width, height, channels);
    const auto* at = reinterpret_cast<const unsigned char*>(raster.data());
    for (int y = height - 1; y >= 0; --y) {
        double* row = image.pixel(0, y);
        for (int i = 0; i < width * channels; ++i, at += 4) row[i] = float_at(at, scale < 0);
    }
    return image;
}

}  // namespace lancer::io
