#include <zlib.h>

#include "model/io/png_file.h"

namespace lancer::io {
namespace {

std::string big_endian(unsigned long value) {
    std::string bytes;
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 0xFF);
    return bytes;
}

}  // namespace

std::string with_png_text(std::string png, const std::string& keyword, const std::string& text) {
    constexpr std::size_t end_chunk = 12;  // length, "IEND" and checksum
    const std::string content = "tEXt" + keyword + std::string(1, '\0') + text;
    const unsigned long checksum =
        crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
    png.insert(png.size() - end_chunk,
               big_endian(content.size() - 4) + content + big_endian(checksum));
    return png;
}

}  // namespace lancer::io
