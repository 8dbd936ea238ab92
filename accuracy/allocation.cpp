#include "accuracy/allocation.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "model/elementary.h"

namespace lancer::accuracy {
namespace {

/// The best numbers of samples n. For a given sum of n, the sum of kappa c n^-1.5 over all pixels
/// is least where n is proportional to (kappa c)^0.4.
class Spread {
  public:
    Spread(const PictureSamples& samples, const Prediction& prediction) : samples_(samples) {
        share_.reserve(samples.size());
        kept_.reserve(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double score = prediction.kappa * prediction.scores()[i];
            share_.push_back(score > 0 ? elementary::pow(score, 0.4) : 0);
            kept_.push_back(prediction.of(i, samples.pixels()[i].count));
        }
    }

    double wanted(std::size_t pixel, double factor) const { return share_[pixel] * factor; }

    /// The squared error, summed over pixels and channels, and the number of samples.
    struct Sums {
        double error = 0;
        double rays = 0;
    };
    Sums sums(double factor) const {
        Sums sums;
        const double per_share = 1 / (factor * std::sqrt(factor));
        for (std::size_t i = 0; i < share_.size(); ++i) {
            const double n = wanted(i, factor);
            const bool more = n > samples_.pixels()[i].count;
            sums.rays += more ? n : samples_.pixels()[i].count;
            // kappa c is share^2.5, so kappa c n^-1.5 is share * factor^-1.5.
            sums.error += more ? share_[i] * per_share : kept_[i];
        }
        return sums;
    }

    /// The smallest factor for which `reached(sums)` holds; it holds for all larger ones.
    double factor(const std::function<bool(const Sums&)>& reached) const {
        double low = -60;  // exponents of two, far outside of what any picture needs
        double high = 60;
        for (int step = 0; step < 40; ++step) {
            const double middle = (low + high) / 2;
            (reached(sums(elementary::pow(2.0, middle))) ? high : low) = middle;
        }
        return elementary::pow(2.0, high);
    }

  private:
    const PictureSamples& samples_;
    std::vector<double> share_;
    std::vector<double> kept_;
};

/// Twice as many where the want is nearest to it; all others keep theirs.
std::vector<std::uint32_t> doubled(const PictureSamples& samples, const Spread& spread,
                                   double factor) {
    std::vector<std::uint32_t> counts(samples.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const std::uint32_t n = samples.pixels()[i].count;
        const bool more = spread.wanted(i, factor) >= n * std::sqrt(2.0) && n < most_per_pixel;
        counts[i] = more ? 2 * n : n;
    }
    return counts;
}

/// When no pixel wants twice as many: the hundredth part whose doubling brings most a ray.
std::vector<std::uint32_t> best_doubled(const PictureSamples& samples,
                                        const Prediction& prediction) {
    std::vector<std::uint32_t> counts(samples.size());
    std::vector<double> gains(samples.size());
    for (std::size_t i = 0; i < gains.size(); ++i) {
        counts[i] = samples.pixels()[i].count;
        gains[i] = counts[i] < most_per_pixel ? prediction.of(i, counts[i]) / counts[i] : 0;
    }
    std::vector<double> order = gains;
    const auto last = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 100);
    std::nth_element(order.begin(), last, order.end(), std::greater<>());
    for (std::size_t i = 0; i < gains.size(); ++i)
        if (gains[i] > 0 && gains[i] >= *last) counts[i] *= 2;
    return counts;
}

std::uint64_t sum(const std::vector<std::uint32_t>& counts) {
    std::uint64_t total = 0;
    for (const std::uint32_t n : counts) total += n;
    return total;
}

double values(const PictureSamples& samples) {
    return 3 * static_cast<double>(samples.size());
}

}  // namespace

double rays_for(const PictureSamples& samples, const Prediction& prediction, double mean_square) {
    const Spread spread(samples, prediction);
    const double most = mean_square * values(samples);
    const double factor = spread.factor([&](const Spread::Sums& s) { return s.error <= most; });
    return spread.sums(factor).rays / static_cast<double>(samples.size());
}

double mean_square_for(const PictureSamples& samples, const Prediction& prediction,
                       double rays_per_pixel) {
    const Spread spread(samples, prediction);
    const double rays = rays_per_pixel * static_cast<double>(samples.size());
    const double factor = spread.factor([&](const Spread::Sums& s) { return s.rays >= rays; });
    return spread.sums(factor).error / values(samples);
}

bool refine(PictureSamples& samples, Prediction& prediction, double mean_square,
            std::uint64_t most_rays, const Progress& progress) {
    const double most = mean_square * values(samples);
    for (;;) {
        prediction.score(samples);
        if (prediction.mean_square(samples) <= mean_square) return true;
        const Spread spread(samples, prediction);
        const double factor = spread.factor([&](const Spread::Sums& s) { return s.error <= most; });
        const std::uint64_t before = samples.rays().primary;
        std::vector<std::uint32_t> counts = doubled(samples, spread, factor);
        std::uint64_t held = 0;
        for (const PixelSums& sums : samples.pixels()) held += sums.count;
        if (sum(counts) == held) counts = best_doubled(samples, prediction);
        const std::uint64_t more = sum(counts) - held;
        if (more == 0 || before + more > most_rays) return false;
        samples.raise(counts, progress);
    }
}

}  // namespace lancer::accuracy
