#include "reference/compare/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reference/compare/comparison_text.h"

namespace lancer::reference {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

CompareOptions over(double fail, double percent = 0) {
    CompareOptions options;
    options.fail = fail;
    options.fail_percent = percent;
    options.flip = false;
    return options;
}

/// 20 x 10 pixels, all channels 0.25.
Image grey() {
    Image image(20, 10);
    for (double& value : image.data) value = 0.25;
    return image;
}

TEST(CompareImages, PassesEqualPicturesWithAllMeasuresZero) {
    const Comparison c = compare_images(grey(), grey(), over(0));
    EXPECT_TRUE(c.pass);
    EXPECT_EQ(c.pixels, 200u);
    EXPECT_EQ(c.mean, 0);
    EXPECT_EQ(c.rmse, 0);
    EXPECT_EQ(c.max, 0);
    EXPECT_EQ(c.over, 0);
    EXPECT_TRUE(std::isinf(c.psnr));
}

/// The same with a fourth channel.
Image with_alpha(const Image& image, double alpha) {
    Image result(image.width, image.height, 4);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            for (int c = 0; c < 3; ++c) result.pixel(x, y)[c] = image.pixel(x, y)[c];
            result.pixel(x, y)[3] = alpha;
        }
    }
    return result;
}

TEST(CompareImages, AnAlphaThatIsOneEverywhereIsNoDifference) {
    Image b = with_alpha(grey(), 1);
    EXPECT_TRUE(compare_images(grey(), b, over(0)).pass);
    EXPECT_TRUE(compare_images(b, grey(), over(0)).pass);
    EXPECT_EQ(compare_images(b, grey(), over(0)).channels, 3);
    b.pixel(7, 3)[1] = 0.55;
    const Comparison c = compare_images(b, grey(), over(0.1));
    EXPECT_EQ(c.pixels_over, 1u);
    EXPECT_NEAR(c.mean, 0.3 / 600, 1e-15);
    EXPECT_EQ(pixel_differences(grey(), b)[67], b.pixel(7, 3)[1] - 0.25);

    b.pixel(19, 9)[3] = 0.999;
    EXPECT_THAT(compare_images(grey(), b, over(1)).reason, HasSubstr("3 against 4"));
    EXPECT_EQ(compare_images(with_alpha(grey(), 1), b, over(0.1)).pixels_over, 1u)
        << "two alphas are compared";
}

TEST(CompareImages, MeasuresOneDifferentValueOfOnePixel) {
    Image b = grey();
    b.pixel(7, 3)[1] = 0.55;
    const Comparison c = compare_images(grey(), b, over(0.1));
    EXPECT_FALSE(c.pass);
    EXPECT_NEAR(c.mean, 0.3 / 600, 1e-15);
    EXPECT_NEAR(c.rmse, std::sqrt(0.09 / 600), 1e-15);
    EXPECT_NEAR(c.psnr, 10 * std::log10(600 / 0.09), 1e-9);
    EXPECT_NEAR(c.max, 0.3, 1e-15);
    EXPECT_EQ(c.max_x, 7);
    EXPECT_EQ(c.max_y, 3);
    EXPECT_EQ(c.max_channel, 1);
    EXPECT_EQ(c.max_a, 0.25);
    EXPECT_EQ(c.max_b, 0.55);
    EXPECT_EQ(c.pixels_over, 1u);
    EXPECT_NEAR(c.over, 0.005, 1e-15);
    EXPECT_EQ(c.p99, 0);
    EXPECT_NEAR(c.p999, 0.3, 1e-15) << "one pixel of 200 is more than a thousandth";
}

TEST(CompareImages, AllowsExactlyThePercentageOfPixels) {
    Image b = grey();
    b.pixel(0, 0)[0] = 1;
    EXPECT_TRUE(compare_images(grey(), b, over(0.1, 0.5)).pass);
    b.pixel(19, 9)[2] = 1;
    EXPECT_FALSE(compare_images(grey(), b, over(0.1, 0.5)).pass);
    EXPECT_TRUE(compare_images(grey(), b, over(0.1, 1)).pass);
    EXPECT_TRUE(compare_images(grey(), b, over(0.1, 100)).pass);
}

TEST(CompareImages, CountsAPixelOnceHoweverManyChannelsDiffer) {
    Image b = grey();
    for (int c = 0; c < 3; ++c) b.pixel(4, 4)[c] = 0.9;
    EXPECT_EQ(compare_images(grey(), b, over(0.1)).pixels_over, 1u);
}

TEST(CompareImages, IsOverOnlyWhenGreaterThanTheThreshold) {
    Image b = grey();
    b.pixel(0, 0)[0] = 0.5;
    EXPECT_TRUE(compare_images(grey(), b, over(0.25)).pass);
    EXPECT_FALSE(compare_images(grey(), b, over(std::nextafter(0.25, 0.0))).pass);
}

TEST(CompareImages, FailsWhenSizesDiffer) {
    const Comparison c = compare_images(grey(), Image(20, 11), over(1));
    EXPECT_FALSE(c.pass);
    EXPECT_FALSE(c.comparable);
    EXPECT_EQ(c.reason, "the sizes differ: 20 x 10 against 20 x 11");
}

TEST(CompareImages, FailsWhenTheNumbersOfChannelsDiffer) {
    const Comparison c = compare_images(Image(4, 4, 3), Image(4, 4, 4), over(1));
    EXPECT_FALSE(c.pass);
    EXPECT_EQ(c.reason, "the numbers of channels differ: 3 against 4");
}

TEST(CompareImages, LeavesOutNamedExtraChannels) {
    Image a(4, 4, 4);
    a.extra_names = {"depth.Z"};
    a.pixel(1, 1)[3] = 7;
    EXPECT_TRUE(compare_images(a, Image(4, 4, 3), over(0)).pass);
}

TEST(CompareImages, FailsOnNotANumberInEitherPicture) {
    Image bad = grey();
    bad.pixel(3, 4)[2] = nan;
    const Comparison first = compare_images(bad, grey(), over(1));
    EXPECT_FALSE(first.pass);
    EXPECT_EQ(first.reason,
              "the first picture has 1 value that is NaN or infinite, the first at (3, 4)");
    const Comparison second = compare_images(grey(), bad, over(1, 100));
    EXPECT_FALSE(second.pass);
    EXPECT_THAT(second.reason, HasSubstr("the second picture"));
}

TEST(CompareImages, FailsOnNotANumberOrInfinityAtTheSamePlaceInBoth) {
    for (const double value : {nan, infinity, -infinity}) {
        Image bad = grey();
        bad.pixel(0, 0)[0] = value;
        EXPECT_FALSE(compare_images(bad, bad, over(1, 100)).pass) << value;
    }
}

TEST(CompareImages, FailsEmptyPicturesInsteadOfCallingThemEqual) {
    EXPECT_FALSE(compare_images(Image(), Image(), over(1)).pass);
}

TEST(Percentile, IsTheNearestRank) {
    std::vector<double> values;
    for (int i = 1000; i >= 1; --i) values.push_back(i);
    EXPECT_EQ(percentile(values, 0.99), 990);
    EXPECT_EQ(percentile(values, 0.999), 999);
    EXPECT_EQ(percentile(values, 1), 1000);
    EXPECT_EQ(percentile(values, 1e-9), 1);
}

TEST(ComparisonText, PrintsTheAchievedValueBesideTheThreshold) {
    Image b = grey();
    b.pixel(7, 3)[1] = 0.55;
    const CompareOptions options = over(0.1, 0.25);
    const std::string text = to_text(compare_images(grey(), b, options), options);
    EXPECT_THAT(text, HasSubstr("0.3 at (7, 3), green: 0.25 against 0.55"));
    EXPECT_THAT(text, HasSubstr("0.5 % of the pixels over 0.1, allowed 0.25 %"));
    EXPECT_THAT(text, HasSubstr("FAIL: 1 of 200 pixels differ by more than 0.1, 0 allowed"));
}

TEST(ComparisonText, NamesCurvesThatDiffer) {
    Comparison different = compare_images(grey(), grey(), over(0));
    different.curve_a = "sRGB";
    different.curve_b = "gAMA 0.45455";
    EXPECT_THAT(to_text(different, over(0)), HasSubstr("curves  sRGB against gAMA 0.45455: "));
    EXPECT_EQ(nlohmann::json::parse(to_json(different, over(0))).at("curves"),
              nlohmann::json({"sRGB", "gAMA 0.45455"}));
    for (const char* curve : {"sRGB", ""}) {
        different.curve_b = curve;
        EXPECT_THAT(to_text(different, over(0)), testing::Not(HasSubstr("curves")));
    }
}

TEST(ComparisonJson, HasEveryKeyOfTheContract) {
    Image b = grey();
    b.pixel(7, 3)[1] = 0.55;
    const CompareOptions options = over(0.1);
    const auto json = nlohmann::json::parse(to_json(compare_images(grey(), b, options), options));
    EXPECT_EQ(json.at("verdict"), "fail");
    EXPECT_EQ(json.at("pixels"), 200);
    for (const char* key : {"mean", "rmse", "max", "p99", "p999", "over"}) {
        EXPECT_TRUE(json.at(key).is_number()) << key;
    }
}

TEST(ComparisonJson, HasNullForWhatWasNotMeasured) {
    const auto json =
        nlohmann::json::parse(to_json(compare_images(grey(), Image(1, 1), over(0)), over(0)));
    EXPECT_EQ(json.at("verdict"), "fail");
    EXPECT_THAT(json.at("reason").get<std::string>(), HasSubstr("sizes differ"));
    EXPECT_TRUE(json.at("max").is_null());
}

}  // namespace
}  // namespace lancer::reference
