// JPEG files of every kind of coding. Made by libjpeg, which reads them, too: what is tested is how
// it is asked.
#include <gtest/gtest.h>

#include <cstdio>  // jpeglib.h needs it before
#include <cstdlib>
#include <functional>
#include <string_view>

#include <jpeglib.h>

#include "tests/io/odd_pictures.h"

namespace lancer::io {
namespace {

struct JpegFile {
    int width = 24, height = 16;
    J_COLOR_SPACE space = JCS_RGB;
    std::vector<unsigned char> pixel{200, 100, 50};
    std::function<void(jpeg_compress_struct&)> before = [](auto&) {};  ///< is compressed
    std::function<void(jpeg_compress_struct&)> head = [](auto&) {};    ///< markers of its own

    std::string bytes() const {
        jpeg_compress_struct info{};
        jpeg_error_mgr errors{};
        info.err = jpeg_std_error(&errors);
        jpeg_create_compress(&info);
        unsigned char* memory = nullptr;
        unsigned long size = 0;
        jpeg_mem_dest(&info, &memory, &size);
        info.image_width = static_cast<JDIMENSION>(width);
        info.image_height = static_cast<JDIMENSION>(height);
        info.input_components = static_cast<int>(pixel.size());
        info.in_color_space = space;
        jpeg_set_defaults(&info);
        jpeg_set_quality(&info, 100, TRUE);
        before(info);
        jpeg_start_compress(&info, TRUE);
        head(info);
        std::vector<unsigned char> row;
        for (int x = 0; x < width; ++x) row.insert(row.end(), pixel.begin(), pixel.end());
        unsigned char* rows = row.data();
        for (int y = 0; y < height; ++y) jpeg_write_scanlines(&info, &rows, 1);
        jpeg_finish_compress(&info);
        const std::string result(reinterpret_cast<const char*>(memory), size);
        jpeg_destroy_compress(&info);
        std::free(memory);
        return result;
    }
};

void sample_colors(jpeg_compress_struct& info, int across, int down) {
    info.comp_info[0].h_samp_factor = across;
    info.comp_info[0].v_samp_factor = down;
}

/// Fill bytes, which may stand before any marker.
std::string with_fill_bytes(std::string bytes) {
    return bytes.insert(2, "\xFF\xFF\xFF");
}

void write_marker(jpeg_compress_struct& info, int marker, std::string_view data) {
    jpeg_write_marker(&info, marker, reinterpret_cast<const JOCTET*>(data.data()),
                      static_cast<unsigned>(data.size()));
}

TEST(OddFiles, TenJpeg) {
    const auto coded = [](std::function<void(jpeg_compress_struct&)> before) {
        JpegFile file;
        file.before = std::move(before);
        return file.bytes();
    };
    JpegFile odd_size;
    odd_size.width = 17, odd_size.height = 9;
    odd_size.before = [](auto& info) { sample_colors(info, 2, 2); };
    JpegFile one_pixel;
    one_pixel.width = one_pixel.height = 1;
    JpegFile gray;
    gray.space = JCS_GRAYSCALE, gray.pixel = {100};
    JpegFile inks;  // as Adobe's programs store them: what is left white
    inks.space = JCS_CMYK, inks.pixel = {255, 51, 102, 255};
    JpegFile turned_inks = inks;
    turned_inks.before = [](auto& info) { jpeg_set_colorspace(&info, JCS_YCCK); };
    JpegFile talkative;
    talkative.head = [](auto& info) {
        write_marker(info, JPEG_COM, "made by hand");
        write_marker(info, JPEG_APP0 + 1, "http://ns.adobe.com/xap/1.0/");
        write_marker(info, JPEG_APP0 + 2, std::string_view("ICC_PROFILE\0\1\1no profile", 24));
        write_marker(info, JPEG_APP0 + 13, "Photoshop 3.0");
    };
    const std::vector<double> color{200 / 255.0, 100 / 255.0, 50 / 255.0};
    const std::vector<double> light{1, 0.2, 0.4};
    std::vector<OddPicture> files{
        {"progressive", coded([](auto& info) { jpeg_simple_progression(&info); }), 24, 16, color},
        {"arithmetic coding", coded([](auto& info) { info.arith_code = TRUE; }), 24, 16, color},
        {"progressive and arithmetic", coded([](auto& info) {
             jpeg_simple_progression(&info);
             info.arith_code = TRUE;
         }),
         24, 16, color},
        {"colours of two by two pixels, which do not divide the size", odd_size.bytes(), 17, 9,
         color},
        {"colours of four pixels in a row", coded([](auto& info) { sample_colors(info, 4, 1); }),
         24, 16, color},
        {"a restart marker behind each block", coded([](auto& info) { info.restart_interval = 1; }),
         24, 16, color},
        {"red, green and blue as they are",
         coded([](auto& info) { jpeg_set_colorspace(&info, JCS_RGB); }), 24, 16, color},
        {"tables of its own, and the slow transform", coded([](auto& info) {
             info.optimize_coding = TRUE;
             info.dct_method = JDCT_FLOAT;
         }),
         24, 16, color},
        {"no JFIF segment", coded([](auto& info) { info.write_JFIF_header = FALSE; }), 24, 16,
         color},
        {"grey", gray.bytes(), 24, 16, {100 / 255.0}},
        {"four inks", inks.bytes(), 24, 16, light},
        {"four inks, their colours as brightness and differences", turned_inks.bytes(), 24, 16,
         light},
        {"a comment and segments that other programs read", talkative.bytes(), 24, 16, color},
        {"fill bytes before a marker", with_fill_bytes(JpegFile{}.bytes()), 24, 16, color},
        {"bytes behind its end", JpegFile{}.bytes() + "thumbnail", 24, 16, color},
        {"one pixel", one_pixel.bytes(), 1, 1, color}};
    for (OddPicture& file : files) file.step = 2.5 / 255;
    expect_read(files);
}

}  // namespace
}  // namespace lancer::io
