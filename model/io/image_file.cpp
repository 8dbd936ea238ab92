#include "model/io/image_file.h"

#include <fmt/format.h>

#include <string_view>

#include "model/diagnostic.h"
#include "model/io/file.h"
#include "model/io/images_apart.h"
#include "model/io/pfm_file.h"
#include "model/io/picture_format.h"
#include "model/io/picture_input.h"
#include "model/io/png_file.h"
#include "model/io/ppm_file.h"
#include "model/io/row_encoder.h"

namespace lancer::io {
namespace {

std::string lower_case_ending(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return ending;
}

/// The format of files with this ending, as the module calls it; empty when there is none.
std::string format_of_ending(const std::string& ending) {
    if (ending == "png" || ending == "ppm" || ending == "hdr") return ending;
    if (ending == "exr") return "openexr";
    if (ending == "tif" || ending == "tiff") return "tiff";
    if (ending == "jpg" || ending == "jpeg") return "jpeg";
    return {};
}

/// The format of a file by its first bytes, whatever its name; empty when it is unknown.
std::string format_of_bytes(std::string_view bytes) {
    using namespace std::string_view_literals;
    if (is_png(bytes)) return "png";
    if (is_ppm(bytes)) return "ppm";
    if (is_pfm(bytes)) return "pfm";
    if (bytes.starts_with("\x76\x2F\x31\x01"sv)) return "openexr";
    if (bytes.starts_with("#?RADIANCE"sv) || bytes.starts_with("#?RGBE"sv)) return "hdr";
    if (bytes.starts_with("\xFF\xD8\xFF"sv)) return "jpeg";
    for (const std::string_view magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
        if (bytes.starts_with(magic)) return "tiff";
    }
    return {};
}

/// Gives the bytes of a file. Throws FileError.
void encode_rows(const std::string& path, const StoredShape& shape, const RowOf& row,
                 const ImageWriteOptions& options, const AddBytes& add) {
    const std::string format = format_of_name(path);
    if (format == "png")
        encode_png(shape, options, path, row, add);
    else if (format == "ppm")
        encode_ppm(shape, row, add);
    else
        add(encode_apart(shape, row, format, path));
}

void refuse_problems(const std::string& path, const Image& like) {
    if (like.width < 1 || like.height < 1 || like.channels < 1) {
        throw FileError(fmt::format("cannot write '{}': the picture has no pixels", path));
    }
    if (!is_writable_image_name(path)) {
        throw FileError(
            fmt::format("cannot write '{}': the name of a picture must end in .png .exr .hdr .tif "
                        ".tiff .jpg .jpeg or .ppm",
                        path));
    }
}

}  // namespace

std::string format_of_name(const std::string& path) {
    const std::string format = format_of_ending(lower_case_ending(path));
    return format.empty() && is_stream(path) ? "png" : format;
}

bool is_writable_image_name(const std::string& path) {
    return !format_of_name(path).empty();
}

std::string encode_image(const std::string& path, const StoredShape& shape, const RowOf& row,
                         const ImageWriteOptions& options) {
    std::string bytes;
    encode_rows(path, shape, row, options, [&](std::string_view piece) { bytes += piece; });
    return bytes;
}

std::string encode_image(const std::string& path, const Image& image,
                         const ImageWriteOptions& options) {
    refuse_problems(path, image);
    const RowEncoder encoder(image, format_of_name(path), options);
    return encode_image(path, encoder.shape(), encoded_rows(encoder, image), options);
}

void write_image(const std::string& path, const StoredShape& shape, const RowOf& row,
                 const ImageWriteOptions& options) {
    write_pieces(path, [&](const AddBytes& add) { encode_rows(path, shape, row, options, add); });
}

void write_image(const std::string& path, const Image& image, const ImageWriteOptions& options) {
    refuse_problems(path, image);
    const RowEncoder encoder(image, format_of_name(path), options);
    write_image(path, encoder.shape(), encoded_rows(encoder, image), options);
}

Image read_image(const std::string& path, ColorSpace space) {
    PictureInput input(path);
    const std::string format = format_of_bytes(input.start());
    if (format == "png") return decode_png(input.bytes(), path, space);
    if (format == "ppm") return decode_ppm(input.bytes(), path, space);
    if (format == "pfm") return decode_pfm(input.bytes(), path);
    if (format.empty()) {
        throw FileError(fmt::format(
            "cannot read '{}': it is not a PNG, EXR, HDR, TIFF, JPEG, PPM or PFM picture", path));
    }
    return read_apart(path, format, input.descriptor(), space);
}

}  // namespace lancer::io
