#include "accuracy/audit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/elementary.h"
#include "model/sobol.h"

namespace lancer::accuracy {
namespace {

constexpr std::uint32_t fewest_points = 16;  // of a net: with 8, printed intervals can be wide
constexpr double two_sided_95 = 1.96;

/// Systematic sampling: the pixels are intervals of length `chance`, end to end. The draws are
/// equally spaced points on them, from a random start.
std::vector<std::size_t> systematic(const std::vector<double>& chance, int draws, double start) {
    std::vector<std::size_t> drawn;
    double sum = 0;
    double total = 0;
    for (const double c : chance) total += c;
    std::size_t pixel = 0;
    for (int k = 0; k < draws; ++k) {
        const double at = (k + start) / draws * total;
        while (pixel + 1 < chance.size() && sum + chance[pixel] <= at) sum += chance[pixel++];
        drawn.push_back(pixel);
    }
    return drawn;
}

/// The stream of random points of one net. Different audits, draws and nets have different streams.
/// Stream 0 belongs to the picture.
std::uint64_t stream_of(std::uint64_t audit, std::size_t draw, unsigned net) {
    return (audit + 1) << 40 | static_cast<std::uint64_t>(draw) << 1 | net;
}

struct Net {
    std::size_t draw;
    std::uint32_t points;
};

/// The variance of the mean of a stratum's terms.
double variance_of_mean(const Stratum& s) {
    TermSums both = s.terms;
    both.add(s.earlier);
    const double mean = s.terms.mean();
    if (mean <= 0 || both.mean() <= 0) return s.terms.variance() / s.terms.count;
    // An audit that decided to stop is more likely to have low terms, and these have a low
    // variance. So the variance of `terms` alone counts where it is larger.
    const double relative =
        std::max(both.variance() / (both.mean() * both.mean()), s.terms.variance() / (mean * mean));
    return mean * mean * relative / s.terms.count;
}

void add_interval(ErrorEstimate& e) {
    if (e.mean_square <= 0) return;
    e.rmse = std::sqrt(e.mean_square);
    const double factor = elementary::exp(two_sided_95 * e.log_error() / 2);
    e.low = e.rmse / factor;
    e.high = e.rmse * factor;
}

}  // namespace

Audit audit(const Truth& truth, const PictureSamples& samples, std::span<const double> predicted,
            const AuditPlan& plan, const Progress& progress) {
    const DrawGuesses guessed(predicted, samples.width(), samples.height());
    const std::vector<double> chance = guessed.mixed(plan.shares);
    const double start = SobolPoints(samples.key(plan.number + 1))[0].x;
    Audit result;
    result.pixels = systematic(chance, plan.draws, start);
    std::vector<Color> nets(result.pixels.size() * 2, Color{0, 0, 0});
    std::vector<Net> batch;
    std::vector<PicturePoint> points;
    std::vector<Color> colors;
    for (std::size_t k = 0; k < result.pixels.size(); ++k) {
        const std::size_t pixel = result.pixels[k];
        const std::uint32_t n = std::max(fewest_points, samples.pixels()[pixel].count);
        const int x = samples.column(pixel);
        const int y = samples.row(pixel);
        for (const unsigned net : {0U, 1U}) {
            const SobolPoints sequence(
                pixel_key(samples.seed(), x, y, stream_of(plan.number, k, net)));
            for (std::uint32_t i = 0; i < n; ++i)
                points.push_back({x + sequence[i].x, y + sequence[i].y});
            batch.push_back({2 * k + net, n});
        }
        if (points.size() < batch_size && k + 1 < result.pixels.size()) continue;
        colors.resize(points.size());
        truth.renderer.trace(samples.view(), points, truth.limits, colors, {}, result.rays);
        std::size_t next = 0;
        for (const Net& net : batch) {
            for (std::uint32_t i = 0; i < net.points; ++i) nets[net.draw] += colors[next++];
            nets[net.draw] /= static_cast<double>(net.points);
        }
        batch.clear();
        points.clear();
        if (progress)
            progress(static_cast<double>(k + 1) / static_cast<double>(result.pixels.size()));
    }
    const double values = 3 * static_cast<double>(samples.size());
    for (std::size_t k = 0; k < result.pixels.size(); ++k) {
        const std::size_t pixel = result.pixels[k];
        const Color mean = samples.pixels()[pixel].mean();
        const double product = dot(mean - nets[2 * k], mean - nets[2 * k + 1]);
        result.terms.push_back(product / (chance[pixel] * values));
        result.seen.push_back({guessed.of(pixel), chance[pixel], product});
    }
    return result;
}

void Audit::add(const Audit& other) {
    terms.insert(terms.end(), other.terms.begin(), other.terms.end());
    pixels.insert(pixels.end(), other.pixels.begin(), other.pixels.end());
    seen.insert(seen.end(), other.seen.begin(), other.seen.end());
    rays += other.rays;
}

void TermSums::add(std::span<const double> terms) {
    count += static_cast<double>(terms.size());
    for (const double t : terms) {
        sum += t;
        squares += t * t;
    }
}

void TermSums::add(const TermSums& others) {
    count += others.count;
    sum += others.sum;
    squares += others.squares;
}

double TermSums::variance() const {
    return std::max(0.0, squares / count - mean() * mean()) * count / (count - 1);
}

bool TermSums::are_zero() const {
    constexpr double rounding = 1e-26;  // above the squared rounding error of a sum of colours
    return squares <= rounding * rounding * count;
}

ErrorEstimate estimate_of_strata(std::span<const Stratum> strata) {
    ErrorEstimate e;
    double variance = 0;
    double squares = 0;
    e.all_zero = std::all_of(strata.begin(), strata.end(),
                             [](const Stratum& s) { return s.terms.are_zero(); });
    const bool is_enough = std::all_of(strata.begin(), strata.end(),
                                       [](const Stratum& s) { return s.terms.count >= 2; });
    if (e.all_zero || !is_enough) return e;
    for (const Stratum& s : strata) {
        e.mean_square += s.weight * s.terms.mean();
        variance += s.weight * s.weight * variance_of_mean(s);
        squares += s.weight * s.weight * s.terms.squares / (s.terms.count * s.terms.count);
    }
    e.standard_error = std::sqrt(variance);
    e.effective_draws = e.mean_square * e.mean_square / squares;
    add_interval(e);
    return e;
}

ErrorEstimate estimate(std::span<const double> terms) {
    return estimate(terms, {});
}

ErrorEstimate estimate(std::span<const double> terms, std::span<const double> earlier) {
    const Stratum all{1, TermSums(terms), TermSums(earlier)};
    return estimate_of_strata({&all, 1});
}

std::vector<PixelShare> dominant_pixels(const Audit& audit, const PictureSamples& samples,
                                        std::size_t most) {
    std::map<std::size_t, double> of_pixel;
    double total = 0;
    for (std::size_t k = 0; k < audit.terms.size(); ++k) {
        of_pixel[audit.pixels[k]] += audit.terms[k] * audit.terms[k];
        total += audit.terms[k] * audit.terms[k];
    }
    std::vector<PixelShare> shares;
    for (const auto& [pixel, squares] : of_pixel)
        if (squares > 0)
            shares.push_back({samples.column(pixel), samples.row(pixel), squares / total});
    std::stable_sort(shares.begin(), shares.end(),
                     [](const PixelShare& a, const PixelShare& b) { return a.share > b.share; });
    shares.resize(std::min(shares.size(), most));
    return shares;
}

}  // namespace lancer::accuracy
