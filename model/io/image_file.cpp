#include "model/io/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "model/diagnostic.h"
#include "model/io/file.h"
#include "model/io/image_checks.h"
#include "model/io/image_module.h"
#include "model/io/png_file.h"
#include "model/io/ppm_file.h"
#include "model/io/quantize.h"

namespace lancer::io {
namespace {

std::string lower_case_ending(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return ending;
}

/// The format that files with this ending have, by the name the module knows; empty: none.
std::string format_of_ending(const std::string& ending) {
    if (ending == "png" || ending == "ppm" || ending == "hdr") return ending;
    if (ending == "exr") return "openexr";
    if (ending == "tif" || ending == "tiff") return "tiff";
    if (ending == "jpg" || ending == "jpeg") return "jpeg";
    return {};
}

/// The format to write: by the ending of the name; PNG for a device or pipe that has none.
std::string format_of_name(const std::string& path) {
    const std::string format = format_of_ending(lower_case_ending(path));
    return format.empty() && is_stream(path) ? "png" : format;
}

/// The format of a file by its first bytes, whatever it is called; empty: none we read.
std::string format_of_bytes(std::string_view bytes) {
    using namespace std::string_view_literals;
    if (is_png(bytes)) return "png";
    if (is_ppm(bytes)) return "ppm";
    if (bytes.starts_with("\x76\x2F\x31\x01"sv)) return "openexr";
    if (bytes.starts_with("#?RADIANCE"sv) || bytes.starts_with("#?RGBE"sv)) return "hdr";
    if (bytes.starts_with("\xFF\xD8\xFF"sv)) return "jpeg";
    for (const std::string_view magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
        if (bytes.starts_with(magic)) return "tiff";
    }
    return {};
}

/// The numbers that stand in a file of this format.
StoredImage stored_image(const Image& image, const std::string& format,
                         const ImageWriteOptions& options) {
    StoredImage stored;
    stored.bits = format == "jpeg" ? 8 : format == "tiff" ? options.bits : 32;
    stored.premultiplied = format == "openexr" && image.color_channels() == 4;
    const bool all = format == "openexr";
    const int color = image.color_channels();
    const int kept = all ? image.channels : format == "tiff" ? color : std::min(color, 3);
    const int channels = format == "hdr" ? 3 : kept;  // RGBE has nothing else
    stored.image = Image(image.width, image.height, channels);
    if (all) stored.image.extra_names = image.extra_names;

    const Quantizer quantizer(stored.bits, options.linear);
    double* out = stored.image.data.data();
    for (std::size_t at = 0; at < image.data.size();
         at += static_cast<std::size_t>(image.channels)) {
        const double* pixel = &image.data[at];
        for (int c = 0; c < channels; ++c) {
            double value = pixel[std::min(c, kept - 1)];
            const bool alpha = c == 3 && color == 4;
            if (stored.bits < 32) {
                value = alpha ? quantizer.raw(value) : quantizer.encoded(value);
            } else if (stored.premultiplied && c < 3) {
                value *= pixel[3];
            } else if (format == "hdr") {
                constexpr double most = 1e38;  // 2^127 is 1.7e38
                value = value > 0 ? std::min(value, most) : 0;
            }
            *out++ = value;
        }
    }
    return stored;
}

/// Linear light from the numbers of a file.
Image decoded(StoredImage stored, ColorSpace space) {
    Image& image = stored.image;
    const std::size_t channels = static_cast<std::size_t>(image.channels);
    const bool has_alpha = image.color_channels() == 4;
    if (stored.bits < 32) {
        const int top = (1 << stored.bits) - 1;
        const std::vector<double> color = space == ColorSpace::linear
                                              ? decoding_table(top, [](double v) { return v; })
                                              : decoding_table(top, srgb_decode);
        for (std::size_t i = 0; i < image.data.size(); ++i) {
            const std::size_t channel = i % channels;
            const bool encoded = channel < 3 && static_cast<int>(channel) < image.color_channels();
            image.data[i] =
                encoded ? color[static_cast<std::size_t>(image.data[i])] : image.data[i] / top;
        }
    }
    if (stored.premultiplied && has_alpha) {
        for (std::size_t i = 0; i < image.data.size(); i += channels) {
            const double alpha = image.data[i + 3];
            for (std::size_t c = 0; c < 3 && alpha != 0; ++c) image.data[i + c] /= alpha;
        }
    }
    return std::move(image);
}

}  // namespace

bool is_writable_image_name(const std::string& path) {
    return !format_of_name(path).empty();
}

void write_image(const std::string& path, const Image& image, const ImageWriteOptions& options) {
    if (image.width < 1 || image.height < 1 || image.channels < 1) {
        throw FileError(fmt::format("cannot write '{}': the picture has no pixels", path));
    }
    const std::string format = format_of_name(path);
    if (format == "png") {
        write_file(path, encode_png(image, options, path));
    } else if (format == "ppm") {
        write_file(path, encode_ppm(image, options));
    } else if (!format.empty()) {
        const StoredImage stored = stored_image(image, format, options);
        write_atomically(path, [&](const std::string& temporary) {
            const std::string problem = image_module().write(temporary, format, stored);
            if (!problem.empty()) {
                throw FileError(fmt::format("cannot write '{}': {}", path, problem));
            }
        });
    } else {
        throw FileError(fmt::format(
            "cannot write '{}': a picture ends in .png .exr .hdr .tif .tiff .jpg .jpeg or .ppm",
            path));
    }
}

Image read_image(const std::string& path, ColorSpace space) {
    const std::string bytes = read_file(path);
    const std::string format = format_of_bytes(bytes);
    if (format == "png") return decode_png(bytes, path, space);
    if (format == "ppm") return decode_ppm(bytes, path, space);
    if (format.empty()) {
        throw FileError(fmt::format(
            "cannot read '{}': it is not a PNG, EXR, HDR, TIFF, JPEG or PPM picture", path));
    }
    StoredImage stored;
    std::string problem = format == "jpeg"      ? jpeg_problem(bytes)
                          : format == "openexr" ? exr_problem(bytes)
                                                : std::string();
    if (problem.empty()) problem = image_module().read(path, format, stored);
    if (!problem.empty()) throw FileError(fmt::format("cannot read '{}': {}", path, problem));
    return decoded(std::move(stored), space);
}

}  // namespace lancer::io
