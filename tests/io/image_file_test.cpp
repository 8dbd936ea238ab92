// Formats other than PNG: PPM, our own, and those of the module.
#include "model/io/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "model/io/file.h"
#include "model/io/pfm_file.h"
#include "model/io/picture_input.h"
#include "model/io/picture_process.h"
#include "model/io/ppm_file.h"
#include "model/io/stored_image.h"
#include "model/srgb.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

/// Values from 0 to 1.2 in every channel, alpha up to 1.
Image gradient(int width, int height, int channels) {
    Image image(width, height, channels);
    for (std::size_t i = 0; i < image.data.size(); ++i) {
        image.data[i] = static_cast<double>(i * 37 % 101) / 100 * (i % 4 == 3 ? 1 : 1.2);
    }
    return image;
}

double worst_difference(const Image& a, const Image& b) {
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.channels, b.channels);
    if (a.data.size() != b.data.size()) return HUGE_VAL;
    double worst = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i) {
        worst = std::max(worst, std::abs(std::min(a.data[i], 1.0) - std::min(b.data[i], 1.0)));
    }
    return worst;
}

TEST(ImageFile, KnowsWhatItCanWrite) {
    for (const char* name :
         {"a.png", "a.EXR", "b/a.hdr", "a.tif", "a.tiff", "a.Jpg", "a.jpeg", "x.y.ppm"}) {
        EXPECT_TRUE(is_writable_image_name(name)) << name;
    }
    for (const char* name : {"png", "a", "a.gif", "a.png.txt", ""}) {
        EXPECT_FALSE(is_writable_image_name(name)) << name;
    }
}

TEST(Exr, KeepsFloatsAndNamedChannels) {
    const ScratchFolder folder;
    Image image = gradient(7, 5, 6);
    image.extra_names = {"depth.Z", "normal.X", "object.id"};
    const double inf = std::numeric_limits<double>::infinity();
    image.data[0] = 1e30;
    image.data[1] = -2.5;
    image.data[3] = inf;
    image.data[5] = 16777216;
    image.data[6] = std::numeric_limits<double>::quiet_NaN();
    write_image(folder / "a.exr", image, {});
    const Image back = read_image(folder / "a.exr");
    EXPECT_EQ(back.extra_names, image.extra_names);
    ASSERT_EQ(back.data.size(), image.data.size());
    for (std::size_t i = 0; i < image.data.size(); ++i) {
        if (i == 6) {
            EXPECT_TRUE(std::isnan(back.data[i]));
        } else {
            EXPECT_EQ(back.data[i], static_cast<double>(static_cast<float>(image.data[i]))) << i;
        }
    }
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Exr, HoldsColoursMultipliedByAlpha) {
    const ScratchFolder folder;
    Image image(1, 1, 4);
    image.data = {1, 0.5, 0.25, 0.5};
    write_image(folder / "a.exr", image, {});
    EXPECT_EQ(read_image(folder / "a.exr").data, image.data);
    PictureInput file(folder / "a.exr");
    const SharedMemory memory;
    ASSERT_EQ(work_on_picture(PictureTask::read, "openexr", file.descriptor(), memory.descriptor()),
              "");
    const SharedResult result = read_shared(memory.descriptor());
    EXPECT_TRUE(result.shape.premultiplied);
    const std::string bytes = shared_bytes(memory.descriptor(), result);
    std::array<float, 4> stored{};
    ASSERT_EQ(bytes.size(), sizeof stored);
    std::memcpy(stored.data(), bytes.data(), sizeof stored);
    EXPECT_THAT(stored, ElementsAre(0.5F, 0.25F, 0.125F, 0.5F));
}

TEST(Tiff, ReturnsEveryStep) {
    const ScratchFolder folder;
    for (const int bits : {8, 16}) {
        for (const int channels : {1, 3, 4}) {
            for (const bool linear : {false, true}) {
                const Image image = gradient(31, 33, channels);
                write_image(folder / "a.tif", image, {bits, linear});
                write_image(folder / "a.png", image, {bits, linear});
                const ColorSpace space = linear ? ColorSpace::linear : ColorSpace::automatic;
                EXPECT_EQ(worst_difference(read_image(folder / "a.tif", space),
                                           read_image(folder / "a.png", space)),
                          0);
            }
        }
    }
}

TEST(Ppm, ReturnsEveryStep) {
    const ScratchFolder folder;
    for (const int bits : {8, 16}) {
        for (const bool linear : {false, true}) {
            const Image image = gradient(31, 33, 3);
            write_image(folder / "a.ppm", image, {bits, linear});
            write_image(folder / "a.png", image, {bits, linear});
            const ColorSpace space = linear ? ColorSpace::linear : ColorSpace::automatic;
            EXPECT_EQ(worst_difference(read_image(folder / "a.ppm", space),
                                       read_image(folder / "a.png", space)),
                      0);
        }
    }
}

TEST(Ppm, ReadsWhatOthersWrite) {
    const auto values = [](std::string_view bytes) {
        return decode_ppm(bytes, "t", ColorSpace::linear).data;
    };
    EXPECT_THAT(values("P3\n# made by hand\n2 1 # two pixels\n 100\n100 0 50  0 25\n75"),
                ElementsAre(1, 0, 0.5, 0, 0.25, 0.75));
    EXPECT_THAT(values("P2 1 2 1 0 1"), ElementsAre(0, 1));
    EXPECT_THAT(values(std::string("P5 2 1 255\n\0\xFF", 13)), ElementsAre(0, 1));
    EXPECT_THAT(values(std::string("P5 1 1 1000\n\x01\xF4", 14)), ElementsAre(0.5));
    EXPECT_THAT(values("P6 1 1 51\n\x33 \x33"), ElementsAre(1, 32 / 51.0, 1));
    const Image decoded = decode_ppm("P2 1 1 2 1", "t", ColorSpace::automatic);
    EXPECT_THAT(decoded.data, ElementsAre(srgb_decode(0.5)));
}

TEST(Ppm, RefusesWhatIsWrong) {
    for (const char* text :
         {"P6 ", "P6 1", "P6 1 1", "P6 1 1 255", "P6 1 1 255\nab", "P6 0 1 255\n", "P6 1 1 0\nabc",
          "P6 1 1 70000\nabcdef", "P6 60000 60000 255\nabc", "P3 1 1 255 1 2", "P3 1 1 9 1 2 10",
          "P3 1 1 9 1 x 2", "P5 -1 1 255\na", "P5 1 1 100\n\xFF", "P5 99999999999999999999 1 9"}) {
        EXPECT_THROW(decode_ppm(text, "t", ColorSpace::automatic), FileError) << text;
    }
}

TEST(Pfm, ReadsWhatOthersWrite) {
    const auto values = [](std::string_view bytes) { return decode_pfm(bytes, "t").data; };
    // The bottom row first; 1.0f is 3F 80 00 00.
    EXPECT_THAT(values(std::string("Pf\n1 2\n1.0\n\x3F\x80\0\0\x40\0\0\0", 19)), ElementsAre(2, 1));
    EXPECT_THAT(values(std::string("Pf 1 1 -1\n\0\0\x80\x3F", 14)), ElementsAre(1));
    EXPECT_THAT(values(std::string("Pf\r\n1 1\r\n-1.000\r\n\0\0\x80\x3F", 21)), ElementsAre(1));
}

TEST(Pfm, ReadsWhatItWrites) {
    Image image(2, 3, 4);
    for (std::size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = 0.25 * static_cast<double>(i) - 3;
    const ScratchFolder folder;
    write_file(folder / "a.pfm", encode_pfm(image, 1, 3));
    const Image read = read_image(folder / "a.pfm");
    ASSERT_EQ(read.channels, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 2; ++x)
            for (int c = 0; c < 3; ++c) EXPECT_EQ(read.pixel(x, y)[c], image.pixel(x, y)[c + 1]);
}

TEST(Pfm, RefusesWhatIsWrong) {
    for (const char* text :
         {"PF ", "PF 1", "PF 1 1", "PF 1 1 -1", "PF 1 1 -1\nabcdefghijk", "PF 0 1 -1\nabcdefghijkl",
          "PF 1 -1 -1\nabcdefghijkl", "PF 1 1 0\nabcdefghijkl", "PF 1 1 2.5\nabcdefghijkl",
          "PF 1 1 nan\nabcdefghijkl", "PF 1 1 -1\r\nabcdefghijk", "PF 1 1 -1\nabcdefghijklm",
          "PF 60000 60000 -1\nabc", "Pf 99999999999999999999 1 -1\nabcd"}) {
        EXPECT_THROW(decode_pfm(text, "t"), FileError) << text;
    }
}

TEST(Hdr, KeepsLightWithinAStepOfItsExponent) {
    const ScratchFolder folder;
    Image image(16, 1, 3);
    for (std::size_t i = 0; i < image.data.size(); ++i) {
        image.data[i] = std::ldexp(1.7, static_cast<int>(i / 3));
    }
    image.data[0] = -1;
    image.data[1] = std::numeric_limits<double>::quiet_NaN();
    image.data[2] = std::numeric_limits<double>::infinity();
    write_image(folder / "a.hdr", image, {});
    const Image back = read_image(folder / "a.hdr");
    EXPECT_EQ(back.data[0], 0);
    EXPECT_EQ(back.data[1], 0);
    EXPECT_GT(back.data[2], 1e37);
    for (std::size_t i = 3; i < image.data.size(); ++i) {
        EXPECT_NEAR(back.data[i], image.data[i], image.data[i] / 128) << i;
    }
}

TEST(Jpeg, KeepsSmoothPictures) {
    const ScratchFolder folder;
    for (const int channels : {1, 3, 4}) {
        Image image(32, 32, channels);
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 32; ++x) {
                for (int c = 0; c < channels; ++c) image.pixel(x, y)[c] = (x + y) / 62.0;
            }
        }
        write_image(folder / "a.jpg", image, {});
        const Image back = read_image(folder / "a.jpg");
        EXPECT_EQ(back.channels, std::min(channels, 3));
        EXPECT_NEAR(back.pixel(20, 11)[0], 0.5, 0.02);
        EXPECT_NEAR(back.pixel(0, 0)[0], 0, 0.02);
    }
}

TEST(ImageFile, ThePictureDecidesTheBytes) {
    const ScratchFolder folder;
    for (const char* ending : {".png", ".exr", ".hdr", ".tif", ".jpg", ".ppm"}) {
        write_image(folder / ("a" + std::string(ending)), gradient(20, 20, 3), {16, false});
        write_image(folder / ("b" + std::string(ending)), gradient(20, 20, 3), {16, false});
        const std::string bytes = contents(folder / ("a" + std::string(ending)));
        EXPECT_EQ(bytes, contents(folder / ("b" + std::string(ending)))) << ending;
        for (const char* stamp : {"OpenImageIO", "Software", "/tmp"}) {
            EXPECT_THAT(bytes, testing::Not(HasSubstr(stamp))) << ending;
        }
    }
    EXPECT_THAT(contents(folder / "a.exr"), HasSubstr("1970:01:01"));  // not the time of writing
}

TEST(ImageFile, AFailedWriteLeavesTheOldFile) {
    const ScratchFolder folder;
    put(folder / "a.exr", "old");
    Image image(1, 1, 5);
    image.extra_names = {"same", "same"};
    try {
        write_image(folder / "a.exr", image, {});
    } catch (const FileError&) {
        EXPECT_EQ(contents(folder / "a.exr"), "old");
    }
    EXPECT_THROW(write_image(folder / "no/a.exr", image, {}), FileError);
    EXPECT_EQ(folder.entries(), 1u);
}

/// Every picture of every format, cut short or damaged: an error or a picture, never a crash.
class Damage : public testing::TestWithParam<const char*> {};

TEST_P(Damage, IsAnErrorOrAPicture) {
    const ScratchFolder folder;
    const std::string name = std::string("a") + GetParam();
    write_image(folder / name, gradient(9, 5, 3), {8, false});
    const std::string bytes = contents(folder / name);
    const auto refused = [&](const std::string& damaged) {
        put(folder / name, damaged);
        try {
            const Image image = read_image(folder / name);
            EXPECT_GT(image.width, 0);
            const bool floats = name == "a.exr" || name == "a.hdr";
            for (const double value : image.data)
                if (!floats && !(value >= 0 && value <= 1)) ADD_FAILURE() << value;
            return false;
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(), HasSubstr(folder / name));
            return true;
        }
    };
    EXPECT_FALSE(refused(bytes));
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_TRUE(refused(bytes.substr(0, size))) << size << " of " << bytes.size();
    std::mt19937 random(5);
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 1 << random() % 8);
        refused(damaged);
    }
    for (int i = 0; i < 100; ++i) {
        std::string damaged = bytes;
        // In the header, where numbers lead further.
        const std::size_t range = std::min<std::size_t>(bytes.size(), 400);
        for (int k = 0; k < 2; ++k) damaged[random() % range] = static_cast<char>(random());
        refused(damaged);
    }
}

TEST(Exr, TakesNoMemoryForAHugeClaim) {
    const ScratchFolder folder;
    write_image(folder / "a.exr", gradient(4, 4, 3), {});
    const std::string bytes = contents(folder / "a.exr");
    const auto error_with = [&](std::size_t at, const std::string& number) {
        std::string damaged = bytes;
        damaged.replace(at, 4, number);
        put(folder / "a.exr", damaged);
        return file_error([&] { read_image(folder / "a.exr"); });
    };
    const std::string huge("\xFF\xFF\xFF\x7F", 4);
    const std::size_t window = bytes.find("dataWindow") + 11 + 6;
    EXPECT_THAT(error_with(window, huge), HasSubstr("truncated"));  // its length
    EXPECT_THAT(error_with(window + 4 + 8, huge), HasSubstr("a side is longer"));
    EXPECT_THAT(error_with(window + 4 + 8, std::string(4, '\xFF')), HasSubstr("no pixels"));
}

TEST(Jpeg, TakesNoMemoryForAHugeClaim) {
    const ScratchFolder folder;
    write_image(folder / "a.jpg", gradient(8, 8, 3), {});
    std::string bytes = contents(folder / "a.jpg");
    const std::size_t frame = bytes.find("\xFF\xC0");
    ASSERT_NE(frame, std::string::npos);
    bytes.replace(frame + 5, 4, "\x27\x10\x27\x10");  // 10000 x 10000
    put(folder / "a.jpg", bytes);
    EXPECT_THAT(file_error([&] { read_image(folder / "a.jpg"); }), HasSubstr("cannot hold"));
}

INSTANTIATE_TEST_SUITE_P(Formats, Damage,
                         testing::Values(".png", ".ppm", ".exr", ".tif", ".hdr", ".jpg"),
                         [](const auto& name) { return std::string(name.param).substr(1); });

}  // namespace
}  // namespace lancer::io
