#include "accuracy/prediction.h"

#include <algorithm>
#include <cmath>

namespace lancer::accuracy {
namespace {

// Tuned on two scenes and used unchanged on the others: docs/cost-of-accuracy.md.
constexpr double neighbor_samples = 4;  // the neighbourhood's weight, as a number of samples
constexpr double neighbor_share = 0.3;  // of its variance, part of which is slow change
constexpr double from_surroundings = 0.05;
constexpr double from_everywhere = 0.003;

/// The variance of all samples of the 3 x 3 pixels around one, near ones counting more.
double variance_around(const PictureSamples& samples, int x, int y) {
    Color mean{0, 0, 0};
    double squares = 0;
    double weights = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int column = x + dx;
            const int row = y + dy;
            if (column < 0 || row < 0 || column >= samples.width() || row >= samples.height() ||
                !samples.are_near(y, row))
                continue;
            const PixelSums& sums = samples.pixels()[static_cast<std::size_t>(row) *
                                                         static_cast<std::size_t>(samples.width()) +
                                                     static_cast<std::size_t>(column)];
            const double weight = (dx == 0 ? 1 : 0.5) * (dy == 0 ? 1 : 0.5);
            mean += weight * sums.mean();
            squares += weight * sums.squares / sums.count;
            weights += weight;
        }
    }
    mean /= weights;
    return std::max(0.0, squares / weights - dot(mean, mean));
}

/// One line of box_means: `count` values, `step` apart.
void line_means(const double* in, double* out, int count, std::size_t step, int radius) {
    double sum = 0;
    int held = 0;
    for (int i = -radius; i < count; ++i) {
        if (i + radius < count) {
            sum += in[static_cast<std::size_t>(i + radius) * step];
            ++held;
        }
        if (i - radius - 1 >= 0) {
            sum -= in[static_cast<std::size_t>(i - radius - 1) * step];
            --held;
        }
        if (i >= 0) out[static_cast<std::size_t>(i) * step] = std::max(0.0, sum) / held;
    }
}

}  // namespace

std::vector<double> box_means(std::span<const double> values, int width, int height, int radius) {
    std::vector<double> rows(values.size());
    std::vector<double> means(values.size());
    const auto across = static_cast<std::size_t>(width);
    for (int y = 0; y < height; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * across;
        line_means(values.data() + first, rows.data() + first, width, 1, radius);
    }
    for (std::size_t x = 0; x < across; ++x)
        line_means(rows.data() + x, means.data() + x, height, across, radius);
    return means;
}

void Prediction::score(const PictureSamples& samples) {
    scores_.resize(samples.size());
    double total = 0;
    std::size_t pixel = 0;
    for (int y = 0; y < samples.height(); ++y) {
        for (int x = 0; x < samples.width(); ++x, ++pixel) {
            const PixelSums& own = samples.pixels()[pixel];
            const double n = own.count;
            scores_[pixel] = ((n - 1) * own.variance() +
                              neighbor_samples * neighbor_share * variance_around(samples, x, y)) /
                             (n - 1 + neighbor_samples);
            total += scores_[pixel];
        }
    }
    const double mean = total / static_cast<double>(samples.size());
    const std::vector<double> around = box_means(scores_, samples.width(), samples.height(), 3);
    for (pixel = 0; pixel < scores_.size(); ++pixel)
        scores_[pixel] += from_surroundings * around[pixel] + from_everywhere * mean;
}

double Prediction::of(std::size_t pixel, double count) const {
    return kappa * scores_[pixel] / (count * std::sqrt(count));
}

std::vector<double> Prediction::errors(const PictureSamples& samples) const {
    std::vector<double> errors(samples.size());
    for (std::size_t pixel = 0; pixel < errors.size(); ++pixel)
        errors[pixel] = of(pixel, samples.pixels()[pixel].count);
    return errors;
}

double Prediction::mean_square(const PictureSamples& samples) const {
    double sum = 0;
    for (std::size_t pixel = 0; pixel < samples.size(); ++pixel)
        sum += of(pixel, samples.pixels()[pixel].count);
    return sum / (3 * static_cast<double>(samples.size()));
}

}  // namespace lancer::accuracy
