#include "model/io/curve.h"

#include <bit>
#include <string_view>

#include "model/diagnostic.h"
#include "model/io/byte_reader.h"
#include "model/io/file.h"
#include "model/io/png_file.h"

namespace lancer::io {
namespace {

using namespace std::string_view_literals;

/// Whether the samples of a TIFF's first picture are floats, by its tag SampleFormat. Throws
/// FileError when the file is too short.
bool has_float_samples(std::string_view bytes) {
    constexpr std::uint16_t sample_format = 339;
    constexpr std::uint16_t big_version = 43;
    const std::endian order = bytes.starts_with("MM") ? std::endian::big : std::endian::little;
    const auto reader_at = [&](std::uint64_t at) {
        ByteReader reader(bytes, "TIFF", order);
        reader.skip(at);
        return reader;
    };
    ByteReader head = reader_at(2);
    const bool big = head.read<std::uint16_t>() == big_version;
    const auto read_offset = [big](ByteReader& reader) -> std::uint64_t {
        return big ? reader.read<std::uint64_t>() : reader.read<std::uint32_t>();
    };
    if (big) head.skip(4);
    ByteReader entries = reader_at(read_offset(head));
    std::uint64_t count = big ? entries.read<std::uint64_t>() : entries.read<std::uint16_t>();
    for (; count > 0; --count) {
        const auto tag = entries.read<std::uint16_t>();
        entries.skip(2);  // its type: 16-bit numbers
        const std::uint64_t values = read_offset(entries);
        if (tag != sample_format) {
            entries.skip(big ? 8 : 4);
            continue;
        }
        // If all values fit, they are in the entry itself.
        if (2 * values > (big ? 8u : 4u)) entries = reader_at(read_offset(entries));
        return entries.read<std::uint16_t>() == 3;
    }
    return false;
}

}  // namespace

std::string curve_of(const std::string& path) {
    if (is_stream(path)) return {};  // it was read already
    const std::string bytes = read_file(path);
    const std::string_view view = bytes;
    if (is_png(view)) return png_curve(view);
    for (const std::string_view floats : {"\x76\x2F\x31\x01"sv, "#?RADIANCE"sv, "#?RGBE"sv})
        if (view.starts_with(floats)) return "linear";
    if (!view.starts_with("II") && !view.starts_with("MM")) return "sRGB";
    try {
        return has_float_samples(view) ? "linear" : "sRGB";
    } catch (const FileError&) {
        return {};
    }
}

}  // namespace lancer::io
