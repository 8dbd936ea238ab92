// Pictures in parts, each made for the same target error: the error of all parts together.
#include "accuracy/joined_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "accuracy/error_target.h"
#include "accuracy/off_target.h"
#include "tests/accuracy/plain_pictures.h"

namespace lancer::accuracy {
namespace {

/// Strips of 4 rows, dealt in turn.
PictureRows dealt(int part, int parts, int height) {
    PictureRows rows{part, parts, {}};
    for (int first = 4 * part; first < height; first += 4 * parts)
        rows.ranges.push_back({first, std::min(4, height - first)});
    return rows;
}

ErrorPicture part_of(const PlainRenderer& renderer, double error, std::uint64_t seed,
                     const PictureRows& rows) {
    ErrorGoal goal;
    goal.max_error = error;
    goal.seed = seed;
    goal.rows = rows;
    return render_to_error(renderer, {renderer, limits_of_truth(error)}, view_of_128(), goal, {});
}

ErrorPicture whole(const PlainRenderer& renderer, double error, std::uint64_t seed) {
    ErrorGoal goal;
    goal.max_error = error;
    goal.seed = seed;
    return render_to_error(renderer, {renderer, limits_of_truth(error)}, view_of_128(), goal, {});
}

struct Joined {
    Image image{view_of_128().width, view_of_128().height};
    std::vector<ErrorSums> sums;

    void add(const ErrorPicture& part, const PictureRows& rows) {
        int from = 0;
        for (const RowRange& range : rows.ranges)
            for (int y = 0; y < range.count; ++y)
                std::copy_n(part.image.pixel(0, from++), 3 * image.width,
                            image.pixel(0, range.first + y));
        sums.push_back(part.sums);
    }
};

Joined joined(const PlainRenderer& renderer, double error, std::uint64_t seed, int parts) {
    Joined all;
    for (int part = 0; part < parts; ++part) {
        const PictureRows rows = dealt(part, parts, view_of_128().height);
        all.add(part_of(renderer, error, seed, rows), rows);
    }
    return all;
}

TEST(JoinedReport, IntervalsHoldTheTruthAndGoalsAreHeld) {
    int runs = 0, told = 0, missed = 0, above = 0;
    const auto count = [&](const std::string& name, double goal, std::uint64_t seeds) {
        const PlainRenderer renderer(plain_picture(name));
        const Image truth = truth_of(plain_picture(name), view_of_128(), name == "wires" ? 64 : 32);
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            const Joined all = joined(renderer, goal, seed, 5);
            const ErrorReport report = joined_report(all.sums);
            const double error = rms_difference(all.image, truth);
            ++runs;
            above += error > goal;
            EXPECT_TRUE(report.is_reached()) << name << ' ' << goal << ' ' << seed;
            if (!report.is_told) continue;
            ++told;
            missed += error < report.error.low || error > report.error.high;
            EXPECT_LE(report.error.half_width(), 0.13);
        }
    };
    for (const char* name : {"balls", "waves", "hall"}) count(name, 0.01, 5);
    count("wires", 0.02, 8);
    EXPECT_EQ(runs, 23);
    EXPECT_GE(told, 22);
    // With intervals of 95 %, more than 4 of 23 miss by chance once in 400 times.
    EXPECT_LE(missed, 4);
    EXPECT_EQ(above, 0);
}

TEST(JoinedReport, OfOnePartIsThatOfTheWhole) {
    for (const char* name : {"balls", "sparks", "wires"}) {
        const PlainRenderer renderer(plain_picture(name));
        const ErrorPicture picture = whole(renderer, 0.02, 3);
        const ErrorPicture part = part_of(renderer, 0.02, 3, dealt(0, 1, view_of_128().height));
        EXPECT_EQ(picture.image.data, part.image.data);
        const ErrorReport told = joined_report({&part.sums, 1});
        const ErrorReport& wanted = picture.report;
        EXPECT_EQ(told.is_told, wanted.is_told) << name;
        EXPECT_EQ(told.rare_light, wanted.rare_light);
        EXPECT_EQ(told.is_reached(), wanted.is_reached());
        EXPECT_EQ(told.error.rmse, wanted.error.rmse);
        EXPECT_EQ(told.error.low, wanted.error.low);
        EXPECT_EQ(told.error.high, wanted.error.high);
        EXPECT_EQ(told.effective_draws, wanted.effective_draws);
        EXPECT_EQ(told.predicted, wanted.predicted);
        EXPECT_EQ(told.rays_per_pixel, wanted.rays_per_pixel);
        EXPECT_EQ(told.even_rays_per_pixel, wanted.even_rays_per_pixel);
        EXPECT_EQ(told.printed.primary, wanted.printed.primary);
        ASSERT_EQ(told.dominant.size(), wanted.dominant.size());
        for (std::size_t i = 0; i < told.dominant.size(); ++i) {
            EXPECT_EQ(told.dominant[i].x, wanted.dominant[i].x);
            EXPECT_EQ(told.dominant[i].y, wanted.dominant[i].y);
            EXPECT_NEAR(told.dominant[i].share, wanted.dominant[i].share, 1e-12);
        }
    }
}

/// The lower sixth has waves; the rest is flat.
TEST(JoinedReport, APartCountsByItsPixels) {
    const PlainRenderer renderer([](double x, double y, const TraceLimits&) {
        const double wave = std::sin(x * x / 5) * std::cos(y * 3);
        return Color{1, 1, 1} * (y < 80 ? 0.5 : 0.5 + 0.4 * wave);
    });
    const PictureRows upper{0, 2, {{0, 80}}};
    const PictureRows lower{1, 2, {{80, 16}}};
    std::vector<ErrorSums> sums;
    sums.push_back(part_of(renderer, 0.02, 1, upper).sums);
    const ErrorPicture rough = part_of(renderer, 0.02, 1, lower);
    sums.push_back(rough.sums);
    const ErrorReport report = joined_report(sums);
    ASSERT_TRUE(rough.report.is_told);
    ASSERT_TRUE(report.is_told);
    EXPECT_NEAR(report.error.mean_square, rough.report.error.mean_square / 6,
                1e-12 * report.error.mean_square);
    EXPECT_NEAR(report.error.log_error(), rough.report.error.log_error(), 1e-12);
    EXPECT_NEAR(report.rays_per_pixel, (2 * 80 + rough.report.rays_per_pixel * 16) / 96, 1e-9);
}

/// Too few draws in each part, but enough in all together: the error of the whole is told although
/// that of no part is.
TEST(JoinedReport, PartsOfFewCarryingDrawsTellTogether) {
    ErrorSums part;
    part.pixels = 1000;
    part.asked = 0.02;
    part.audited = true;
    part.deciding = part.printed = TermSums(std::vector<double>{});
    std::vector<double> terms(1000, 0);
    std::fill_n(terms.begin(), 20, 0.005);
    part.deciding.add(terms);
    part.printed.add(terms);
    EXPECT_FALSE(joined_report({&part, 1}).is_told);
    std::vector<ErrorSums> parts(6, part);
    EXPECT_TRUE(joined_report(parts).is_told);
    parts.back().deciding = parts.back().printed = TermSums(std::vector<double>(1000, 0.0));
    EXPECT_TRUE(joined_report(parts).is_told);
    // The samples predict an error where no draw found any.
    parts.back().predicted = 3 * 6000 * 0.003 * 0.003;
    EXPECT_FALSE(joined_report(parts).is_told);
    parts.back() = part;
    parts.back().rare_light = true;
    EXPECT_FALSE(joined_report(parts).is_told);
}

TEST(JoinedReport, SpecksAreRefusedAnInterval) {
    const PlainRenderer renderer(plain_picture("sparks"));
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const ErrorReport report = joined_report(joined(renderer, 0.01, seed, 3).sums);
        EXPECT_FALSE(report.is_told) << seed;
        EXPECT_FALSE(report.is_reached()) << seed;
        EXPECT_TRUE(report.rare_light) << seed;
        EXPECT_FALSE(report.dominant.empty()) << seed;
    }
}

TEST(JoinedReport, PartsDrawApart) {
    const PlainRenderer renderer(plain_picture("balls"));
    const View view = view_of_128();
    const PictureSamples all(renderer, view, {}, 5);
    const PictureSamples first(renderer, view, {}, 5, dealt(0, 3, view.height));
    const PictureSamples second(renderer, view, {}, 5, dealt(1, 3, view.height));
    EXPECT_EQ(all.key(1), first.key(1));
    EXPECT_NE(first.key(1), second.key(1));
    EXPECT_EQ(second.row(0), 4);
    EXPECT_EQ(second.row(4 * 128), 16);
    EXPECT_EQ(second.pixel_at(7, 17), 5U * 128 + 7);
}

/// A slope over the whole picture. Rows that are neighbours in a part but far apart in the picture
/// must not cause more samples.
TEST(JoinedReport, SeamsOfStripsTakeNoMoreSamples) {
    const PlainRenderer renderer([](double, double y, const TraceLimits&) {
        return Color{1, 1, 1} * (y / 96);
    });
    const ErrorPicture part = part_of(renderer, 0.002, 1, dealt(1, 4, view_of_128().height));
    EXPECT_LT(part.report.rays_per_pixel, 1.05 * whole(renderer, 0.002, 1).report.rays_per_pixel);
}

TEST(JoinedReport, SharesOffAreHeldAndIntervalsHoldTheTruth) {
    constexpr double steps = 3, share = 0.02;
    const PlainRenderer renderer(plain_picture("balls"));
    const Image truth = truth_of(plain_picture("balls"), view_of_128());
    const auto made = [&](std::uint64_t seed, int parts) {
        Joined all;
        for (int part = 0; part < parts; ++part) {
            OffGoal goal;
            goal.share = share;
            goal.steps = steps;
            goal.seed = seed;
            goal.rows = dealt(part, parts, view_of_128().height);
            const Truth judge{renderer, limits_of_truth(goal.threshold())};
            all.add(render_to_share(renderer, judge, view_of_128(), goal, {}), *goal.rows);
        }
        return all;
    };
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const Joined all = made(seed, 5);
        int off = 0;
        for (int y = 0; y < all.image.height; ++y)
            for (int x = 0; x < all.image.width; ++x) {
                double most = 0;
                for (int c = 0; c < 3; ++c)
                    most =
                        std::max(most, std::abs(all.image.pixel(x, y)[c] - truth.pixel(x, y)[c]));
                off += most > steps / 255;
            }
        const double found = off / (128.0 * 96);
        const ErrorReport report = joined_report(all.sums);
        EXPECT_TRUE(report.is_reached()) << seed;
        EXPECT_LE(found, share);
        // Clopper and Pearson's interval misses less than once in 20 times; here it is wide.
        EXPECT_LE(report.off->estimate.low, found) << seed;
        EXPECT_GE(report.off->estimate.high, found) << seed;
        EXPECT_LT(report.off->estimate.high, share);
    }
}

/// One part has a tenth of the draws per pixel of the other.
TEST(JoinedReport, EndsMakeUpForPartsWithFewDraws) {
    ErrorSums part;
    part.pixels = 100;
    part.audited = true;
    part.off.emplace();
    part.off->asked = 0.1;
    part.off->printed.calm = {100, 1000, 10, 0};
    std::vector<ErrorSums> parts(2, part);
    const OffEstimate even = joined_report(parts).off->estimate;
    EXPECT_NEAR(even.share, 0.01, 1e-15);
    EXPECT_LT(even.high, 0.016);
    parts[1].off->printed.calm = {100, 100, 10, 0};
    const OffEstimate uneven = joined_report(parts).off->estimate;
    EXPECT_NEAR(uneven.share, 0.055, 1e-15);
    EXPECT_GT(uneven.high, 0.1);
    EXPECT_LT(uneven.low, 0.01);
}

TEST(ErrorSums, TextHasEveryBitAndWhatIsDamagedIsRefused) {
    const PlainRenderer renderer(plain_picture("balls"));
    const ErrorSums sums = part_of(renderer, 0.02, 3, dealt(1, 3, 96)).sums;
    const std::string text = to_text(sums);
    EXPECT_EQ(text.find('\n'), std::string::npos);
    const auto read = error_sums_of(text);
    ASSERT_TRUE(read);
    EXPECT_EQ(to_text(*read), text);
    EXPECT_EQ(read->printed.squares, sums.printed.squares);
    EXPECT_EQ(read->dominant.size(), sums.dominant.size());
    ErrorSums off = sums;
    off.off.emplace();
    off.off->printed.risky = {static_cast<std::uint64_t>(off.pixels), 100, 3, 1};
    ASSERT_TRUE(error_sums_of(to_text(off)));
    EXPECT_EQ(error_sums_of(to_text(off))->off->printed.risky.off, 3U);
    off.off->printed.risky.off = 101;
    EXPECT_FALSE(error_sums_of(to_text(off)));
    off.off->printed.risky.off = 3;
    off.off->printed.risky.draws = 1'000'000'000'000;
    EXPECT_FALSE(error_sums_of(to_text(off))) << "would be counted for years";
    EXPECT_FALSE(error_sums_of(""));
    EXPECT_FALSE(error_sums_of(text + " 1"));
    EXPECT_FALSE(error_sums_of(text.substr(0, text.size() / 2)));
    ErrorSums strange = sums;
    strange.scores = HUGE_VAL;
    EXPECT_FALSE(error_sums_of(to_text(strange)));
    strange = sums;
    strange.dominant.resize(1);
    strange.dominant[0].share = std::nan("");
    EXPECT_FALSE(error_sums_of(to_text(strange)));
    strange = sums;
    strange.printed.count = 0;
    EXPECT_FALSE(error_sums_of(to_text(strange)));
}

}  // namespace
}  // namespace lancer::accuracy
