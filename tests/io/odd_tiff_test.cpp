// TIFF files of kinds that tiff_test.cpp does not write itself. Made by libtiff, which reads them,
// too: what is tested is how it is asked.
#include <gtest/gtest.h>
#include <tiffio.h>

#include <cstring>
#include <functional>

#include "tests/io/odd_pictures.h"

namespace lancer::io {
namespace {

/// Rows of 24 x 16 pixels with these bytes each; `tags` says what they mean.
std::string made(const char* mode, const std::function<void(TIFF*)>& tags,
                 const std::string& row_of_bytes, int pages = 1) {
    const ScratchFolder folder;
    TIFFSetWarningHandler(nullptr);  // of older numbers
    TIFF* file = TIFFOpen((folder / "a.tif").c_str(), mode);
    for (int page = 0; page < pages; ++page) {
        TIFFSetField(file, TIFFTAG_IMAGEWIDTH, 24);
        TIFFSetField(file, TIFFTAG_IMAGELENGTH, 16);
        TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
        TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 3);
        TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
        TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
        TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 16);
        tags(file);
        for (std::uint32_t y = 0; y < 16; ++y) {
            std::string row = row_of_bytes;
            TIFFWriteScanline(file, row.data(), y, 0);
        }
        TIFFWriteDirectory(file);
    }
    TIFFClose(file);
    return contents(folder / "a.tif");
}

template <class Value>
std::string row_of(const std::vector<Value>& pixel, int count = 24) {
    std::string row;
    for (int x = 0; x < count; ++x) {
        for (const Value& value : pixel) {
            char raw[sizeof(value)];
            std::memcpy(raw, &value, sizeof(value));
            row.append(raw, sizeof(value));
        }
    }
    return row;
}

TEST(OddFiles, TenTiff) {
    using Bytes = std::vector<std::uint8_t>;
    const std::string colors = row_of(Bytes{200, 100, 50});
    const auto coded = [](int compression, int predictor = 0) {
        return [=](TIFF* file) {
            TIFFSetField(file, TIFFTAG_COMPRESSION, compression);
            if (predictor > 0) TIFFSetField(file, TIFFTAG_PREDICTOR, predictor);
        };
    };
    const auto floats = [](TIFF* file) {
        TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 32);
        TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
        TIFFSetField(file, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
        TIFFSetField(file, TIFFTAG_PREDICTOR, 3);
    };
    const auto fax = [](int compression) {
        return [=](TIFF* file) {
            TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 1);
            TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
            TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISWHITE);
            TIFFSetField(file, TIFFTAG_COMPRESSION, compression);
        };
    };
    const auto sixteen = [](TIFF* file) { TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 16); };
    const auto backwards = [](TIFF* file) {
        TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 1);
        TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
        TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFSetField(file, TIFFTAG_FILLORDER, FILLORDER_LSB2MSB);
    };
    const auto by_jpeg = [](TIFF* file) {
        TIFFSetField(file, TIFFTAG_COMPRESSION, COMPRESSION_JPEG);
        TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_YCBCR);
        TIFFSetField(file, TIFFTAG_JPEGQUALITY, 100);
        TIFFSetField(file, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    };
    const std::vector<double> color{200 / 255.0, 100 / 255.0, 50 / 255.0};
    const std::vector<double> deep{50000 / 65535.0, 300 / 65535.0, 1 / 65535.0};
    const std::string deep_row = row_of(std::vector<std::uint16_t>{50000, 300, 1});
    const auto plain = [](TIFF*) {};
    expect_read(
        {{"the largest byte first", made("wb", sixteen, deep_row), 24, 16, deep},
         {"places of 64 bits", made("w8", plain, colors), 24, 16, color},
         {"places of 64 bits, the largest byte first", made("wb8", sixteen, deep_row), 24, 16,
          deep},
         {"LZW with differences", made("wl", coded(COMPRESSION_LZW, 2), colors), 24, 16, color},
         {"deflate", made("wl", coded(COMPRESSION_ADOBE_DEFLATE), colors), 24, 16, color},
         {"deflate by its older number", made("wb", coded(COMPRESSION_DEFLATE), colors), 24, 16,
          color},
         {"floats with differences of their bytes",
          made("wl", floats, row_of(std::vector<float>{2.5F, -1.0F, 1e-6F})),
          24,
          16,
          {2.5, -1, 9.99999997475242708e-07}},
         {"facsimile, group 3",
          made("wl", fax(COMPRESSION_CCITTFAX3), row_of(Bytes{0xFF}, 3)),
          24,
          16,
          {0}},
         {"facsimile, group 4",
          made("wl", fax(COMPRESSION_CCITTFAX4), row_of(Bytes{0}, 3)),
          24,
          16,
          {1}},
         {"bits from the lowest on", made("wl", backwards, row_of(Bytes{0xFF}, 3)), 24, 16, {1}},
         {"JPEG within", made("wl", by_jpeg, colors), 24, 16, color, 2.5 / 255},
         {"three pages, of which the first counts", made("wl", plain, colors, 3), 24, 16, color},
         {"PackBits", made("wl", coded(COMPRESSION_PACKBITS), colors), 24, 16, color}});
}

}  // namespace
}  // namespace lancer::io
