// Pictures that arrive in tiles, and the rounding of light to the integers of a file.
#include "model/io/tiled_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "model/diagnostic.h"
#include "model/io/quantize.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

Image random_picture(int width, int height, int channels) {
    Image image(width, height, channels);
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> value(-0.1, 1.1);
    for (double& v : image.data) v = value(random);
    image.data[0] = std::numeric_limits<double>::quiet_NaN();
    image.data[1] = 1e300;
    return image;
}

Image form_of(const Image& image) {
    Image form = image;
    form.data.clear();
    return form;
}

/// The part of an image that begins at column x, row y, of at most 16 x 16 pixels.
Image tile_of(const Image& image, int x, int y) {
    Image tile(std::min(16, image.width - x), std::min(16, image.height - y), image.channels);
    for (int row = 0; row < tile.height; ++row)
        std::copy_n(image.pixel(x, y + row), tile.width * tile.channels, tile.pixel(0, row));
    return tile;
}

void put_tiles(const Image& image, TiledPicture& picture) {
    for (int y = 0; y < image.height; y += 16)
        for (int x = 0; x < image.width; x += 16) picture.put(x, y, tile_of(image, x, y));
}

TEST(TiledPicture, HasTheBytesOfTheWholePicture) {
    const ScratchFolder folder;
    for (const std::string ending : {".png", ".ppm", ".exr", ".hdr", ".tif", ".jpg"}) {
        for (const int channels : {3, 4, 9}) {
            for (const int bits : {8, 16}) {
                Image image = random_picture(53, 35, channels);
                if (channels == 9) image.extra_names = {"a.X", "a.Y", "a.Z", "b.X", "b.Y", "b.Z"};
                const ImageWriteOptions options{bits, bits == 16};
                write_image(folder / ("whole" + ending), image, options);
                TiledPicture picture(folder / ("tiles" + ending), form_of(image), options, {});
                put_tiles(image, picture);
                picture.write();
                EXPECT_TRUE(contents(folder / ("whole" + ending)) ==
                            contents(folder / ("tiles" + ending)))
                    << ending << " " << channels << " " << bits;
            }
        }
    }
}

TEST(TiledPicture, HasItsOrigin) {
    const ScratchFolder folder;
    const Origin origin{"a scene", "a build", "size 53x35"};
    for (const std::string ending : {".png", ".exr"}) {
        const Image image = random_picture(53, 35, 3);
        write_image(folder / ("whole" + ending), image, {}, origin);
        TiledPicture picture(folder / ("tiles" + ending), form_of(image), {}, origin);
        put_tiles(image, picture);
        picture.write();
        EXPECT_EQ(origin_of_picture(contents(folder / ("tiles" + ending))), origin) << ending;
        EXPECT_TRUE(contents(folder / ("whole" + ending)) == contents(folder / ("tiles" + ending)))
            << ending;
    }
}

TEST(TiledPicture, LeavesNoFileWhereItCannotBeWritten) {
    const ScratchFolder folder;
    const Image image = random_picture(3, 2, 3);
    TiledPicture picture(folder / "missing/a.png", form_of(image), {}, {});
    picture.put(0, 0, image);
    EXPECT_THROW(picture.write(), FileError);
    EXPECT_EQ(folder.entries(), 0u);
}

/// The number of steps at or below the light, counted one by one.
int step_by_counting(double light) {
    int step = 0;
    while (step < 255 && light >= srgb_decode((step + 0.5) / 255)) ++step;
    return step;
}

TEST(Quantizer, RoundsToTheNearestStepOnBothSidesOfEachThreshold) {
    const Quantizer quantizer(8, false);
    for (int step = 1; step <= 255; ++step) {
        const double at = srgb_decode((step - 0.5) / 255);
        EXPECT_EQ(quantizer.encoded(at), step);
        EXPECT_EQ(quantizer.encoded(std::nextafter(at, 1)), step);
        EXPECT_EQ(quantizer.encoded(std::nextafter(at, 0)), step - 1);
    }
    for (int bin = 0; bin <= 4096; ++bin) {
        const double at = bin / 4096.0;
        for (const double light : {std::nextafter(at, 0), at, std::nextafter(at, 1)})
            EXPECT_EQ(quantizer.encoded(light), step_by_counting(light)) << light;
    }
}

TEST(Quantizer, KeepsToItsRange) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const bool linear : {false, true}) {
        for (const auto& [bits, top] : {std::pair{8, 255}, {16, 65535}}) {
            const Quantizer quantizer(bits, linear);
            for (const double light : {-infinity, -1.0, -0.0, 0.0, 1e-300, std::nan("")})
                EXPECT_EQ(quantizer.encoded(light), 0) << light;
            for (const double light : {1 - 1e-16, 1.0, 1.5, 1e300, infinity})
                EXPECT_EQ(quantizer.encoded(light), top) << light;
            EXPECT_EQ(quantizer.raw(0.5), (top + 1) / 2);
            EXPECT_EQ(quantizer.raw(0.499999 / top), 0);
            EXPECT_EQ(quantizer.raw(1.5 / top), 2);
        }
    }
}

}  // namespace
}  // namespace lancer::io
