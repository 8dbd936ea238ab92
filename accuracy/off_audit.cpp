#include "accuracy/off_audit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "model/sobol.h"

namespace lancer::accuracy {
namespace {

constexpr std::size_t nets = 8;
constexpr std::uint32_t fewest_points = 16;  // per net; nets of 4 miss thin wires
constexpr std::uint32_t most_first_points = 64;
constexpr std::uint32_t most_points = 512;
constexpr std::uint32_t left_out_points = 4;
// Student's t for 7 degrees of freedom, two-sided, with a probability of 1/200 beyond it.
constexpr double sure = 4.03;
/// Different from the streams of error audits and of limits (limits.cpp).
constexpr std::uint64_t stream = std::uint64_t(1) << 63 | std::uint64_t(1) << 61;

/// A drawn pixel and the sums of its nets. A pixel that is drawn several times is traced once,
/// because the same rays would give the same result.
struct Draw {
    std::size_t pixel;
    KindCount* kind;
    std::uint64_t times = 1;
    std::array<Color, nets> sums{};
};

enum class Verdict { near, off, undecided };

Verdict verdict(const Draw& draw, const Color& value, std::uint32_t points, double threshold) {
    bool all_near = true;
    for (int c = 0; c < 3; ++c) {
        double mean = 0;
        for (const Color& sum : draw.sums) mean += sum[c] / points / double(nets);
        double squares = 0;
        for (const Color& sum : draw.sums) {
            const double d = sum[c] / points - mean;
            squares += d * d;
        }
        const double unsure = sure * std::sqrt(squares / double(nets * (nets - 1)));
        const double distance = std::abs(value[c] - mean);
        if (distance - unsure > threshold) return Verdict::off;
        all_near = all_near && distance + unsure <= threshold;
    }
    return all_near ? Verdict::near : Verdict::undecided;
}

/// Raises every net of these draws from so many points to so many.
void raise(const Truth& truth, const PictureSamples& samples, std::uint64_t audit,
           std::span<Draw> draws, std::uint32_t from, std::uint32_t to, RayCounts& rays) {
    const std::size_t batch = std::max<std::size_t>(1, batch_size / (nets * (to - from)));
    std::vector<PicturePoint> points;
    std::vector<Color> colors;
    for (std::size_t begin = 0; begin < draws.size(); begin += batch) {
        const std::span<Draw> part = draws.subspan(begin, std::min(batch, draws.size() - begin));
        points.clear();
        for (const Draw& draw : part) {
            const int x = samples.column(draw.pixel);
            const int y = samples.row(draw.pixel);
            for (std::size_t net = 0; net < nets; ++net) {
                const SobolPoints sequence(
                    pixel_key(samples.seed(), x, y, stream | audit << 40 | net));
                for (std::uint32_t i = from; i < to; ++i)
                    points.push_back({x + sequence[i].x, y + sequence[i].y});
            }
        }
        colors.resize(points.size());
        truth.renderer.trace(samples.view(), points, truth.limits, colors, {}, rays);
        std::size_t next = 0;
        for (Draw& draw : part)
            for (Color& sum : draw.sums)
                for (std::uint32_t i = from; i < to; ++i) sum += colors[next++];
    }
}

/// Independent draws in the picture's order, which keeps neighbouring rays together.
std::vector<Draw> drawn(const PictureSamples& samples, const OffPlan& plan, OffCount& count) {
    std::vector<Draw> draws;
    std::uint64_t number = 0;
    const auto draw = [&](const std::vector<std::size_t>& pixels, std::uint64_t times,
                          KindCount& kind) {
        kind.pixels = pixels.size();
        if (pixels.empty()) return;
        kind.draws = times;
        for (std::uint64_t k = 0; k < times; ++k) {
            const std::uint64_t bits = samples.key(stream | (plan.number + 1) << 40 | number++);
            const double share = static_cast<double>(bits >> 11) * 0x1p-53;
            const auto place = static_cast<std::size_t>(share * static_cast<double>(pixels.size()));
            draws.push_back({pixels[place], &kind});
        }
    };
    draw(plan.calm, plan.calm_draws, count.calm);
    draw(plan.risky, plan.risky_draws, count.risky);
    count.step = plan.step;
    std::sort(draws.begin(), draws.end(),
              [](const Draw& a, const Draw& b) { return a.pixel < b.pixel; });
    std::vector<Draw> pixels;
    for (const Draw& d : draws) {
        if (!pixels.empty() && pixels.back().pixel == d.pixel)
            ++pixels.back().times;
        else
            pixels.push_back(d);
    }
    return pixels;
}

/// Enough points per net that a feature which all nets miss does not put a pixel off: with n points
/// in all, such a feature covers less than about 1/n of the pixel, and light of 1 there adds less
/// than 1/n.
std::uint32_t first_points(double threshold) {
    std::uint32_t points = fewest_points;
    while (points < most_first_points && double(nets) * points * threshold < 1) points *= 2;
    return points;
}

}  // namespace

OffCount count_off(const Truth& truth, const PictureSamples& samples, const OffPlan& plan) {
    OffCount count;
    std::vector<Draw> open = drawn(samples, plan, count);
    std::uint32_t held = 0;
    const std::uint32_t first = first_points(plan.threshold);
    for (std::uint32_t points = first; points <= most_points; points *= 2) {
        raise(truth, samples, plan.number, open, held, points, count.rays);
        held = points;
        std::erase_if(open, [&](const Draw& draw) {
            const Color value = samples.pixels()[draw.pixel].mean();
            const Verdict v = verdict(draw, value, points, plan.threshold);
            if (v == Verdict::off) draw.kind->off += draw.times;
            return v != Verdict::undecided;
        });
    }
    for (const Draw& draw : open) draw.kind->undecided += draw.times;
    return count;
}

OffCount count_left_out(const Truth& truth, const Renderer& renderer, const TraceLimits& limits,
                        const PictureSamples& samples, const OffPlan& plan) {
    OffCount count;
    std::vector<Draw> whole = drawn(samples, plan, count);
    std::vector<Draw> cut = whole;
    raise(truth, samples, plan.number, whole, 0, left_out_points, count.rays);
    raise({renderer, limits}, samples, plan.number, cut, 0, left_out_points, count.rays);
    for (std::size_t k = 0; k < whole.size(); ++k) {
        Color difference{0, 0, 0};
        for (std::size_t net = 0; net < nets; ++net)
            difference += (whole[k].sums[net] - cut[k].sums[net]) / double(nets * left_out_points);
        for (int c = 0; c < 3; ++c) {
            if (std::abs(difference[c]) <= plan.threshold) continue;
            whole[k].kind->off += whole[k].times;
            break;
        }
    }
    return count;
}

void KindCount::add(const KindCount& other) {
    pixels += other.pixels;
    draws += other.draws;
    off += other.off;
    undecided += other.undecided;
}

double KindCount::share() const {
    if (draws == 0) return 0;
    return (static_cast<double>(off) + static_cast<double>(undecided) / 2) /
           static_cast<double>(draws);
}

std::uint64_t OffCount::most() const {
    return least() + step * calm.undecided + risky.undecided;
}

double share_of(const OffCount& count) {
    return (static_cast<double>(count.calm.pixels) * count.calm.share() +
            static_cast<double>(count.risky.pixels) * count.risky.share()) /
           count.pixels();
}

OffEstimate estimate(const OffCount& count) {
    const double calm = static_cast<double>(count.calm.pixels) / count.pixels();
    const double risky = static_cast<double>(count.risky.pixels) / count.pixels();
    const TwoKinds kinds{{calm, count.calm.draws}, {risky, count.risky.draws}, count.step, true};
    return {share_of(count), lower_share(kinds, count.least()), upper_share(kinds, count.most())};
}

}  // namespace lancer::accuracy
