#include "accuracy/off_allocation.h"

#include <algorithm>
#include <numeric>
#include <queue>

#include "accuracy/allocation.h"
#include "model/elementary.h"

namespace lancer::accuracy {
namespace {

constexpr double from_neighbors = 0.05;  // of the mean risk around a pixel
constexpr int most_doublings = 8;        // looked ahead: the first may gain nothing, the third much

/// The probability that a pixel with this mean squared error, summed over channels, is off. A grey
/// error lies in three channels and a coloured one may lie in a single one. The formula is that of
/// two channels: the length of a normal error of two components is Rayleigh distributed.
double chance_off(double error, double threshold) {
    if (error <= 0) return 0;
    return elementary::exp(-threshold * threshold / error);
}

/// An increase of one pixel's samples: the one that gains most per ray.
struct Step {
    std::size_t pixel = 0;
    std::uint32_t count = 0;  ///< samples after the step
    double gain = 0;          ///< decrease of the probability that the pixel is off
    double per_ray = 0;

    bool operator<(const Step& other) const {
        return per_ray != other.per_ray ? per_ray < other.per_ray : pixel > other.pixel;
    }
};

Step best_step(const Prediction& prediction, std::size_t pixel, std::uint32_t count,
               double threshold) {
    Step best;
    const double now = chance_off(prediction.of(pixel, count), threshold);
    std::uint32_t next = count;
    for (int k = 0; k < most_doublings && next < most_per_pixel; ++k) {
        next *= 2;
        const double gain = now - chance_off(prediction.of(pixel, next), threshold);
        const double per_ray = gain / (next - count);
        if (per_ray > best.per_ray) best = {pixel, next, gain, per_ray};
    }
    return best;
}

}  // namespace

double predicted_off(const PictureSamples& samples, const Prediction& prediction,
                     double threshold) {
    double sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
        sum += chance_off(prediction.of(i, samples.pixels()[i].count), threshold);
    return sum / static_cast<double>(samples.size());
}

PixelKinds kinds_of(const PictureSamples& samples, const Prediction& prediction, double threshold,
                    double calm_share) {
    std::vector<double> risks(samples.size());
    for (std::size_t i = 0; i < risks.size(); ++i)
        risks[i] = chance_off(prediction.of(i, samples.pixels()[i].count), threshold);
    const std::vector<double> around = box_means(risks, samples.width(), samples.height(), 3);
    for (std::size_t i = 0; i < risks.size(); ++i)
        risks[i] = std::max(risks[i], from_neighbors * around[i]);
    std::vector<std::size_t> order(risks.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return risks[a] < risks[b]; });
    double left = calm_share * static_cast<double>(risks.size());
    std::size_t calm = 0;
    while (calm < order.size() && risks[order[calm]] <= left) left -= risks[order[calm++]];
    const auto end = order.begin() + static_cast<std::ptrdiff_t>(calm);
    return {{order.begin(), end}, {end, order.end()}};
}

OffAllocation allocation_for(const PictureSamples& samples, const Prediction& prediction,
                             double threshold, double share, double most_rays) {
    const double pixels = static_cast<double>(samples.size());
    OffAllocation result;
    double off = predicted_off(samples, prediction, threshold) * pixels;
    std::vector<Step> steps;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::uint32_t n = samples.pixels()[i].count;
        result.counts.push_back(n);
        result.rays += n;
        const Step step = best_step(prediction, i, n, threshold);
        if (step.gain > 1e-3 * share) steps.push_back(step);
    }
    std::priority_queue<Step> queue({}, std::move(steps));
    while (off > share * pixels && !queue.empty()) {
        const Step step = queue.top();
        queue.pop();
        std::uint32_t& n = result.counts[step.pixel];
        if (result.rays + (step.count - n) > most_rays) break;
        result.rays += step.count - n;
        off -= step.gain;
        n = step.count;
        const Step next = best_step(prediction, step.pixel, n, threshold);
        if (next.gain > 1e-3 * share) queue.push(next);
    }
    result.share = off / pixels;
    return result;
}

bool refine_off(PictureSamples& samples, Prediction& prediction, double threshold, double share,
                std::uint64_t most_rays, const Progress& progress) {
    for (;;) {
        prediction.score(samples);
        if (predicted_off(samples, prediction, threshold) <= share) return true;
        OffAllocation wanted =
            allocation_for(samples, prediction, threshold, share, static_cast<double>(most_rays));
        if (wanted.share > share) return false;
        // One doubling at a time: its samples may show that the next one is not needed.
        for (std::size_t i = 0; i < wanted.counts.size(); ++i)
            wanted.counts[i] = std::min(wanted.counts[i], 2 * samples.pixels()[i].count);
        samples.raise(wanted.counts, progress);
    }
}

}  // namespace lancer::accuracy
