#include "model/io/module/jpeg.h"

#include <csetjmp>
#include <cstdio>  // jpeglib.h needs it
#include <cstring>
#include <vector>

#include <jpeglib.h>

#include <jerror.h>

#include "model/io/byte_reader.h"
#include "model/io/image_limits.h"
#include "model/io/module/cmyk.h"

namespace lancer::io {
namespace {

/// libjpeg's errors return here by longjmp. They jump over C code only: no object of C++ may be
/// constructed or destroyed in between.
struct Errors {
    jpeg_error_mgr manager{};  ///< must be first: libjpeg knows only this member
    std::jmp_buf back{};
    char text[JMSG_LENGTH_MAX] = {};
};

[[noreturn]] void jump_back(j_common_ptr info) {
    auto* errors = reinterpret_cast<Errors*>(info->err);
    info->err->format_message(info, errors->text);
    std::longjmp(errors->back, 1);
}

/// Warnings about invented pixels end the reading.
void weigh_warning(j_common_ptr info, int level) {
    if (level >= 0) return;  // a trace
    switch (info->err->msg_code) {
        case JWRN_ARITH_BAD_CODE:
        case JWRN_BOGUS_PROGRESSION:
        case JWRN_HIT_MARKER:
        case JWRN_HUFF_BAD_CODE:
        case JWRN_JPEG_EOF:
        case JWRN_MUST_RESYNC:
            jump_back(info);
        default:
            return;
    }
}

void say_nothing(j_common_ptr) {}

/// The orientation in an EXIF segment (CIPA DC-008, 4.6.4), which has the form of a TIFF file; 1
/// when there is none.
int exif_orientation(std::string_view segment) {
    constexpr std::string_view mark("Exif\0\0", 6);
    if (!segment.starts_with(mark)) return 1;
    segment.remove_prefix(mark.size());
    const auto order = segment.starts_with("MM") ? std::endian::big : std::endian::little;
    try {
        const auto at = [&](std::size_t place) {
            return ByteReader(segment.substr(std::min(place, segment.size())), "", order);
        };
        ByteReader directory = at(at(4).read<std::uint32_t>());
        for (auto left = directory.read<std::uint16_t>(); left > 0; --left) {
            const auto tag = directory.read<std::uint16_t>();
            const auto type = directory.read<std::uint16_t>();
            const auto count = directory.read<std::uint32_t>();
            const auto value = directory.read<std::uint16_t>();
            directory.read<std::uint16_t>();
            constexpr int orientation = 0x0112;
            constexpr int whole_number = 3;  // of 16 bits
            if (tag == orientation && type == whole_number && count == 1)
                return value >= 1 && value <= 8 ? value : 1;
        }
    } catch (const FileError&) {  // damaged, as is common: no orientation
    }
    return 1;
}

/// libjpeg's state, freed by the destructor.
struct Decompressor {
    jpeg_decompress_struct info{};
    Errors errors;
    Decompressor() {
        info.err = jpeg_std_error(&errors.manager);
        errors.manager.error_exit = jump_back;
        errors.manager.emit_message = weigh_warning;
        errors.manager.output_message = say_nothing;
    }
    ~Decompressor() { jpeg_destroy_decompress(&info); }
    Decompressor(const Decompressor&) = delete;
    Decompressor& operator=(const Decompressor&) = delete;

    // Each function returns false when it fails, with the reason in errors.text.
    bool open(std::string_view bytes) {
        if (setjmp(errors.back) != 0) return false;
        jpeg_create_decompress(&info);
        jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
        jpeg_save_markers(&info, JPEG_APP0 + 1, 0xFFFF);
        return jpeg_read_header(&info, TRUE) == JPEG_HEADER_OK;
    }
    bool start() {
        if (setjmp(errors.back) != 0) return false;
        const J_COLOR_SPACE space = info.jpeg_color_space;
        if (space == JCS_CMYK || space == JCS_YCCK) info.out_color_space = JCS_CMYK;
        return jpeg_start_decompress(&info) == TRUE;
    }
    bool row(unsigned char* out) {
        if (setjmp(errors.back) != 0) return false;
        return jpeg_read_scanlines(&info, &out, 1) == 1;
    }
    bool finish() {
        if (setjmp(errors.back) != 0) return false;
        return jpeg_finish_decompress(&info) == TRUE;
    }
    std::string reason() const { return errors.text; }
};

}  // namespace

std::string read_jpeg(std::string_view bytes, PictureSink& sink) {
    Decompressor file;
    if (!file.open(bytes)) return file.reason();
    std::string excess =
        size_problem(file.info.image_width, file.info.image_height, file.info.num_components);
    if (!excess.empty()) return excess;
    if (!file.start()) return file.reason();

    StoredShape shape;
    shape.width = static_cast<int>(file.info.output_width);
    shape.height = static_cast<int>(file.info.output_height);
    const std::size_t components = static_cast<std::size_t>(file.info.output_components);
    const bool cmyk = file.info.out_color_space == JCS_CMYK;
    if (components != 1 && components != 3 && !cmyk) return "its colour channels are unknown";
    shape.channels = components == 1 ? 1 : 3;
    for (jpeg_saved_marker_ptr marker = file.info.marker_list; marker != nullptr;
         marker = marker->next) {
        shape.orientation =
            exif_orientation({reinterpret_cast<const char*>(marker->data), marker->data_length});
        if (shape.orientation != 1) break;
    }
    sink.shape(shape);

    const std::size_t width = file.info.output_width;
    std::vector<unsigned char> row(width * components);
    for (int y = 0; y < shape.height; ++y) {
        if (!file.row(row.data())) return file.reason();
        if (cmyk) {
            // Only Adobe's programs write such files; they store the complement of the ink.
            if (file.info.saw_Adobe_marker == TRUE)
                for (unsigned char& ink : row) ink = static_cast<unsigned char>(255 - ink);
            rgb_from_cmyk(row.data(), width);
        }
        sink.bytes(row.data(), shape.row_bytes());
    }
    return file.finish() ? std::string() : file.reason();
}

}  // namespace lancer::io
