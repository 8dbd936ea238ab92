// Parts of pictures as files, pictures that are written row by row, and the origin that a picture's
// file records.
#include "model/io/part_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "model/io/image_file.h"
#include "model/io/row_file.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

using testing::HasSubstr;

/// Values with all their digits, some beyond what a float holds.
Image noise(int width, int height, int channels) {
    Image image(width, height, channels);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> value(-0.1, 1.1);
    for (double& v : image.data) v = value(random);
    const double odd[] = {0.0,   -0.0,     1e-300, -1e-42, 1e300,    -1e39, 3.4028235677973366e38,
                          1e-38, HUGE_VAL, 0.5,    1.0,    1 + 1e-16};
    std::copy(std::begin(odd), std::end(odd), image.data.begin());
    return image;
}

void write_by_rows(const std::string& path, const Image& image, const ImageWriteOptions& options) {
    int y = 0;
    write_rows(path, image, options, [&](double* pixels) {
        std::copy_n(image.pixel(0, y++), image.width * image.channels, pixels);
    });
}

TEST(RowFile, HasTheBytesOfThePictureThatIsWrittenAsAWhole) {
    const ScratchFolder folder;
    for (const char* ending : {".png", ".ppm", ".exr", ".hdr", ".tif", ".jpg"}) {
        for (const int channels : {3, 4}) {
            for (const int bits : {8, 16}) {
                const Image image = noise(37, 150, channels);
                const ImageWriteOptions options{bits, bits == 16};
                write_image(folder / ("whole" + std::string(ending)), image, options);
                write_by_rows(folder / ("rows" + std::string(ending)), image, options);
                EXPECT_TRUE(contents(folder / ("whole" + std::string(ending))) ==
                            contents(folder / ("rows" + std::string(ending))))
                    << ending << " " << channels << " " << bits;
            }
        }
    }
}

TEST(RowFile, IsNotThereWhenItsRowsEnd) {
    const ScratchFolder folder;
    for (const char* name : {"a.png", "a.ppm", "a.exr"}) {
        int rows = 0;
        EXPECT_THAT(file_error([&] {
                        write_rows(folder / name, Image(4, 200), {}, [&](double*) {
                            if (++rows == 150) throw FileError("no more");
                        });
                    }),
                    HasSubstr("no more"));
    }
    EXPECT_EQ(folder.entries(), 0u);
}

PartHead head_of(int number, int count, const Image& image) {
    PartHead head{number, count, image.width, image.height, image.extra_names, {}};
    head.origin = {"s", "b", "size 1x1"};
    return head;
}

void write_part_of(const std::string& path, const Image& image, const PartHead& head) {
    write_part(path, head, [&](const Strip& strip) {
        Image rows(image.width, strip.rows, image.channels);
        std::copy_n(image.pixel(0, strip.first), rows.data.size(), rows.data.begin());
        return rows;
    });
}

TEST(PartFile, StripsAreDealtInTurnAndCoverThePicture) {
    for (const int height : {1, 2, 47, 48, 480, 5000}) {
        for (const int count : {1, 2, 3, 12, 48}) {
            if (count > height) continue;
            std::vector<int> owners(static_cast<std::size_t>(height), 0);
            for (int number = 1; number <= count; ++number) {
                const std::vector<Strip> strips = strips_of({number, count, 4, height, {}, {}});
                EXPECT_FALSE(strips.empty());
                if (height >= 4 * count) {
                    EXPECT_GE(strips.size(), 4u) << height << " " << count;
                }
                for (const Strip& strip : strips)
                    for (int y = strip.first; y < strip.first + strip.rows; ++y)
                        ++owners[static_cast<std::size_t>(y)];
            }
            EXPECT_THAT(owners, testing::Each(1)) << height << " in " << count;
        }
    }
}

TEST(PartFile, KeepsWhatAFileOfTheWholeNeeds) {
    const ScratchFolder folder;
    Image image = noise(9, 70, 5);
    image.extra_names = {"depth.Z", "object.id"};
    const PartHead head = head_of(2, 3, image);
    write_part_of(folder / "a.exr", image, head);
    PartReader reader(folder / "a.exr");
    EXPECT_EQ(reader.head().origin, head.origin);
    EXPECT_EQ(reader.head().extra_names, head.extra_names);
    std::vector<double> row(9 * 5);
    for (const Strip& strip : strips_of(head)) {
        for (int y = strip.first; y < strip.first + strip.rows; ++y) {
            reader.read_row(row.data());
            for (int x = 0; x < 9; ++x) {
                for (int c = 0; c < 5; ++c) {
                    const double is = row[static_cast<std::size_t>(x * 5 + c)];
                    const double was = image.pixel(x, y)[c];
                    const bool in_range = std::abs(was) > 1e-37 && std::abs(was) < 1e38;
                    if (c < 3 && in_range) {
                        EXPECT_EQ(is, was);
                    }
                    EXPECT_EQ(static_cast<float>(is), static_cast<float>(was));
                }
            }
        }
    }
    reader.finish();
}

TEST(PartFile, IsAnExrWhoseFirstStripAnyProgramShows) {
    const ScratchFolder folder;
    const Image image = noise(20, 64, 3);
    const PartHead head = head_of(1, 2, image);
    write_part_of(folder / "a.exr", image, head);
    const Image seen = read_image(folder / "a.exr");
    EXPECT_EQ(seen.width, 20);
    EXPECT_EQ(seen.height, strips_of(head).front().rows);
    EXPECT_EQ(seen.pixel(5, 3)[1], static_cast<double>(static_cast<float>(image.pixel(5, 3)[1])));
}

TEST(PartFile, OneWrongBitAnywhereIsDamage) {
    const ScratchFolder folder;
    const Image image = noise(5, 16, 3);
    write_part_of(folder / "a.exr", image, head_of(1, 2, image));
    const std::string whole = contents(folder / "a.exr");
    EXPECT_EQ(checked_part(folder / "a.exr").number, 1);
    for (std::size_t at = 0; at < whole.size(); at += 5) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
        put(folder / "b.exr", damaged);
        EXPECT_THAT(file_error([&] { checked_part(folder / "b.exr"); }), HasSubstr("b.exr")) << at;
    }
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{7}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
        put(folder / "b.exr", whole.substr(0, size));
        EXPECT_THAT(file_error([&] { checked_part(folder / "b.exr"); }), HasSubstr("damaged"));
    }
    put(folder / "b.exr", whole + "x");
    EXPECT_THAT(file_error([&] { checked_part(folder / "b.exr"); }), HasSubstr("damaged"));
}

TEST(PartFile, IsNotLeftWhenDrawingFails) {
    const ScratchFolder folder;
    const Image image = noise(5, 64, 3);
    EXPECT_THAT(file_error([&] {
                    write_part(folder / "a.exr", head_of(1, 2, image), [](const Strip& strip) {
                        if (strip.first > 0) throw FileError("stopped");
                        return Image(5, strip.rows, 3);
                    });
                }),
                HasSubstr("stopped"));
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(Origin, StandsInThePictureUntilABitOfItChanges) {
    const ScratchFolder folder;
    const Origin origin{"1234", "5678", "size 8x8, samples 2"};
    const Image image = noise(6, 5, 3);
    for (const char* name : {"a.png", "a.exr"}) {
        write_image(folder / name, image, {}, origin);
        const std::string whole = contents(folder / name);
        EXPECT_EQ(origin_of_picture(whole), origin) << name;
        EXPECT_EQ(read_image(folder / name).width, 6);
        for (std::size_t at = 0; at < whole.size(); ++at) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
            EXPECT_EQ(origin_of_picture(damaged), std::nullopt) << name << " " << at;
            EXPECT_EQ(origin_of_picture(whole.substr(0, at)), std::nullopt) << name << " " << at;
        }
        write_image(folder / name, image, {});
        EXPECT_EQ(origin_of_picture(contents(folder / name)), std::nullopt);
    }
}

TEST(Origin, TheDifferenceIsTold) {
    const Origin origin{"s", "b", "samples 2"};
    EXPECT_EQ(difference(origin, origin), "");
    EXPECT_EQ(difference({"t", "b", "samples 2"}, origin), "another scene");
    EXPECT_EQ(difference({"s", "c", "samples 2"}, origin), "another build of lancer");
    EXPECT_THAT(difference({"s", "b", "samples 3"}, origin), HasSubstr("samples 3"));
}

}  // namespace
}  // namespace lancer::io
