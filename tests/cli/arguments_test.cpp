#include "cli/arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "cli/session.h"

namespace lancer::cli {
namespace {

TEST(Arguments, SizesAreTwoWholeNumbersAboveZero) {
    const PictureSize size = parse_size("640x480");
    EXPECT_EQ(size.width, 640);
    EXPECT_EQ(size.height, 480);
    for (const char* wrong : {"", "640", "640x", "x480", "640x480x3", "0x480", "640x-1", "6.5x4",
                              "640 x 480", "640x480 ", "99999999999x1", "65536x1", "640X480"})
        EXPECT_THROW(parse_size(wrong), UsageError) << wrong;
}

TEST(Arguments, CropsAreFourWholeNumbers) {
    const Crop crop = parse_crop("1,2,30,40");
    EXPECT_EQ(crop.x, 1);
    EXPECT_EQ(crop.y, 2);
    EXPECT_EQ(crop.width, 30);
    EXPECT_EQ(crop.height, 40);
    for (const char* wrong :
         {"", "1,2,3", "1,2,3,4,5", "-1,2,3,4", "1,2,0,4", "1,2,3,0", "1,2,3,4,"})
        EXPECT_THROW(parse_crop(wrong), UsageError) << wrong;
}

TEST(Arguments, BothEndsOfARangeOfFramesBelongToIt) {
    const FrameRange frames = parse_frames("-2..8");
    EXPECT_EQ(frames.first, -2);
    EXPECT_EQ(frames.last, 8);
    EXPECT_EQ(frames.count(), 11u);
    EXPECT_EQ(frames.time(-2), 0);
    EXPECT_EQ(frames.time(3), 0.5);
    EXPECT_EQ(frames.time(8), 1);
    EXPECT_EQ(parse_frames("1..4").time(4, true), 0.75);
    EXPECT_EQ(parse_frames("1..4").time(1, true), 0);
    EXPECT_EQ(parse_frames("7..7").time(7), 0) << "one frame alone begins the animation";
    for (const char* wrong :
         {"", "1", "1..", "..2", "1...2", "2..1", "1..2.5", "a..b", "0..9999999999999999999"})
        EXPECT_THROW(parse_frames(wrong), UsageError) << wrong;
}

TEST(Arguments, NumbersAreReadWholeAndFinite) {
    EXPECT_EQ(parse_number("1e-3"), 1e-3);
    EXPECT_EQ(parse_whole_number("-12"), -12);
    for (const char* wrong : {"", "1e999", "nan", "inf", "1,5", "1.5x", " 1"})
        EXPECT_THROW(parse_number(wrong), UsageError) << wrong;
    for (const char* wrong : {"", "1.5", "1e3", "0x10", "9999999999999999999999"})
        EXPECT_THROW(parse_whole_number(wrong), UsageError) << wrong;
}

TEST(Arguments, ABoundedOptionRefusesWhatLiesOutside) {
    const auto parse = [](const std::string& text) {
        CLI::App app;
        std::optional<std::int64_t> value;
        add_whole_number(app, "--samples", value, 1, 10, "");
        app.parse("--samples " + text);
        return value;
    };
    EXPECT_EQ(parse("10"), 10);
    EXPECT_THROW(parse("11"), UsageError);
    EXPECT_THROW(parse("0"), UsageError);
}

}  // namespace
}  // namespace lancer::cli
