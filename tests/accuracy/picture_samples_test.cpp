// Samples, the prediction from them, and where more go.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "accuracy/allocation.h"
#include "accuracy/picture_samples.h"
#include "accuracy/prediction.h"
#include "tests/accuracy/plain_pictures.h"

namespace lancer::accuracy {
namespace {

class Sampled : public testing::Test {
  protected:
    Sampled() {
        view_.width = 32;
        view_.height = 24;
    }
    View view_;
    PlainRenderer renderer_{plain_picture("balls")};
};

std::vector<std::uint32_t> everywhere(const PictureSamples& samples, std::uint32_t count) {
    return std::vector<std::uint32_t>(samples.size(), count);
}

TEST_F(Sampled, APixelsSamplesDoNotDependOnHowTheyWereTaken) {
    PictureSamples at_once(renderer_, view_, {}, 5);
    at_once.raise(everywhere(at_once, 8), {});
    PictureSamples in_steps(renderer_, view_, {}, 5);
    for (const std::uint32_t n : {1U, 2U, 4U, 8U}) in_steps.raise(everywhere(in_steps, n), {});
    EXPECT_EQ(at_once.image().data, in_steps.image().data);
    EXPECT_EQ(in_steps.rays().primary, 8 * at_once.size());

    View part = view_;
    part.crop = Crop{5, 7, 4, 3};
    PictureSamples cropped(renderer_, part, {}, 5);
    cropped.raise(everywhere(cropped, 8), {});
    EXPECT_EQ(cropped.image().pixel(1, 2)[0], at_once.image().pixel(6, 9)[0]);

    PictureSamples other(renderer_, view_, {}, 6);
    other.raise(everywhere(other, 8), {});
    EXPECT_NE(at_once.image().data, other.image().data);
}

TEST(PixelSums, TheVarianceHasNoBias) {
    PixelSums sums;
    EXPECT_EQ(sums.variance(), 0);
    for (const double v : {1.0, 2.0, 4.0}) sums.add({v, 0, 2 * v});
    EXPECT_NEAR(sums.variance(), 5 * 7.0 / 3, 1e-12);
    EXPECT_EQ(sums.mean(), Color(7.0 / 3, 0, 14.0 / 3));
}

TEST(BoxMeans, AreMeansAlsoAtTheBorders) {
    std::vector<double> values(30);
    std::iota(values.begin(), values.end(), 1.0);
    const std::vector<double> means = box_means(values, 6, 5, 2);
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 6; ++x) {
            double sum = 0;
            int count = 0;
            for (int v = std::max(0, y - 2); v <= std::min(4, y + 2); ++v)
                for (int u = std::max(0, x - 2); u <= std::min(5, x + 2); ++u, ++count)
                    sum += values[static_cast<std::size_t>(v * 6 + u)];
            EXPECT_NEAR(means[static_cast<std::size_t>(y * 6 + x)], sum / count, 1e-12);
        }
    }
}

TEST_F(Sampled, MoreRaysGoWhereThePictureIsRough) {
    view_.width = 128;
    view_.height = 96;
    PictureSamples samples(renderer_, view_, {}, 1);
    samples.raise(everywhere(samples, 2), {});
    Prediction prediction;
    prediction.score(samples);
    const double before = prediction.mean_square(samples);
    ASSERT_TRUE(refine(samples, prediction, before / 20, 1U << 30, {}));
    EXPECT_LE(prediction.mean_square(samples), before / 20);
    // The wall keeps its two; the border of the last ball has many more.
    EXPECT_EQ(samples.pixels()[2 * 128 + 120].count, 2U);
    std::uint32_t most = 0;
    for (const PixelSums& p : samples.pixels()) most = std::max(most, p.count);
    EXPECT_GE(most, 16U);
}

TEST_F(Sampled, RefiningStopsBeforeTheCap) {
    PictureSamples samples(renderer_, view_, {}, 1);
    samples.raise(everywhere(samples, 2), {});
    Prediction prediction;
    EXPECT_FALSE(refine(samples, prediction, 1e-12, 5000, {}));
    EXPECT_LE(samples.rays().primary, 5000U);
}

TEST_F(Sampled, RaysForAnErrorAndTheErrorForRaysAreInverse) {
    PictureSamples samples(renderer_, view_, {}, 1);
    samples.raise(everywhere(samples, 2), {});
    Prediction prediction;
    prediction.score(samples);
    const double mean_square = prediction.mean_square(samples) / 10;
    const double rays = rays_for(samples, prediction, mean_square);
    EXPECT_GT(rays, 2);
    EXPECT_NEAR(mean_square_for(samples, prediction, rays) / mean_square, 1, 1e-6);
}

}  // namespace
}  // namespace lancer::accuracy
