#include "accuracy/rare_light.h"

#include <algorithm>

#include "model/elementary.h"

namespace lancer::accuracy {
namespace {

constexpr double fewest = 20;
constexpr double noticed_share = 0.3;
constexpr double seen_by_audits = 0.125;  // share of a pixel; an audit's nets meet larger specks

struct Surroundings {
    Color mean{0, 0, 0};
    double variance = 0;  ///< of the samples of the pixels around, summed over channels
};

Surroundings surroundings(const PictureSamples& samples, std::size_t pixel) {
    const auto width = static_cast<std::size_t>(samples.width());
    const int x = static_cast<int>(pixel % width);
    const int y = static_cast<int>(pixel / width);
    Color sum{0, 0, 0};
    double squares = 0;
    double count = 0;
    for (int row = std::max(0, y - 1); row <= std::min(samples.height() - 1, y + 1); ++row) {
        for (int column = std::max(0, x - 1); column <= std::min(samples.width() - 1, x + 1);
             ++column) {
            if ((column == x && row == y) || !samples.are_near(y, row)) continue;
            const PixelSums& near = samples.pixels()[static_cast<std::size_t>(row) * width +
                                                     static_cast<std::size_t>(column)];
            sum += near.mean();
            squares += near.squares / near.count;
            ++count;
        }
    }
    if (count == 0) return {samples.pixels()[pixel].mean(), 0};
    const Color mean = sum / count;
    return {mean, std::max(0.0, squares / count - dot(mean, mean))};
}

double square(const Color& color) {
    return dot(color, color);
}

/// Whether a pixel's samples lie far from the mean around it, measured by the variance around it.
bool is_alone(const PixelSums& own, const Surroundings& around) {
    const double distance =
        own.squares / own.count - 2 * dot(own.mean(), around.mean) + square(around.mean);
    return distance > 4 * around.variance + 1e-12 * own.squares / own.count;
}

}  // namespace

RareLight::RareLight(const PictureSamples& first) {
    for (std::size_t pixel = 0; pixel < first.size(); ++pixel)
        if (is_alone(first.pixels()[pixel], surroundings(first, pixel))) pixels_.push_back(pixel);
    if (first.size() > 0) count_ = first.pixels().front().count;
}

double RareLight::met_alone(const PictureSamples& first) const {
    double sum = 0;
    for (const std::size_t pixel : pixels_)
        sum += square(first.pixels()[pixel].mean() - surroundings(first, pixel).mean);
    return sum;
}

Specks RareLight::missed(const PictureSamples& later) const {
    Specks missed;
    for (const std::size_t pixel : pixels_) {
        const PixelSums& own = later.pixels()[pixel];
        const Surroundings around = surroundings(later, pixel);
        if (!is_alone(own, around)) continue;
        // Model: a speck of light L covers the share s of the pixel, on an even ground. The mean
        // then differs by L s from the ground, and the variance is L^2 s (1 - s).
        const double added = square(own.mean() - around.mean);
        if (added == 0) continue;
        const double share = added / (own.variance() + added);
        if (share >= seen_by_audits) continue;
        const double unseen = elementary::pow(1 - share, count_);
        if (unseen >= 1) continue;
        const double error = added * unseen / (1 - unseen);
        missed.error += error;
        missed.squares += error * error;
        missed.pixels.push_back({later.column(pixel), later.row(pixel), error});
    }
    std::stable_sort(missed.pixels.begin(), missed.pixels.end(),
                     [](const PixelShare& a, const PixelShare& b) { return a.share > b.share; });
    missed.pixels.resize(std::min<std::size_t>(missed.pixels.size(), 3));
    for (PixelShare& p : missed.pixels) p.share /= missed.error;
    return missed;
}

bool is_noticed(double error, double rmse, double pixels_of_picture) {
    return error > noticed_share * rmse * rmse * 3 * pixels_of_picture;
}

bool Specks::forbid(double rmse, double pixels_of_picture) const {
    return is_noticed(error, rmse, pixels_of_picture) &&
           error * error < fewest * squares;  // fewer effective specks than `fewest`
}

}  // namespace lancer::accuracy
