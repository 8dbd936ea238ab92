// Pictures with an orientation (TIFF has its own test).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "model/io/image_file.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

// Radiance: the axis that stands first changes from scanline to scanline; -Y runs from the top,
// +X from the left. The picture is four wide and two high, and each pixel is its place.
TEST(Hdr, IsShownUpright) {
    const ScratchFolder folder;
    for (const char y_sign : {'-', '+'}) {
        for (const char x_sign : {'+', '-'}) {
            for (const bool rows_first : {true, false}) {
                const std::string y_axis = std::string{y_sign} + "Y 2";
                const std::string x_axis = std::string{x_sign} + "X 4";
                std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" +
                                    (rows_first ? y_axis + " " + x_axis : x_axis + " " + y_axis) +
                                    "\n";
                for (int i = 0; i < 8; ++i) {
                    const int row = rows_first ? i / 4 : i % 2;
                    const int column = rows_first ? i % 4 : i / 2;
                    const int y = y_sign == '-' ? row : 1 - row;
                    const int x = x_sign == '+' ? column : 3 - column;
                    bytes.append(3, static_cast<char>(16 + 10 * y + x)).push_back('\x88');
                }
                put(folder / "a.hdr", bytes);
                const Image image = read_image(folder / "a.hdr");
                ASSERT_EQ(image.width, 4);
                ASSERT_EQ(image.height, 2);
                for (int y = 0; y < 2; ++y)
                    for (int x = 0; x < 4; ++x)
                        EXPECT_EQ(image.pixel(x, y)[0], 16 + 10 * y + x) << y_sign << x_sign;
            }
        }
    }
}

std::string number(std::uint32_t value, int size, bool big) {
    std::string out;
    for (int i = 0; i < size; ++i) out.push_back(static_cast<char>(value >> 8 * i));
    if (big) std::reverse(out.begin(), out.end());
    return out;
}

/// An EXIF segment with two entries, of which the second is the orientation.
std::string exif(std::uint32_t orientation, bool big) {
    std::string data = std::string("Exif\0\0", 6) + (big ? "MM" : "II") + number(42, 2, big) +
                       number(8, 4, big) + number(2, 2, big);
    data += number(0x0100, 2, big) + number(4, 2, big) + number(1, 4, big) + number(32, 4, big);
    data += number(0x0112, 2, big) + number(3, 2, big) + number(1, 4, big) +
            number(orientation, 2, big) + number(0, 2, big);
    data += number(0, 4, big);
    return "\xFF\xE1" + number(static_cast<std::uint32_t>(data.size()) + 2, 2, true) + data;
}

TEST(Jpeg, IsShownUpright) {
    const ScratchFolder folder;
    // A picture of four fields, with their values in the upright picture.
    const auto field = [](int x, int y) { return 0.1 + 0.5 * y + 0.3 * x; };
    for (std::uint32_t orientation = 1; orientation <= 8; ++orientation) {
        const bool turned = orientation >= 5;
        Image stored(turned ? 16 : 32, turned ? 32 : 16);
        for (int row = 0; row < stored.height; ++row) {
            for (int column = 0; column < stored.width; ++column) {
                int x = 2 * column / stored.width;
                int y = 2 * row / stored.height;
                // EXIF 2.32, 4.6.4: the visual side of the stored row 0, then of column 0.
                switch (orientation) {
                    case 2:
                        x = 1 - x;
                        break;
                    case 3:
                        x = 1 - x, y = 1 - y;
                        break;
                    case 4:
                        y = 1 - y;
                        break;
                    case 5:
                        std::swap(x, y);
                        break;
                    case 6:
                        std::swap(x, y), x = 1 - x;
                        break;
                    case 7:
                        std::swap(x, y), x = 1 - x, y = 1 - y;
                        break;
                    case 8:
                        std::swap(x, y), y = 1 - y;
                        break;
                    default:
                        break;
                }
                std::fill_n(stored.pixel(column, row), 3, field(x, y));
            }
        }
        write_image(folder / "a.jpg", stored, {});
        for (const bool big : {false, true}) {
            std::string bytes = contents(folder / "a.jpg");
            bytes.insert(2, exif(orientation, big));
            put(folder / "b.jpg", bytes);
            const Image image = read_image(folder / "b.jpg");
            ASSERT_EQ(image.width, 32);
            ASSERT_EQ(image.height, 16);
            for (int y = 0; y < 2; ++y)
                for (int x = 0; x < 2; ++x)
                    EXPECT_NEAR(image.pixel(8 + 16 * x, 4 + 8 * y)[0], field(x, y), 0.01)
                        << orientation;
        }
    }
}

TEST(Jpeg, WithDamagedExifDataIsShownAsItIs) {
    const ScratchFolder folder;
    write_image(folder / "a.jpg", Image(32, 16), {});
    const std::string segment = exif(6, false);
    for (std::size_t at = 4; at < segment.size(); ++at) {
        for (const char value : {'\0', '\xFF', '\x7F'}) {
            std::string damaged = segment;
            damaged[at] = value;
            std::string bytes = contents(folder / "a.jpg");
            bytes.insert(2, damaged);
            put(folder / "b.jpg", bytes);
            const Image image = read_image(folder / "b.jpg");
            EXPECT_EQ(image.width + image.height, 48);
        }
    }
}

}  // namespace
}  // namespace lancer::io
