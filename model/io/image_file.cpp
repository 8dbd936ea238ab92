#include "model/io/image_file.h"

#include <fmt/format.h>

#include "model/diagnostic.h"
#include "model/io/file.h"
#include "model/io/png_file.h"

namespace lancer::io {
namespace {

std::string lower_case_ending(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return ending;
}

}  // namespace

bool is_writable_image_name(const std::string& path) {
    const std::string ending = lower_case_ending(path);
    for (const char* known : {"png", "exr", "hdr", "tif", "tiff", "jpg", "jpeg", "ppm"}) {
        if (ending == known) return true;
    }
    return false;
}

void write_image(const std::string& path, const Image& image, const ImageWriteOptions& options) {
    if (image.width < 1 || image.height < 1) {
        throw FileError(fmt::format("cannot write '{}': the picture has no pixels", path));
    }
    const std::string ending = lower_case_ending(path);
    if (ending == "png") {
        write_file(path, encode_png(image, options, path));
    } else {
        throw FileError(fmt::format("cannot write '{}': unknown image format", path));
    }
}

Image read_image(const std::string& path, ColorSpace space) {
    const std::string bytes = read_file(path);
    if (is_png(bytes)) return decode_png(bytes, path, space);
    throw FileError(fmt::format("cannot read '{}': unknown image format", path));
}

}  // namespace lancer::io
