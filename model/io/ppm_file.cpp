#include "model/io/ppm_file.h"

#include <fmt/format.h>

#include "model/diagnostic.h"
#include "model/io/image_limits.h"
#include "model/io/quantize.h"
#include "model/io/text_scanner.h"

namespace lancer::io {
namespace {

/// An integer of the header or of a text raster; white space and comments may precede it.
int number(TextScanner& scanner, const char* what, std::int64_t most) {
    scanner.at_end();
    const std::int64_t value = scanner.integer(what);
    if (value < 0 || value > most) {
        throw scanner.error(fmt::format("{} is out of range: {}", what, value));
    }
    return static_cast<int>(value);
}

}  // namespace

bool is_ppm(std::string_view bytes) {
    return bytes.size() > 2 && bytes[0] == 'P' &&
           (bytes[1] == '2' || bytes[1] == '3' || bytes[1] == '5' || bytes[1] == '6') &&
           std::string_view(" \t\r\n#").find(bytes[2]) != std::string_view::npos;
}

void encode_ppm(const StoredShape& shape, const RowOf& row, const AddBytes& add) {
    const int top = shape.type == SampleType::uint16 ? 65535 : 255;
    add(fmt::format("P6\n{} {}\n{}\n", shape.width, shape.height, top));
    for (int y = 0; y < shape.height; ++y) add({row(y), shape.row_bytes()});
}

Image decode_ppm(std::string_view bytes, const std::string& name, ColorSpace space) {
    TextScanner scanner(bytes.substr(2), name, '#');
    const char kind = bytes[1];
    const bool text = kind < '4';
    const int channels = kind == '3' || kind == '6' ? 3 : 1;
    const int width = number(scanner, "the width", most_pixels);
    const int height = number(scanner, "the height", most_pixels);
    const int top = number(scanner, "the largest value", 65535);
    const std::string excess = size_problem(static_cast<std::uint64_t>(width),
                                            static_cast<std::uint64_t>(height), channels);
    if (!excess.empty()) throw scanner.error(excess);
    if (top == 0) throw scanner.error("the largest value is 0");
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                              static_cast<std::size_t>(channels);
    const std::size_t value_bytes = !text && top > 255 ? 2 : 1;
    // The header ends with one byte of white space; text values are separated by white space.
    if (scanner.bytes_left() < (text ? 2 * count : 1 + count * value_bytes)) {
        throw scanner.error("the file is truncated");
    }

    const std::vector<double> light = space == ColorSpace::linear
                                          ? decoding_table(top, [](double v) { return v; })
                                          : decoding_table(top, srgb_decode);
    Image image(width, height, channels);
    std::string_view raster = bytes.substr(bytes.size() - scanner.bytes_left());
    if (!text) raster.remove_prefix(1);
    for (std::size_t i = 0; i < count; ++i) {
        int step = 0;
        if (text) {
            step = number(scanner, "a value of the picture", top);
        } else {
            for (std::size_t b = 0; b < value_bytes; ++b) {
                step = step << 8 | static_cast<unsigned char>(raster[i * value_bytes + b]);
            }
            if (step > top) throw scanner.error("a value is larger than the largest value");
        }
        image.data[i] = light[static_cast<std::size_t>(step)];
    }
    return image;
}

}  // namespace lancer::io
