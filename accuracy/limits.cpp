#include "accuracy/limits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/quality.h"
#include "model/sobol.h"

namespace lancer::accuracy {
namespace {

constexpr std::uint64_t limits_stream = 1;  // for keys that belong to no pixel
constexpr std::uint64_t bias_stream = 2;
constexpr std::uint64_t cut_stream = std::uint64_t(3) << 62;  // above the streams of audits

Crop part_of(const View& view) {
    return view.crop.value_or(Crop{0, 0, view.width, view.height});
}

/// Points `begin` to `end` of a sequence that is spread evenly over the picture. They are sorted by
/// bands of 16 rows, which keeps neighbouring rays together.
std::vector<PicturePoint> spread_points(const View& view, std::uint32_t begin, std::uint32_t end,
                                        std::uint64_t seed) {
    const Crop part = part_of(view);
    const SobolPoints sequence(pixel_key(seed, -2, -2, limits_stream));
    std::vector<PicturePoint> points;
    for (std::uint32_t i = begin; i < end; ++i)
        points.push_back(
            {part.x + sequence[i].x * part.width, part.y + sequence[i].y * part.height});
    std::sort(points.begin(), points.end(), [](const PicturePoint& a, const PicturePoint& b) {
        const auto band = [](double y) { return std::floor(y / 16); };
        if (band(a.y) != band(b.y)) return band(a.y) < band(b.y);
        return a.x < b.x;
    });
    return points;
}

/// Measures what limits cut, at points spread over the picture. An eighth of the points is tried
/// first, to rule out limits that cut far too much.
class Cuts {
  public:
    Cuts(const Truth& truth, const View& view, std::uint32_t count, std::uint64_t seed,
         RayCounts& rays)
        : truth_(truth), view_(view), rays_(rays) {
        const std::uint32_t few = count / 8;
        parts_[0].points = spread_points(view, 0, few, seed);
        parts_[1].points = spread_points(view, few, count, seed);
    }

    /// False when there is nothing to cut.
    bool begin(const TraceLimits& whole) {
        RayCounts counted;
        for (Part& part : parts_) part.right = colors(part, whole, counted);
        rays_ += counted;
        return counted.reflected + counted.transmitted > 0;
    }

    /// Whether the mean squared difference, over channels, is at most `mean_square`. It must stay
    /// so with two standard errors added.
    bool are_at_most(double mean_square, const TraceLimits& limits) {
        Difference cut;
        add(cut, parts_[0], limits);
        if (cut.mean() > mean_square) return false;
        add(cut, parts_[1], limits);
        return cut.mean() + 2 * cut.standard_error() <= mean_square;
    }

  private:
    struct Part {
        std::vector<PicturePoint> points;
        std::vector<Color> right;
    };
    struct Difference {
        double count = 0;
        double sum = 0;
        double squares = 0;
        double mean() const { return sum / count; }
        double standard_error() const {
            return std::sqrt(std::max(0.0, squares / count - mean() * mean()) / count);
        }
    };

    std::vector<Color> colors(const Part& part, const TraceLimits& limits, RayCounts& rays) const {
        std::vector<Color> colors(part.points.size());
        truth_.renderer.trace(view_, part.points, limits, colors, {}, rays);
        return colors;
    }

    void add(Difference& cut, const Part& part, const TraceLimits& limits) {
        const std::vector<Color> found = colors(part, limits, rays_);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Color d = found[i] - part.right[i];
            cut.sum += dot(d, d) / 3;
            cut.squares += dot(d, d) / 3 * (dot(d, d) / 3);
        }
        cut.count += static_cast<double>(found.size());
    }

    const Truth& truth_;
    const View& view_;
    std::array<Part, 2> parts_;  ///< a few, and the others
    RayCounts& rays_;
};

}  // namespace

TraceLimits limits_of_truth(double error) {
    return {values_of(Quality::exact).max_depth, error / 100};
}

TraceLimits whole_limits(const Truth& truth, const FixedLimits& fixed) {
    return {fixed.max_depth.value_or(truth.limits.max_depth),
            fixed.min_contribution.value_or(truth.limits.min_contribution)};
}

TraceLimits cheapest_limits(const Truth& truth, const View& view, const FixedLimits& fixed,
                            double mean_square, std::uint64_t seed, RayCounts& rays) {
    TraceLimits best = whole_limits(truth, fixed);
    if (fixed.max_depth && fixed.min_contribution) return best;

    const Crop part = part_of(view);
    const std::int64_t pixels = std::int64_t(part.width) * part.height;
    const auto count = static_cast<std::uint32_t>(std::clamp<std::int64_t>(pixels / 64, 512, 4096));
    Cuts cuts(truth, view, count, seed, rays);
    if (!cuts.begin(best)) return best;

    // The coarsest limits come first. Most limits that cut too much fail at the first eighth of the
    // points; only the others need all points.
    if (!fixed.max_depth) {
        for (const int depth : {1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 48, 64, 128, 256}) {
            if (!cuts.are_at_most(mean_square / 2, {depth, best.min_contribution})) continue;
            best.max_depth = depth;
            break;
        }
    }
    if (!fixed.min_contribution) {
        for (const double factor : {100.0, 50.0, 20.0, 10.0, 5.0, 2.0}) {
            const double least = truth.limits.min_contribution * factor;
            if (!cuts.are_at_most(mean_square, {best.max_depth, least})) continue;
            best.min_contribution = least;
            break;
        }
    }
    return best;
}

ErrorEstimate bias(const Renderer& renderer, const TraceLimits& limits, const Truth& truth,
                   const View& view, std::uint64_t seed, RayCounts& rays) {
    constexpr std::uint32_t draws = 512;
    constexpr std::uint32_t per_net = 8;
    const Crop part = part_of(view);
    const SobolPoints places(pixel_key(seed, -2, -2, bias_stream));
    std::vector<PicturePoint> points;
    for (std::uint32_t k = 0; k < draws; ++k) {
        const int x = part.x + static_cast<int>(places[k].x * part.width);
        const int y = part.y + static_cast<int>(places[k].y * part.height);
        for (const std::uint64_t net : {0U, 1U}) {
            const SobolPoints sequence(
                pixel_key(seed, x, y, std::uint64_t(1) << 63 | std::uint64_t(k) << 1 | net));
            for (std::uint32_t i = 0; i < per_net; ++i)
                points.push_back({x + sequence[i].x, y + sequence[i].y});
        }
    }
    std::vector<Color> ours(points.size());
    std::vector<Color> right(points.size());
    renderer.trace(view, points, limits, ours, {}, rays);
    truth.renderer.trace(view, points, truth.limits, right, {}, rays);
    std::vector<double> terms;
    for (std::size_t at = 0; at < points.size(); at += std::size_t(2) * per_net) {
        std::array<Color, 2> cut{Color{0, 0, 0}, Color{0, 0, 0}};
        for (std::size_t i = 0; i < std::size_t(2) * per_net; ++i)
            cut[i / per_net] += (ours[at + i] - right[at + i]) / static_cast<double>(per_net);
        terms.push_back(dot(cut[0], cut[1]) / 3);
    }
    return estimate(terms);
}

double share_cut(const Truth& truth, const PictureSamples& samples, const TraceLimits& limits,
                 std::span<const PixelShare> pixels, RayCounts& rays) {
    constexpr std::uint32_t per_pixel = 16;
    std::vector<PicturePoint> points;
    for (const PixelShare& p : pixels) {
        const SobolPoints sequence(pixel_key(samples.seed(), p.x, p.y, cut_stream));
        for (std::uint32_t i = 0; i < per_pixel; ++i)
            points.push_back({p.x + sequence[i].x, p.y + sequence[i].y});
    }
    std::vector<Color> ours(points.size());
    std::vector<Color> right(points.size());
    truth.renderer.trace(samples.view(), points, limits, ours, {}, rays);
    truth.renderer.trace(samples.view(), points, truth.limits, right, {}, rays);
    double cut = 0;
    double error = 0;
    std::size_t next = 0;
    for (const PixelShare& p : pixels) {
        Color difference{0, 0, 0};
        Color mean{0, 0, 0};
        for (std::uint32_t i = 0; i < per_pixel; ++i, ++next) {
            difference += (ours[next] - right[next]) / static_cast<double>(per_pixel);
            mean += right[next] / static_cast<double>(per_pixel);
        }
        const Color wrong = samples.pixels()[samples.pixel_at(p.x, p.y)].mean() - mean;
        cut += dot(difference, difference);
        error += dot(wrong, wrong);
    }
    return error > 0 ? cut / error : 0;
}

}  // namespace lancer::accuracy
