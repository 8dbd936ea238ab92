#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <limits>
#include <random>

#include "model/io/file.h"
#include "model/io/image_file.h"
#include "model/io/png_file.h"
#include "model/srgb.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

using testing::HasSubstr;

/// A PNG made by libpng's simplified interface: a second way, which shares nothing with ours.
std::string foreign_png(png_uint_32 format, unsigned width, unsigned height, const void* pixels,
                        const void* palette = nullptr, unsigned colors = 0) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = format;
    image.colormap_entries = colors;
    png_alloc_size_t size = 0;
    EXPECT_TRUE(png_image_write_to_memory(&image, nullptr, &size, 0, pixels, 0, palette));
    std::string bytes(size, 0);
    EXPECT_TRUE(png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, 0, palette));
    bytes.resize(size);
    return bytes;
}

std::uint32_t crc(std::string_view bytes) {
    std::uint32_t c = 0xFFFFFFFF;
    for (const char byte : bytes) {
        c ^= static_cast<unsigned char>(byte);
        for (int i = 0; i < 8; ++i) c = (c & 1) != 0 ? 0xEDB88320 ^ (c >> 1) : c >> 1;
    }
    return ~c;
}

std::string big_endian(std::uint32_t n) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((n >> shift) & 0xFF);
    return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data +
           big_endian(crc(type + data));
}

/// The bytes with the named chunks taken out and `extra` put in behind the header.
std::string with_chunks(const std::string& png, const std::string& without,
                        const std::string& extra) {
    std::string out = png.substr(0, 33) + extra;
    for (std::size_t at = 33; at + 12 <= png.size();) {
        const auto byte = [&](std::size_t i) {
            return static_cast<std::size_t>(static_cast<unsigned char>(png[at + i]));
        };
        const std::size_t size = 12 + (byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3));
        const std::string type = png.substr(at + 4, 4);
        if (without.find(type) == std::string::npos) out += png.substr(at, size);
        at += size;
    }
    return out;
}

std::string gamma_chunk(std::uint32_t hundred_thousandths) {
    return chunk("gAMA", big_endian(hundred_thousandths));
}

/// One grey pixel of 16 bits.
std::string gray16(std::uint16_t step) {
    Image image(1, 1, 1);
    image.data[0] = step / 65535.0;
    return encode_png(image, {16, true}, "t");
}

double only_value(const std::string& png, ColorSpace space = ColorSpace::automatic) {
    const Image image = decode_png(png, "t", space);
    EXPECT_EQ(image.data.size(), 1u);
    return image.data.at(0);
}

TEST(PngWriter, RoundsToTheNearestStepOf16LinearBits) {
    Image image(5, 1, 1);
    image.data = {0.1, 0.5 / 65535, 0.49 / 65535, 0.99999, 1.0};
    const Image raw = decode_png(encode_png(image, {16, true}, "t"), "t", ColorSpace::linear);
    const double expected[] = {6554, 1, 0, 65534, 65535};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(raw.data[i] * 65535, expected[i]) << i;
}

TEST(PngWriter, EncodesSrgbAsIec61966Says) {
    // The standard's own pairs: 0.21404114048223255 is encoded 0.5; 0.0031308 is the joint.
    Image image(3, 1, 1);
    image.data = {0.21404114048223255, 0.18, 0.001};
    const Image raw8 = decode_png(encode_png(image, {8, false}, "t"), "t", ColorSpace::linear);
    EXPECT_EQ(raw8.data[0] * 255, 128);  // 127.5 and a little
    EXPECT_EQ(raw8.data[1] * 255, 118);
    EXPECT_EQ(raw8.data[2] * 255, 3);
    const Image raw16 = decode_png(encode_png(image, {16, false}, "t"), "t", ColorSpace::linear);
    EXPECT_EQ(std::round(raw16.data[1] * 65535), 30235);
    EXPECT_EQ(std::round(raw16.data[2] * 65535), 847);
}

TEST(PngWriter, DefinesWhatIsOutsideTheRange) {
    const double inf = std::numeric_limits<double>::infinity();
    Image image(5, 1, 1);
    image.data = {-1, 2, inf, -inf, std::numeric_limits<double>::quiet_NaN()};
    for (const int bits : {8, 16}) {
        for (const bool linear : {false, true}) {
            const Image raw =
                decode_png(encode_png(image, {bits, linear}, "t"), "t", ColorSpace::linear);
            EXPECT_THAT(raw.data, testing::ElementsAre(0, 1, 1, 0, 0));
        }
    }
}

TEST(PngWriter, SaysHowItIsEncoded) {
    const Image image(1, 1, 3);
    EXPECT_THAT(encode_png(image, {8, false}, "t"), HasSubstr("sRGB"));
    EXPECT_THAT(encode_png(image, {16, true}, "t"), HasSubstr(gamma_chunk(100000)));
    EXPECT_THAT(encode_png(image, {16, true}, "t"), testing::Not(HasSubstr("sRGB")));
}

TEST(PngWriter, LeavesExtraChannelsOut) {
    Image image(1, 1, 5);
    image.extra_names = {"depth.Z", "object.id"};
    EXPECT_EQ(decode_png(encode_png(image, {8, false}, "t"), "t", ColorSpace::automatic).channels,
              3);
}

TEST(Png, EveryStepReturnsThroughOurOwnFiles) {
    for (const int bits : {8, 16}) {
        for (const bool linear : {false, true}) {
            for (const int channels : {1, 3, 4}) {
                const int top = bits == 8 ? 255 : 65535;
                Image image(256, bits == 8 ? 1 : 256, channels);
                for (std::size_t i = 0; i < image.data.size(); ++i) {
                    const double v =
                        static_cast<double>(i * 7 % (static_cast<std::size_t>(top) + 1)) / top;
                    const bool alpha = channels == 4 && i % 4 == 3;
                    image.data[i] = linear || alpha ? v : srgb_decode(v);
                }
                const std::string bytes = encode_png(image, {bits, linear}, "t");
                EXPECT_EQ(bytes, encode_png(image, {bits, linear}, "t"));
                const Image back = decode_png(bytes, "t", ColorSpace::automatic);
                EXPECT_EQ(back.channels, channels);
                EXPECT_EQ(back.data, image.data) << bits << linear << channels;
            }
        }
    }
}

TEST(PngReader, ReadsGreyPaletteAlphaAndInterlace) {
    const unsigned char gray_alpha[] = {255, 128, 0, 0};
    Image image =
        decode_png(foreign_png(PNG_FORMAT_GA, 2, 1, gray_alpha), "t", ColorSpace::automatic);
    EXPECT_THAT(image.data, testing::ElementsAre(1, 1, 1, 128 / 255.0, 0, 0, 0, 0));

    const unsigned char indices[] = {1, 0};
    const unsigned char palette[] = {0, 0, 255, 255, 0, 0};
    image = decode_png(foreign_png(PNG_FORMAT_RGB_COLORMAP, 2, 1, indices, palette, 2), "t",
                       ColorSpace::automatic);
    EXPECT_THAT(image.data, testing::ElementsAre(1, 0, 0, 0, 0, 1));

    const unsigned char with_alpha[] = {0, 0, 255, 51, 255, 0, 0, 255};
    image = decode_png(foreign_png(PNG_FORMAT_RGBA_COLORMAP, 2, 1, indices, with_alpha, 2), "t",
                       ColorSpace::automatic);
    EXPECT_THAT(image.data, testing::ElementsAre(1, 0, 0, 1, 0, 0, 1, 0.2));

    // 1 bit grey, 8 x 8 zero pixels, interlaced: passes 1, 2, 4, 6 end up as rows of their own.
    std::string header = big_endian(8) + big_endian(1) + std::string("\1\0\0\0\1", 5);
    // Adam7 on 8 x 1: pass 1 has pixel 0, pass 2 pixel 4, pass 4 pixels 2 6, pass 6 pixels 1 3 5 7;
    // a stored (uncompressed) deflate block of 4 rows: filter 0 and one byte each.
    const std::string rows("\0\x80\0\0\0\x80\0\x50", 8);
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const char c : rows) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const std::string stored =
        std::string("\x78\x01\x01\x08\x00\xF7\xFF", 7) + rows + big_endian(b << 16 | a);
    image = decode_png(
        "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", stored) + chunk("IEND", ""),
        "t", ColorSpace::automatic);
    EXPECT_THAT(image.data, testing::ElementsAre(1, 0, 1, 1, 0, 0, 0, 1));
}

TEST(PngReader, FollowsPovRaysRulesForGamma) {
    const double v = 30000 / 65535.0;
    const std::string linear = gray16(30000);
    EXPECT_EQ(only_value(linear), v);
    const std::string plain = with_chunks(linear, "gAMA", "");
    EXPECT_EQ(only_value(plain), srgb_decode(v));
    EXPECT_EQ(only_value(plain, ColorSpace::linear), v);
    const std::string srgb = chunk("sRGB", std::string(1, 0));
    EXPECT_EQ(only_value(with_chunks(linear, "gAMA", srgb)), srgb_decode(v));
    EXPECT_EQ(only_value(with_chunks(linear, "gAMA", srgb + gamma_chunk(45455))), srgb_decode(v));
    EXPECT_NEAR(only_value(with_chunks(linear, "gAMA", gamma_chunk(45455))),
                std::pow(v, 1 / 0.45455), 1e-15);
    EXPECT_NEAR(only_value(with_chunks(linear, "gAMA", gamma_chunk(50000))), v * v, 1e-15);
    EXPECT_EQ(only_value(with_chunks(linear, "gAMA", gamma_chunk(50000)), ColorSpace::linear), v);
}

TEST(PngReader, RefusesEveryTruncation) {
    Image image(9, 7, 3);
    for (std::size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = std::fmod(0.37 * static_cast<double>(i), 1.0);
    const std::string bytes = encode_png(image, {16, false}, "t");
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        EXPECT_THROW(decode_png(bytes.substr(0, size), "t", ColorSpace::automatic), FileError)
            << size;
    }
}

TEST(PngReader, NeverCrashesOnDamage) {
    Image image(16, 16, 3);
    const std::string bytes = encode_png(image, {8, false}, "t");
    std::mt19937 random(1);
    int refused = 0;
    for (int i = 0; i < 2000; ++i) {
        std::string damaged = bytes;
        for (int k = 0; k < 3; ++k)
            damaged[random() % damaged.size()] = static_cast<char>(random());
        try {
            decode_png(damaged, "t", ColorSpace::automatic);
        } catch (const FileError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 1000);
}

TEST(PngReader, TakesNoMemoryForAHugeClaim) {
    const auto claim = [](std::uint32_t width, std::uint32_t height) {
        return "\x89PNG\r\n\x1a\n" +
               chunk("IHDR",
                     big_endian(width) + big_endian(height) + std::string("\x08\x02\0\0\0", 5)) +
               chunk("IDAT", std::string("\x78\x9c\x03\0\0\0\0\1", 8)) + chunk("IEND", "");
    };
    EXPECT_THAT(file_error([&] { decode_png(claim(60000, 60000), "t", ColorSpace::automatic); }),
                HasSubstr("more than the"));
    EXPECT_THAT(file_error([&] { decode_png(claim(10000, 10000), "t", ColorSpace::automatic); }),
                HasSubstr("truncated"));
    EXPECT_THROW(decode_png(claim(0, 5), "t", ColorSpace::automatic), FileError);
    EXPECT_THROW(decode_png(claim(0x7FFFFFFF, 0x7FFFFFFF), "t", ColorSpace::automatic), FileError);
}

TEST(ImageFile, WritesAndReadsPngFiles) {
    const ScratchFolder folder;
    Image image(3, 2, 3);
    image.pixel(2, 1)[0] = 1;
    write_image(folder / "a.PNG", image, {});
    EXPECT_EQ(read_image(folder / "a.PNG").data, image.data);
    EXPECT_EQ(contents(folder / "a.PNG"), encode_png(image, {}, ""));
    EXPECT_THROW(write_image(folder / "b.png", Image(0, 5), {}), FileError);
    EXPECT_THROW(write_image(folder / "b.xyz", image, {}), FileError);
    put(folder / "text.png", "hello");
    EXPECT_THAT(file_error([&] { read_image(folder / "text.png"); }), HasSubstr("text.png"));
    EXPECT_EQ(folder.entries(), 2u);
}

}  // namespace
}  // namespace lancer::io
