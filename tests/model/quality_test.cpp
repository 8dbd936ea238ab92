// Settings by one word.
#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "model/quality.h"

namespace lancer {
namespace {

TEST(Quality, HasNames) {
    std::set<std::string_view> names;
    for (const Quality quality : all_qualities) names.insert(name_of(quality));
    EXPECT_EQ(names.size(), all_qualities.size());
    EXPECT_EQ(names.count(""), 0u);
}

TEST(Quality, CutsLessFromOneToTheNext) {
    for (std::size_t i = 1; i < all_qualities.size(); ++i) {
        const QualityValues& coarse = values_of(all_qualities[i - 1]);
        const QualityValues& fine = values_of(all_qualities[i]);
        EXPECT_LT(coarse.samples, fine.samples);
        EXPECT_LT(coarse.max_depth, fine.max_depth);
        EXPECT_GT(coarse.min_contribution, fine.min_contribution);
    }
}

TEST(Quality, LeavesAloneWhatItDoesNotDecide) {
    Settings settings;
    settings.shadows = false;
    settings.tolerance = 0.25;
    settings.seed = 7;
    apply(values_of(Quality::fine), settings);
    EXPECT_FALSE(settings.shadows);
    EXPECT_EQ(settings.tolerance, 0.25);
    EXPECT_EQ(settings.seed, 7U);
    EXPECT_EQ(settings.samples, values_of(Quality::fine).samples);
}

}  // namespace
}  // namespace lancer
