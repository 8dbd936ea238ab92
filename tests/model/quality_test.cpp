// Settings by one word.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "model/quality.h"

namespace lancer {
namespace {

/// The cells of a row of a table, without the spaces and quotes around them.
std::vector<std::string> cells_of(const std::string& row) {
    std::vector<std::string> cells;
    std::stringstream text(row.substr(1));
    for (std::string cell; std::getline(text, cell, '|');) {
        const std::size_t begin = cell.find_first_not_of(" `");
        const std::size_t end = cell.find_last_not_of(" `");
        cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
    }
    return cells;
}

/// The presets that presets.py derived: name, aim, sampling, samples, depth, contribution ...
std::vector<std::vector<std::string>> derived_presets() {
    std::ifstream file(LANCER_SOURCE_DIR "/docs/cost-of-accuracy.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    const std::size_t begin = page.find("<!-- begin: tests/bench/presets.py, derived -->");
    std::stringstream part(page.substr(begin, page.find("<!-- end:", begin) - begin));
    std::vector<std::vector<std::string>> presets;
    for (std::string line; std::getline(part, line);)
        if (line.starts_with("| `")) presets.push_back(cells_of(line));
    return presets;
}

TEST(Quality, IsWhatMeasurementsOfTheGalleryGave) {
    const std::vector<std::vector<std::string>> presets = derived_presets();
    ASSERT_EQ(presets.size(), 3U);
    for (std::size_t i = 0; i < presets.size(); ++i) {
        const std::vector<std::string>& row = presets[i];
        const QualityValues& values = values_of(all_qualities[i]);
        ASSERT_GE(row.size(), 6U);
        EXPECT_EQ(row[0], name_of(all_qualities[i]));
        EXPECT_EQ(row[2], values.sampling == Sampling::grid ? "grid" : "sobol") << row[0];
        EXPECT_EQ(std::stoi(row[3]), values.samples) << row[0];
        EXPECT_EQ(std::stoi(row[4]), values.max_depth) << row[0];
        EXPECT_EQ(std::stod(row[5]), values.min_contribution) << row[0];
    }
}

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
