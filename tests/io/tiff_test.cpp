// TIFF files as other programs write them, and damaged ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "model/io/image_file.h"
#include "model/srgb.h"
#include "tests/io/scratch_folder.h"
#include "tests/io/tiff_file.h"

namespace lancer::io {
namespace {

using testing::HasSubstr;

class Tiff : public testing::Test {
  protected:
    Image read(const std::string& bytes) const {
        put(folder_ / "a.tif", bytes);
        return read_image(folder_ / "a.tif", ColorSpace::linear);
    }
    Image read(const TiffFile& file) const { return read(file.bytes()); }
    std::string error(const std::string& bytes) const {
        return file_error([&] { read(bytes); });
    }

  private:
    ScratchFolder folder_;
};

std::uint32_t step_at(std::uint32_t x, std::uint32_t y, std::uint32_t sample) {
    return (30 + 60 * sample + 15 * y + 3 * x) & 255;
}

void expect_steps(const Image& image, const TiffFile& file) {
    ASSERT_EQ(image.width, static_cast<int>(file.width));
    ASSERT_EQ(image.height, static_cast<int>(file.height));
    ASSERT_EQ(image.channels, static_cast<int>(file.samples));
    const double top = std::ldexp(1, static_cast<int>(file.bits)) - 1;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            for (int c = 0; c < image.channels; ++c) {
                const auto step =
                    file.value(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                               static_cast<std::uint32_t>(c));
                ASSERT_NEAR(image.pixel(x, y)[c], static_cast<double>(step) / top, 1e-5)
                    << x << ' ' << y << ' ' << c;
            }
        }
    }
}

TEST_F(Tiff, IsReadPlaneByPlaneWithAnyNumberOfRowsToAStrip) {
    for (const bool packed : {false, true}) {
        for (const std::uint32_t rows : {1U, 2U, 3U, 5U, 7U, 8U, 12U, 13U, 16U, 17U, 20U, 40U}) {
            TiffFile file;
            file.height = 40;
            file.rows_per_strip = rows;
            file.separate = true;
            file.pack_bits = packed;
            file.value = step_at;
            expect_steps(read(file), file);
        }
    }
}

TEST_F(Tiff, OfTilesReachesBeyondThePicture) {
    for (const bool separate : {false, true}) {
        for (const std::uint32_t bits : {1U, 4U, 8U, 16U}) {
            TiffFile file;
            file.width = 37;
            file.height = 21;
            file.tile = 16;
            file.bits = bits;
            file.separate = separate;
            file.value = [bits](auto x, auto y, auto s) {
                return step_at(x, y, s) * 257u >> (16 - bits);
            };
            expect_steps(read(file), file);
        }
    }
}

TEST_F(Tiff, OfInksIsLightInStripsAndTilesAlike) {
    for (const std::uint32_t tile : {0U, 16U}) {
        for (const bool separate : {false, true}) {
            for (const std::uint32_t size : {16U, 20U}) {
                TiffFile file;
                file.width = file.height = size;
                file.samples = 4;
                file.photometric = 5;
                file.tile = tile;
                file.separate = separate;
                file.value = [](auto, auto, auto ink) {
                    return std::vector<std::uint64_t>{200, 40, 90, 30}[ink];
                };
                const Image image = read(file);
                ASSERT_EQ(image.channels, 3);
                for (std::size_t i = 0; i < image.data.size(); i += 3) {
                    ASSERT_NEAR(image.data[i], 49 / 255.0, 1e-9);  // (1 - 200/255) (1 - 30/255)
                    ASSERT_NEAR(image.data[i + 1], 190 / 255.0, 1e-9);
                    ASSERT_NEAR(image.data[i + 2], 146 / 255.0, 1e-9);
                }
            }
        }
    }
}

TEST_F(Tiff, OfInksWithAlphaKeepsIt) {
    TiffFile file;
    file.samples = 5;
    file.bits = 16;
    file.photometric = 5;
    file.extra = {2};
    file.value = [](auto, auto, auto s) { return s < 4 ? 0 : 0x8000; };
    const Image image = read(file);
    ASSERT_EQ(image.channels, 4);
    EXPECT_EQ(image.data[0], 1);
    EXPECT_NEAR(image.data[3], 0.5, 1e-4);
}

TEST_F(Tiff, HasAnyBits) {
    for (std::uint32_t bits = 1; bits <= 16; ++bits) {
        for (const std::uint32_t samples : {1U, 3U}) {
            TiffFile file;
            file.width = 11;
            file.bits = bits;
            file.samples = samples;
            file.photometric = samples == 1 ? 1 : 2;
            file.value = [bits](auto x, auto y, auto s) {
                return step_at(x, y, s) * 257u >> (16 - bits);
            };
            const Image image = read(file);
            ASSERT_EQ(image.channels, static_cast<int>(samples));
            const double top = std::ldexp(1, static_cast<int>(bits)) - 1;
            const double half_a_step = bits <= 8 ? 0.51 / 255 : 0.51 / 65535;
            for (std::uint32_t x = 0; x < 11; ++x) {
                EXPECT_NEAR(image.pixel(static_cast<int>(x), 2)[0],
                            static_cast<double>(file.value(x, 2, 0)) / top, half_a_step)
                    << bits;
            }
        }
    }
}

TEST_F(Tiff, WhoseZeroIsWhiteIsTurnedAtEveryDepth) {
    for (const std::uint32_t bits : {1U, 4U, 8U, 16U}) {
        TiffFile file;
        file.bits = bits;
        file.samples = 1;
        file.photometric = 0;
        file.value = [bits](auto x, auto, auto) { return x == 0 ? 0 : (1u << bits) - 1; };
        const Image image = read(file);
        EXPECT_EQ(image.data[0], 1) << bits;
        EXPECT_EQ(image.data[1], 0) << bits;
    }
}

TEST_F(Tiff, HasPalettesUpTo16Bits) {
    for (const std::uint32_t bits : {1U, 2U, 4U, 8U, 16U}) {
        for (const std::uint32_t scale : {1U, 257U}) {  // 8 bits, as old programs write, and 16
            TiffFile file;
            file.bits = bits;
            file.samples = 1;
            file.photometric = 3;
            file.value = [](auto x, auto, auto) { return x % 2; };
            file.palette.resize(std::size_t{3} << bits);
            file.palette[1] = 255 * scale;
            file.palette[(std::size_t{1} << bits) + 1] = 51 * scale;
            const Image image = read(file);
            ASSERT_EQ(image.channels, 3);
            EXPECT_EQ(image.data[0], 0);
            EXPECT_EQ(image.data[3], 1);
            EXPECT_NEAR(image.data[4], 0.2, 1e-12);
            EXPECT_EQ(image.data[5], 0);
        }
    }
}

TEST_F(Tiff, HasFloatsOfThreeSizes) {
    const double wanted[] = {0, 1, -2.5, 1000};
    for (const std::uint32_t bits : {16U, 32U, 64U}) {
        TiffFile file;
        file.height = 1;
        file.bits = bits;
        file.samples = 1;
        file.photometric = 1;
        file.format = 3;
        file.value = [&](auto x, auto, auto) -> std::uint64_t {
            constexpr std::uint16_t halves[] = {0, 0x3C00, 0xC100, 0x63D0};
            if (bits == 16) return halves[x];
            if (bits == 32) return std::bit_cast<std::uint32_t>(static_cast<float>(wanted[x]));
            return std::bit_cast<std::uint64_t>(wanted[x]);
        };
        EXPECT_THAT(read(file).data, testing::ElementsAreArray(wanted)) << bits;
    }
}

TEST_F(Tiff, SaysWhatItsFourthSampleIs) {
    TiffFile file;
    file.samples = 4;
    file.value = [](auto, auto, auto s) { return s == 3 ? 51 : 25; };
    file.extra = {2};
    EXPECT_NEAR(read(file).data[0], 25 / 255.0, 1e-12);
    file.extra = {1};
    EXPECT_NEAR(read(file).data[0], 25 / 51.0, 1e-12);
    file.extra = {0};
    const Image other = read(file);
    EXPECT_EQ(other.color_channels(), 3);
    EXPECT_EQ(other.extra_names.size(), 1u);
}

TEST_F(Tiff, IsShownUpright) {
    // The picture, four wide and two high, in which each pixel is its place.
    const auto shown = [](std::uint32_t x, std::uint32_t y) { return 10 * y + x; };
    for (std::uint32_t orientation = 1; orientation <= 8; ++orientation) {
        TiffFile file;
        const bool turned = orientation >= 5;
        file.width = turned ? 2 : 4;
        file.height = turned ? 4 : 2;
        file.samples = 1;
        file.photometric = 1;
        file.orientation = orientation;
        // TIFF 6.0, page 36: what the stored row 0 and column 0 are.
        file.value = [&](std::uint32_t column, std::uint32_t row, auto) {
            switch (orientation) {
                case 1:
                    return shown(column, row);
                case 2:
                    return shown(3 - column, row);
                case 3:
                    return shown(3 - column, 1 - row);
                case 4:
                    return shown(column, 1 - row);
                case 5:
                    return shown(row, column);
                case 6:
                    return shown(3 - row, column);
                case 7:
                    return shown(3 - row, 1 - column);
                default:
                    return shown(row, 1 - column);
            }
        };
        const Image image = read(file);
        ASSERT_EQ(image.width, 4);
        ASSERT_EQ(image.height, 2);
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 4; ++x)
                EXPECT_NEAR(image.pixel(x, y)[0] * 255, 10 * y + x, 1e-9) << orientation;
    }
}

TEST_F(Tiff, CutShortIsAnErrorAtEveryByte) {
    for (const bool packed : {false, true}) {
        for (const std::uint32_t tile : {0U, 16U}) {
            TiffFile file;
            file.rows_per_strip = 2;
            file.pack_bits = packed;
            file.tile = tile;
            file.value = step_at;
            const std::string bytes = file.bytes();
            for (std::size_t size = 0; size < bytes.size(); size += size < 200 ? 1 : 37)
                EXPECT_THAT(error(bytes.substr(0, size)), HasSubstr("a.tif")) << size;
            EXPECT_THAT(error(bytes.substr(0, bytes.size() - 1)), HasSubstr("truncated"));
        }
    }
}

TEST_F(Tiff, WithItsDirectoryBehindItsEndIsTruncated) {
    EXPECT_THAT(error(std::string("II*\0\0\x10\0\0abcdefgh", 16)), HasSubstr("truncated"));
    EXPECT_THAT(error(std::string("MM\0*\0\0\x10\0abcdefgh", 16)), HasSubstr("truncated"));
    EXPECT_THAT(error(std::string("II*\0", 4)), HasSubstr("truncated"));
}

TEST_F(Tiff, WithAStripTooShortForItsRowsIsAnError) {
    TiffFile file;
    file.pack_bits = true;
    file.value = step_at;
    std::string bytes = file.bytes();
    // The strip claims half its length: tag 279, one value of 4 bytes.
    const std::size_t tag = bytes.find(std::string("\x17\x01\x04\0\x01\0\0\0", 8));
    ASSERT_NE(tag, std::string::npos);
    bytes[tag + 8] = static_cast<char>(bytes[tag + 8] / 2);
    EXPECT_THAT(error(bytes), HasSubstr("a.tif"));
}

TEST_F(Tiff, TakesNoMemoryForStripsAndTilesThatAFewBytesClaim) {
    TiffFile file;
    file.value = step_at;
    file.tile = 16;
    file.claimed_tile = 1u << 28;
    EXPECT_THAT(error(file.bytes()), HasSubstr("tiles of 16 x 268435456 pixels"));
    file.claimed_tile = 1u << 17;
    file.width = 40;
    file.samples = 64;
    file.bits = 64;
    file.format = 3;
    EXPECT_THAT(error(file.bytes()), HasSubstr("a row of tiles of 3584 MiB"));
    file.tile = 0;
    file.pack_bits = true;
    file.height = 1;
    file.rows_per_strip = 1;
    file.value = [](auto, auto, auto) { return 0; };
    std::string bytes = file.bytes();
    const auto claim = [&](const std::string& tag, const std::string& value) {
        const std::size_t at = bytes.find(tag);
        ASSERT_NE(at, std::string::npos);
        bytes.replace(at + 8, 4, value);
    };
    claim(std::string("\x01\x01\x04\0\x01\0\0\0", 8), std::string("\0\0\x02\0", 4));
    claim(std::string("\x16\x01\x04\0\x01\0\0\0", 8), std::string("\0\0\x02\0", 4));
    EXPECT_THAT(error(bytes), HasSubstr("a strip of 2560 MiB"));
}

TEST_F(Tiff, RefusesWhatHasNoMeaningHere) {
    TiffFile file;
    file.value = step_at;
    file.bits = 24;
    EXPECT_THAT(error(file.bytes()), HasSubstr("24 bits"));
    file.bits = 8;
    file.photometric = 32803;  // the raw cells of a camera
    EXPECT_THAT(error(file.bytes()), HasSubstr("32803"));
    file.photometric = 3;
    file.samples = 1;
    file.bits = 4;
    file.value = [](auto, auto, auto) { return 1; };
    EXPECT_THAT(error(file.bytes()), HasSubstr("a.tif"));  // no palette
}

}  // namespace
}  // namespace lancer::io
