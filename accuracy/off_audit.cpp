#include "accuracy/off_audit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "accuracy/binomial.h"
#include "model/sobol.h"

namespace lancer::accuracy {
namespace {

constexpr std::size_t nets = 8;
constexpr std::uint32_t fewest_points = 16;  // of a net: with 4, thin wires are missed
constexpr std::uint32_t most_first_points = 64;
constexpr std::uint32_t most_points = 512;
constexpr std::uint32_t left_out_points = 4;
// Student's t for 7 degrees of freedom: beyond it lies one pixel in 200 of those that need more.
constexpr double sure = 4.03;
/// Beside the audits' of errors and the measurements of limits, see limits.cpp.
constexpr std::uint64_t stream = std::uint64_t(1) << 63 | std::uint64_t(1) << 61;

/// A drawn pixel, and what its nets have brought.
struct Draw {
    std::size_t pixel;
    std::uint64_t number;
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
void raise(const Truth& truth, const Samples& samples, std::uint64_t audit, std::span<Draw> draws,
           std::uint32_t from, std::uint32_t to, RayCounts& rays) {
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
                    pixel_key(samples.seed(), x, y, stream | audit << 40 | draw.number << 3 | net));
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
std::vector<Draw> drawn(const Samples& samples, const OffPlan& plan) {
    std::vector<Draw> draws;
    for (std::uint64_t k = 0; k < static_cast<std::uint64_t>(plan.draws); ++k) {
        const std::uint64_t bits = samples.key(stream | (plan.number + 1) << 40 | k);
        const double share = static_cast<double>(bits >> 11) * 0x1p-53;
        const auto pixel = static_cast<std::size_t>(share * static_cast<double>(samples.size()));
        draws.push_back({pixel, k});
    }
    std::sort(draws.begin(), draws.end(), [](const Draw& a, const Draw& b) {
        return a.pixel != b.pixel ? a.pixel < b.pixel : a.number < b.number;
    });
    return draws;
}

/// So many points a net that what all miss puts no pixel off: light of 1 in less than 1/n of it
/// adds less than 1/n.
std::uint32_t first_points(double threshold) {
    std::uint32_t points = fewest_points;
    while (points < most_first_points && double(nets) * points * threshold < 1) points *= 2;
    return points;
}

}  // namespace

OffCount count_off(const Truth& truth, const Samples& samples, const OffPlan& plan) {
    std::vector<Draw> open = drawn(samples, plan);
    OffCount count;
    count.draws = open.size();
    std::uint32_t held = 0;
    const std::uint32_t first = first_points(plan.threshold);
    for (std::uint32_t points = first; points <= most_points; points *= 2) {
        raise(truth, samples, plan.number, open, held, points, count.rays);
        held = points;
        std::erase_if(open, [&](const Draw& draw) {
            const Color value = samples.pixels()[draw.pixel].mean();
            const Verdict v = verdict(draw, value, points, plan.threshold);
            if (v == Verdict::off) ++count.off;
            return v != Verdict::undecided;
        });
    }
    count.undecided = open.size();
    return count;
}

OffCount count_left_out(const Truth& truth, const Renderer& renderer, const TraceLimits& limits,
                        const Samples& samples, const OffPlan& plan) {
    std::vector<Draw> whole = drawn(samples, plan);
    std::vector<Draw> cut = whole;
    OffCount count;
    count.draws = whole.size();
    raise(truth, samples, plan.number, whole, 0, left_out_points, count.rays);
    raise({renderer, limits}, samples, plan.number, cut, 0, left_out_points, count.rays);
    for (std::size_t k = 0; k < whole.size(); ++k) {
        Color difference{0, 0, 0};
        for (std::size_t net = 0; net < nets; ++net)
            difference += (whole[k].sums[net] - cut[k].sums[net]) / double(nets * left_out_points);
        for (int c = 0; c < 3; ++c) {
            if (std::abs(difference[c]) <= plan.threshold) continue;
            ++count.off;
            break;
        }
    }
    return count;
}

OffEstimate estimate(const OffCount& count) {
    const double off = static_cast<double>(count.off) + static_cast<double>(count.undecided) / 2;
    return {off / static_cast<double>(count.draws), clopper_pearson(count.off, count.draws).low,
            clopper_pearson(count.off + count.undecided, count.draws).high};
}

}  // namespace lancer::accuracy
