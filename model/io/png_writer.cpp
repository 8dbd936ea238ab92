#include <png.h>

#include <csetjmp>
#include <exception>

#include "model/diagnostic.h"
#include "model/io/png_file.h"
#include "model/io/row_encoder.h"

namespace lancer::io {
namespace {

// libpng reports errors by longjmp, which skips destructors. So this struct, outside of the
// functions that call setjmp, owns all memory.
struct Writer {
    png_structp png = nullptr;
    png_infop info = nullptr;
    const AddBytes& add;
    std::string message;
    std::exception_ptr failure;      ///< what `add` threw, which must not pass through libpng
    std::vector<std::string> words;  ///< keys and values in turn
    std::vector<png_text> texts;     ///< that point to them

    Writer(const ImageWriteOptions& options, const AddBytes& add_bytes) : add(add_bytes) {
        for (const auto& [name, value] : options.notes) {
            words.push_back("lancer:" + name);
            words.push_back(value);
        }
        for (std::size_t i = 0; i < words.size(); i += 2) {
            png_text text{};
            text.compression = PNG_TEXT_COMPRESSION_NONE;
            text.key = words[i].data();
            text.text = words[i + 1].data();
            text.text_length = words[i + 1].size();
            texts.push_back(text);
        }
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() { png_destroy_write_struct(&png, &info); }
};

void on_error(png_structp png, png_const_charp message) {
    static_cast<Writer*>(png_get_error_ptr(png))->message = message;
    longjmp(png_jmpbuf(png), 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_write(png_structp png, png_bytep data, std::size_t size) {
    Writer& writer = *static_cast<Writer*>(png_get_io_ptr(png));
    try {
        writer.add({reinterpret_cast<const char*>(data), size});
    } catch (const std::exception&) {
        writer.failure = std::current_exception();
    }
    if (writer.failure) png_error(png, "the file cannot be written");
}

void on_flush(png_structp) {}

bool write(Writer& writer, const StoredShape& shape, const ImageWriteOptions& options,
           const RowOf& row) {
    if (setjmp(png_jmpbuf(writer.png))) return false;
    const int color_type = shape.channels == 1   ? PNG_COLOR_TYPE_GRAY
                           : shape.channels == 3 ? PNG_COLOR_TYPE_RGB
                                                 : PNG_COLOR_TYPE_RGB_ALPHA;
    png_set_write_fn(writer.png, &writer, on_write, on_flush);
    png_set_user_limits(writer.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    // Measured at 1920 x 1080: the usual level 6 with all filters makes files 10% smaller but takes
    // four times as long.
    png_set_compression_level(writer.png, options.bits == 8 ? 4 : 1);
    png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB | PNG_FILTER_UP);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(shape.width),
                 static_cast<png_uint_32>(shape.height), options.bits, color_type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (options.linear) {
        png_set_gAMA_fixed(writer.png, writer.info, PNG_FP_1);
    } else {
        png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    }
    if (!writer.texts.empty())
        png_set_text(writer.png, writer.info, writer.texts.data(),
                     static_cast<int>(writer.texts.size()));
    png_write_info(writer.png, writer.info);
    for (int y = 0; y < shape.height; ++y)
        png_write_row(writer.png, reinterpret_cast<png_const_bytep>(row(y)));
    png_write_end(writer.png, nullptr);
    return true;
}

}  // namespace

void encode_png(const StoredShape& shape, const ImageWriteOptions& options, const std::string& name,
                const RowOf& row, const AddBytes& add) {
    Writer writer(options, add);
    writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer, on_error, on_warning);
    if (writer.png != nullptr) writer.info = png_create_info_struct(writer.png);
    if (writer.info == nullptr) writer.message = "out of memory";
    if (writer.info == nullptr || !write(writer, shape, options, row)) {
        if (writer.failure) std::rethrow_exception(writer.failure);
        throw FileError("cannot write '" + name + "': " + writer.message);
    }
}

std::string encode_png(const Image& image, const ImageWriteOptions& options,
                       const std::string& name) {
    const RowEncoder encoder(image, "png", options);
    std::string bytes;
    encode_png(encoder.shape(), options, name, encoded_rows(encoder, image),
               [&](std::string_view piece) { bytes += piece; });
    return bytes;
}

}  // namespace lancer::io
