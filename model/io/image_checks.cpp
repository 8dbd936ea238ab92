#include "model/io/image_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/io/byte_reader.h"
#include "model/io/image_limits.h"

namespace lancer::io {

// ITU-T T.81, annex B: segments with a marker and a length, then the scan. The segments are skipped
// as a whole, because a thumbnail in one of them has an end-of-image marker, too.
std::string jpeg_problem(std::string_view bytes) {
    constexpr const char* truncated = "the file is truncated";
    const auto byte = [&](std::size_t i) -> std::size_t {
        return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
    };
    std::size_t at = 2;  // behind the start-of-image marker
    while (at < bytes.size()) {
        if (byte(at) != 0xFF) return "damaged JPEG segments";
        const std::size_t marker = byte(at + 1);
        if (marker == 0xFF) {  // a fill byte
            ++at;
            continue;
        }
        const std::size_t length = byte(at + 2) << 8 | byte(at + 3);
        if (marker >= 0xC0 && marker <= 0xC2) {  // a frame with Huffman codes
            const std::uint64_t height = byte(at + 5) << 8 | byte(at + 6);
            const std::uint64_t width = byte(at + 7) << 8 | byte(at + 8);
            // Each block of 8 x 8 pixels has a code of at least one bit, also in progressive files.
            if (width * height / 64 > bytes.size() * 8) {
                return fmt::format("the file is truncated: {} bytes cannot hold {} x {} pixels",
                                   bytes.size(), width, height);
            }
        }
        at += 2 + length;
        if (marker == 0xDA) {
            // Within the scan, 0xFF is always followed by a zero or a restart marker.
            const bool ends = bytes.find("\xFF\xD9", at) != std::string_view::npos;
            return ends ? std::string() : truncated;
        }
    }
    return truncated;
}

// OpenEXR File Layout: magic number, version, then attributes (name, type, length, value) up to an
// empty name. A file with several parts has several such lists, ended by an empty one.
std::string exr_problem(std::string_view bytes) {
    constexpr const char* truncated = "the file is truncated";
    const auto integer = [&](std::size_t at) {
        return ByteReader(bytes.substr(std::min(at, bytes.size())), "", std::endian::little)
            .read<std::int32_t>();
    };
    try {
        constexpr std::int32_t several_parts = 0x1000;
        const bool parts = (integer(4) & several_parts) != 0;
        std::size_t at = 8;
        bool list_is_empty = true;
        while (at < bytes.size()) {
            if (bytes[at] == 0) {
                if (list_is_empty || !parts) return {};
                ++at;
                list_is_empty = true;
                continue;
            }
            list_is_empty = false;
            const std::size_t name_end = bytes.find('\0', at);
            const std::size_t type_end =
                name_end == std::string_view::npos ? name_end : bytes.find('\0', name_end + 1);
            if (type_end == std::string_view::npos) return truncated;
            const std::int32_t length = integer(type_end + 1);
            const std::size_t value = type_end + 5;
            if (length < 0 || static_cast<std::size_t>(length) > bytes.size() - value) {
                return truncated;
            }
            const std::string_view name = bytes.substr(at, name_end - at);
            if ((name == "dataWindow" || name == "displayWindow") && length == 16) {
                const auto extent = [&](std::size_t low, std::size_t high) {
                    const std::int64_t size =
                        std::int64_t{integer(value + high)} - integer(value + low) + 1;
                    return static_cast<std::uint64_t>(std::max<std::int64_t>(size, 0));
                };
                std::string excess = size_problem(extent(0, 8), extent(4, 12), 1);
                if (!excess.empty()) return excess;
            }
            at = value + static_cast<std::size_t>(length);
        }
    } catch (const FileError&) {  // a number after the end of the file
    }
    return truncated;
}

}  // namespace lancer::io
