// Masks, the densest window and edges that are told from the pictures alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reference/compare/comparison_text.h"
#include "reference/compare/picture_edges.h"

namespace lancer::reference {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int width = 40;
constexpr int height = 30;

/// A disc, shaded from left to right, on a darker background: `smooth` pixels wide is its edge.
Image disc(double middle_x, double gain = 1, double smooth = 0) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double beyond = std::hypot(x + 0.5 - middle_x, y + 0.5 - 15.2) - 9.1;
            const double inside = smooth > 0 ? std::clamp(0.5 - beyond / smooth, 0.0, 1.0)
                                             : static_cast<double>(beyond < 0);
            const double shaded = gain * (0.4 + 0.01 * x);
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = inside * shaded + (1 - inside) * 0.05;
        }
    }
    return image;
}

CompareOptions options_of(double fail, bool edges) {
    CompareOptions options;
    options.fail = fail;
    options.flip = false;
    options.edges_may_move = edges;
    return options;
}

TEST(MovedEdges, ASilhouetteMayLieAPixelElsewhere) {
    for (const double smooth : {0.0, 1.0}) {
        const Image a = disc(20, 1, smooth);
        const Image b = disc(20.9, 1, smooth);
        const Comparison strict = compare_images(a, b, options_of(0.02, false));
        EXPECT_FALSE(strict.pass);
        EXPECT_GT(strict.pixels_over, 15u);
        EXPECT_EQ(strict.over_at_edges, strict.pixels_over) << smooth;
        EXPECT_TRUE(compare_images(a, b, options_of(0.02, true)).pass) << smooth;
    }
    // Two pixels are too much, and three more so.
    EXPECT_FALSE(compare_images(disc(20), disc(22.5), options_of(0.02, true)).pass);
}

TEST(MovedEdges, ShadingMayNotDiffer) {
    const Image a = disc(20);
    Image b = disc(20.9, 1.05);
    const Comparison brighter = compare_images(a, b, options_of(0.02, true));
    EXPECT_FALSE(brighter.pass);
    EXPECT_THAT(brighter.reason, HasSubstr("away from edges"));
    EXPECT_LT(brighter.over_at_edges, brighter.pixels_over / 3);
    // A slope is no edge, however much it is moved.
    Image slope(width, height);
    Image moved = slope;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) {
                slope.pixel(x, y)[c] = 0.1 + 0.02 * x;
                moved.pixel(x, y)[c] = 0.1 + 0.02 * (x + 0.5);
            }
        }
    }
    EXPECT_EQ(compare_images(slope, moved, options_of(0.005, true)).over_at_edges, 0u);
    // A value that neither side of the edge has is nobody's edge.
    b = a;
    for (int c = 0; c < 3; ++c) b.pixel(11, 15)[c] = 0.9;
    EXPECT_EQ(compare_images(a, b, options_of(0.02, true)).over_at_edges, 0u);
}

TEST(MovedEdges, AreFoundOnBothSidesOfAStep) {
    Image image(8, 1, 1);
    for (int x = 4; x < 8; ++x) image.pixel(x, 0)[0] = 0.5;
    EXPECT_THAT(find_picture_edges(image, 1), testing::ElementsAre(0, 0, 1, 1, 1, 1, 0, 0))
        << "a step of two pixels reaches one further to each side";
    for (int x = 0; x < 8; ++x) image.pixel(x, 0)[0] = 0.1 * x;
    EXPECT_THAT(find_picture_edges(image, 1), testing::Each(0));
}

TEST(DensestWindow, IsWhereMostFlagsAre) {
    std::vector<std::uint8_t> flags(20 * 10, 0);
    const auto set = [&](int x, int y) { flags[static_cast<std::size_t>(y * 20 + x)] = 1; };
    set(0, 0);
    for (const int x : {12, 13, 15}) set(x, 7);
    set(13, 9);
    const Window window = densest_window(flags, 20, 4);
    EXPECT_EQ(window.x, 12);
    EXPECT_EQ(window.y, 6);
    EXPECT_EQ(window.flagged, 4u);
    EXPECT_EQ(window.share(), 0.25);
    const Window whole = densest_window(flags, 20, 100);
    EXPECT_EQ(whole.width, 20);
    EXPECT_EQ(whole.height, 10);
    EXPECT_EQ(whole.flagged, 5u);
    EXPECT_EQ(densest_window(flags, 20, 1).flagged, 1u);
    // By counting each window.
    unsigned state = 1;
    for (std::uint8_t& flag : flags) flag = (state = state * 1664525 + 1013904223) >> 30 == 0;
    const Window found = densest_window(flags, 20, 3);
    std::size_t most = 0;
    for (int y = 0; y + 3 <= 10; ++y) {
        for (int x = 0; x + 3 <= 20; ++x) {
            std::size_t inside = 0;
            for (int i = 0; i < 9; ++i)
                inside += flags[static_cast<std::size_t>((y + i / 3) * 20 + x + i % 3)];
            most = std::max(most, inside);
        }
    }
    EXPECT_EQ(found.flagged, most);
}

TEST(DensestWindow, FailsAPictureWhoseShareIsSmall) {
    const Image a = disc(20);
    Image b = a;
    for (int y = 12; y < 16; ++y)
        for (int x = 18; x < 22; ++x) b.pixel(x, y)[1] += 0.1;
    CompareOptions options = options_of(0.02, false);
    options.fail_percent = 2;
    options.window = 8;
    EXPECT_TRUE(compare_images(a, b, options).pass);
    options.fail_window = 20;
    const Comparison spot = compare_images(a, b, options);
    EXPECT_EQ(spot.reason,
              "16 of the 8 x 8 pixels from (14, 8) on differ by more than 0.02, 20 % allowed");
    EXPECT_THAT(to_text(spot, options), HasSubstr("densest 16 of 8 x 8 pixels"));
    options.fail_window = 25;
    EXPECT_TRUE(compare_images(a, b, options).pass);
    const auto json = nlohmann::json::parse(to_json(spot, options));
    EXPECT_EQ(json.at("densest").at("over"), 16);
    EXPECT_TRUE(nlohmann::json::parse(to_json(compare_images(a, a, options), options))
                    .at("densest")
                    .is_null());
}

TEST(Masks, LeaveOutWhatIsBlackOrTransparent) {
    Image picture(3, 1, 4);
    picture.data = {0, 0, 0, 1, 0, 0.1, 0, 1, 1, 1, 1, 0};
    EXPECT_THAT(mask_from(picture).flags, testing::ElementsAre(0, 1, 0));
    Image grey(2, 1, 1);
    grey.data = {0, 0.5};
    EXPECT_THAT(mask_from(grey).flags, testing::ElementsAre(0, 1));
}

TEST(Masks, MeasureOnlyWhatIsLeft) {
    const Image a = disc(20);
    Image b = a;
    CompareOptions options = options_of(0.02, false);
    Image mask(width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 10; ++x) mask.pixel(x, y)[0] = 1;
    options.counted = mask_from(mask);
    options.flip = true;
    b.pixel(30, 3)[0] = std::numeric_limits<double>::quiet_NaN();
    b.pixel(20, 3)[0] = 1;
    const Comparison left = compare_images(a, b, options);
    EXPECT_TRUE(left.pass) << left.reason;
    EXPECT_EQ(left.pixels, 300u);
    EXPECT_EQ(left.left_out, 900u);
    EXPECT_EQ(left.rmse, 0);
    EXPECT_EQ(left.max, 0);
    EXPECT_EQ(left.flip, 0);
    EXPECT_EQ(counted_differences(a, b, options.counted)[3 * width + 20], 0);
    b.pixel(9, 29)[2] += 0.3;
    const Comparison inside = compare_images(a, b, options);
    EXPECT_EQ(inside.reason, "1 of 300 pixels differ by more than 0.02, 0 allowed");
    EXPECT_NEAR(inside.mean, 0.3 / 900, 1e-15);
    EXPECT_GT(inside.flip, 0);
}

TEST(Masks, ThatFitNothingAreAnError) {
    CompareOptions options = options_of(0, false);
    options.counted = mask_from(Image(30, 40));
    EXPECT_EQ(compare_images(disc(20), disc(20), options).reason,
              "the mask has another size: 30 x 40, and the pictures 40 x 30");
    options.counted = mask_from(Image(width, height));
    EXPECT_EQ(compare_images(disc(20), disc(20), options).reason,
              "the mask is black: no pixel is left to compare");
}

}  // namespace
}  // namespace lancer::reference
