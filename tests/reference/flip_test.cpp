#include "reference/compare/flip.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace lancer::reference {
namespace {

Image flat(double r, double g, double b, int width = 9, int height = 7) {
    Image image(width, height);
    for (std::size_t i = 0; i < image.data.size(); i += 3) {
        image.data[i] = r;
        image.data[i + 1] = g;
        image.data[i + 2] = b;
    }
    return image;
}

/// The same formulas as picture() in flip_check.py.
Image picture(const std::string& kind, bool test) {
    Image image(17, 13);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            double* p = image.pixel(x, y);
            if (kind == "noise") {
                const int seed = 7 * x + 3 * y + (test ? 5 : 0);
                p[0] = seed % 11 / 10.0;
                p[1] = seed * 5 % 13 / 12.0;
                p[2] = seed * 3 % 7 / 6.0;
            } else if (x + (test ? 1 : 0) > 8) {
                p[0] = 0.8;
                p[1] = 0.6;
                p[2] = 0.1 + y / 20.0;
            } else {
                p[0] = 0.05;
                p[1] = 0.1;
                p[2] = 0.3;
            }
        }
    }
    return image;
}

TEST(Flip, AgreesWithTheSeparateComputationInPython) {
    std::ifstream expected(LANCER_SOURCE_DIR "/tests/reference/flip_expected.txt");
    ASSERT_TRUE(expected);
    std::string line;
    int compared = 0;
    while (std::getline(expected, line)) {
        if (line.starts_with('#')) continue;
        std::istringstream fields(line);
        std::string kind;
        double pixels_per_degree = 0;
        std::size_t x = 0;
        std::size_t y = 0;
        double error = 0;
        ASSERT_TRUE(fields >> kind >> pixels_per_degree >> x >> y >> error) << line;
        const std::vector<double> errors =
            flip_errors(picture(kind, false), picture(kind, true), pixels_per_degree);
        EXPECT_NEAR(errors[y * 17 + x], error, 1e-6) << line;
        ++compared;
    }
    EXPECT_EQ(compared, 28);
}

// Flat pictures have no features: the error is the redistributed colour difference. Black and white
// are 100 apart in lightness, 100^0.7 = 25.118864; green and blue, by hand from the CIE formulas,
// 203.6 apart, 41.276; 0.95 + 0.05 (25.118864 - 16.510) / (41.276 - 16.510) = 0.96738.
TEST(Flip, OfBlackAgainstWhiteIsWhatThePaperGives) {
    EXPECT_NEAR(mean_flip(flat(0, 0, 0), flat(1, 1, 1)), 0.96738, 2e-5);
}

TEST(Flip, OfGreenAgainstBlueIsTheLargest) {
    EXPECT_NEAR(mean_flip(flat(0, 1, 0), flat(0, 0, 1)), 1.0, 1e-12);
}

TEST(Flip, OfEqualPicturesIsZero) {
    EXPECT_EQ(mean_flip(picture("noise", true), picture("noise", true)), 0.0);
}

TEST(Flip, IsSymmetric) {
    const Image a = picture("edge", false);
    const Image b = picture("noise", true);
    EXPECT_EQ(flip_errors(a, b), flip_errors(b, a));
}

TEST(Flip, ClampsToTheRangeOfADisplay) {
    EXPECT_EQ(mean_flip(flat(3, 1, 1), flat(1, 1, 1)), 0.0);
    EXPECT_EQ(mean_flip(flat(0, 0, 0), flat(-1, 0, 0)), 0.0);
}

TEST(Flip, TakesOneChannelAsGrey) {
    Image grey(9, 7, 1);
    for (double& value : grey.data) value = 1;
    Image black(9, 7, 1);
    EXPECT_NEAR(mean_flip(grey, black), mean_flip(flat(1, 1, 1), flat(0, 0, 0)), 1e-12);
}

}  // namespace
}  // namespace lancer::reference
