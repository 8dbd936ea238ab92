#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>

#include "model/diagnostic.h"
#include "model/io/image_limits.h"
#include "model/io/png_file.h"
#include "model/io/quantize.h"

namespace lancer::io {
namespace {

// libpng reports errors by longjmp, which skips destructors. So this struct, outside of the
// functions that call setjmp, owns all memory.
struct Reader {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string_view rest;
    std::string pixels;  ///< all rows, as libpng expanded them
    std::vector<png_bytep> rows;
    std::string message;

    Reader() = default;
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

struct Layout {
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    int channels = 0;
    int bits = 0;                   ///< 8 or 16, after expansion
    std::uint64_t stored_bits = 0;  ///< of one pixel in the file
    std::uint64_t row_bytes = 0;
    bool srgb = true;
    png_fixed_point gamma = PNG_FP_1;  ///< of the gAMA chunk, when not `srgb`
};

void on_error(png_structp png, png_const_charp message) {
    static_cast<Reader*>(png_get_error_ptr(png))->message = message;
    longjmp(png_jmpbuf(png), 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep data, std::size_t size) {
    std::string_view& rest = static_cast<Reader*>(png_get_io_ptr(png))->rest;
    if (size > rest.size()) png_error(png, "the file is truncated");
    std::memcpy(data, rest.data(), size);
    rest.remove_prefix(size);
}

/// Reads everything before the pixels, without allocating memory for them.
bool read_header(Reader& reader, Layout& layout) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_structp png = reader.png;
    png_infop info = reader.info;
    png_set_read_fn(png, &reader, on_read);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_read_info(png, info);
    layout.width = png_get_image_width(png, info);
    layout.height = png_get_image_height(png, info);
    layout.stored_bits = std::uint64_t{png_get_channels(png, info)} * png_get_bit_depth(png, info);
    layout.srgb = png_get_valid(png, info, PNG_INFO_sRGB) != 0 ||
                  png_get_gAMA_fixed(png, info, &layout.gamma) == 0 || layout.gamma <= 0;
    return true;
}

/// Requests 8 or 16 bits of grey, RGB or RGBA from libpng. After that, libpng holds rows.
bool choose_layout(Reader& reader, Layout& layout) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_structp png = reader.png;
    png_infop info = reader.info;
    png_set_expand(png);
    const bool alpha = (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0 ||
                       png_get_valid(png, info, PNG_INFO_tRNS) != 0;
    if (alpha) png_set_gray_to_rgb(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    layout.channels = png_get_channels(png, info);
    layout.bits = png_get_bit_depth(png, info);
    layout.row_bytes = png_get_rowbytes(png, info);
    return true;
}

bool read_pixels(Reader& reader) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_read_image(reader.png, reader.rows.data());
    png_read_end(reader.png, nullptr);
    return true;
}

/// The linear light of each step of the file's colours.
std::vector<double> color_table(const Layout& layout, ColorSpace space) {
    const int top = layout.bits == 16 ? 65535 : 255;
    if (space == ColorSpace::linear || (!layout.srgb && layout.gamma == PNG_FP_1)) {
        return decoding_table(top, [](double v) { return v; });
    }
    if (layout.srgb) return decoding_table(top, srgb_decode);
    const double exponent = static_cast<double>(PNG_FP_1) / layout.gamma;
    return decoding_table(top, [&](double v) { return elementary::pow(v, exponent); });
}

}  // namespace

bool is_png(std::string_view bytes) {
    return bytes.starts_with("\x89PNG\r\n\x1a\n");
}

std::string png_curve(std::string_view bytes) {
    Reader reader;
    Layout layout;
    reader.rest = bytes;
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, on_error, on_warning);
    if (reader.png != nullptr) reader.info = png_create_info_struct(reader.png);
    if (reader.info == nullptr || !read_header(reader, layout)) return {};
    if (layout.srgb) return "sRGB";
    if (layout.gamma == PNG_FP_1) return "linear";
    return fmt::format("gAMA {:.5f}", static_cast<double>(layout.gamma) / PNG_FP_1);
}

Image decode_png(std::string_view bytes, const std::string& name, ColorSpace space) {
    Reader reader;
    Layout layout;
    reader.rest = bytes;
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, on_error, on_warning);
    if (reader.png != nullptr) reader.info = png_create_info_struct(reader.png);
    if (reader.info == nullptr) reader.message = "out of memory";
    const auto fail = [&](const std::string& reason) {
        return FileError(fmt::format("cannot read '{}': {}", name, reason));
    };
    if (reader.info == nullptr || !read_header(reader, layout)) throw fail(reader.message);

    const std::string excess = size_problem(layout.width, layout.height, 1);
    if (!excess.empty()) throw fail(excess);
    // Deflate shrinks data at most 1032 times (zlib's technical details). So a small file cannot
    // hold a huge picture, and no memory is allocated for one.
    if (layout.width * layout.stored_bits / 8 * layout.height / 1032 > bytes.size()) {
        throw fail(fmt::format("the file is truncated: {} bytes cannot hold {} x {} pixels",
                               bytes.size(), layout.width, layout.height));
    }
    if (!choose_layout(reader, layout)) throw fail(reader.message);
    reader.pixels.resize(layout.row_bytes * layout.height);
    for (std::uint64_t y = 0; y < layout.height; ++y) {
        reader.rows.push_back(
            reinterpret_cast<png_bytep>(reader.pixels.data() + y * layout.row_bytes));
    }
    if (!read_pixels(reader)) throw fail(reader.message);

    Image image(static_cast<int>(layout.width), static_cast<int>(layout.height), layout.channels);
    const std::vector<double> color = color_table(layout, space);
    const double top = static_cast<double>(color.size() - 1);
    const auto* byte = reinterpret_cast<const unsigned char*>(reader.pixels.data());
    for (std::size_t i = 0; i < image.data.size(); ++i) {
        std::size_t step = *byte++;
        if (layout.bits == 16) step = step << 8 | *byte++;
        const bool is_alpha = layout.channels == 4 && i % 4 == 3;
        image.data[i] = is_alpha ? static_cast<double>(step) / top : color[step];
    }
    return image;
}

}  // namespace lancer::io
