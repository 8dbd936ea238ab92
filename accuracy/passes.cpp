#include "accuracy/passes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "accuracy/draw_shares.h"
#include "accuracy/rare_light.h"

namespace lancer::accuracy {
namespace {

constexpr int parts = 8;  // of the second sample
constexpr double shown = 1.0 / 65535 / 4;
constexpr int deciding_draws = 500;
constexpr int printed_draws = 1000;
// Thresholds for the deciding audit. The printed audit has twice as many draws: it then has about
// 60 effective ones and an interval with a half-width of 20 %.
constexpr double least_effective = 30;
constexpr double most_log_error = 0.28;
/// The RMSE that the limits of recursion may cause; it is hardly visible.
constexpr double cut_error = 0.002;

std::uint64_t sum(const std::vector<std::uint32_t>& counts) {
    std::uint64_t total = 0;
    for (const std::uint32_t n : counts) total += n;
    return total;
}

/// One audit that decides whether the error is told, and one that is printed.
void tell(const Truth& truth, const PictureSamples& samples, const Prediction& prediction,
          const RareLight& rare, ErrorReport& report) {
    report.audited = true;
    const std::vector<double> predicted = prediction.errors(samples);
    const Audit judge = audit(truth, samples, predicted, {deciding_draws, 0}, {});
    report.deciding += judge.rays;
    const ErrorEstimate judged = estimate(judge.terms);
    report.effective_draws = judged.effective_draws * printed_draws / deciding_draws;
    report.dominant = dominant_pixels(judge, samples, 3);
    const Specks missed = rare.missed(samples);
    if (missed.forbid(std::max(judged.rmse, shown), static_cast<double>(samples.size()))) {
        report.rare_light = true;
        report.dominant = missed.pixels;
        return;
    }
    report.is_told =
        judged.effective_draws >= least_effective && judged.log_error() <= most_log_error;
    if (!report.is_told && !judged.all_zero) return;
    const Audit last = audit(truth, samples, predicted, {printed_draws, 1}, {});
    report.printed += last.rays;
    report.error = estimate(last.terms, judge.terms);
}

}  // namespace

void Passes::plan() {
    prediction_.score(samples_);
    if (prediction_.mean_square(samples_) <= shown * shown) return;
    const DrawGuesses places(prediction_.errors(samples_), samples_.width(), samples_.height());
    const std::vector<double> chances = places.mixed(first_shares);
    std::vector<double> gains(samples_.size());
    rays_per_draw_ = 0;
    double held = 0;
    for (std::size_t i = 0; i < gains.size(); ++i) {
        const std::uint32_t n = samples_.pixels()[i].count;
        gains[i] = n < (1U << 14) ? prediction_.of(i, n) / n : 0;
        rays_per_draw_ += 2 * chances[i] * std::max(16U, n);
        held += n;
    }
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < gains.size(); ++i)
        if (gains[i] > 0) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return gains[a] > gains[b]; });
    const double enough = std::max(static_cast<double>(gains.size()) / 4, held / 10);
    double rays = 0;
    for (const std::size_t pixel : order) {
        if (rays >= enough) break;
        planned_.push_back(pixel);
        rays += samples_.pixels()[pixel].count;
    }
    std::reverse(planned_.begin(), planned_.end());
}

std::vector<std::uint32_t> Passes::next() {
    std::vector<std::uint32_t> counts(samples_.size(), 1);
    if (made_ > 0) {
        const auto width = static_cast<std::size_t>(samples_.width());
        std::size_t held = 0;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            counts[i] = samples_.pixels()[i].count;
            held += counts[i];
            const auto part = static_cast<int>((i % width + 3 * (i / width)) % parts);
            if (made_ <= parts && part == 3 * (made_ - 1) % parts) counts[i] = 2;
        }
        if (made_ > parts) {
            if (planned_.empty()) plan();
            if (planned_.empty()) return {};
            const double enough =
                std::max(static_cast<double>(counts.size()) / 32, static_cast<double>(held) / 50);
            for (double rays = 0; rays < enough && !planned_.empty(); planned_.pop_back()) {
                rays += counts[planned_.back()];
                counts[planned_.back()] *= 2;
            }
        }
    }
    ++made_;
    return counts;
}

ErrorPicture render_by_passes(const Renderer& renderer, const Truth& truth, const View& view,
                              const PassGoal& goal, const GoOn& go_on) {
    ErrorReport report;
    report.limits =
        cheapest_limits(truth, view, goal.fixed, cut_error * cut_error, goal.seed, report.deciding);
    PictureSamples samples(renderer, view, report.limits, goal.seed);
    Passes passes(samples);
    std::optional<RareLight> rare;
    for (;;) {
        const int made = passes.made();
        const std::vector<std::uint32_t> counts = passes.next();
        if (counts.empty()) break;
        const std::uint64_t held = samples.rays().primary;
        const double audits = (deciding_draws + printed_draws) * passes.rays_per_draw();
        if (!go_on({made, samples, held + report.deciding.primary, sum(counts) - held,
                    goal.audited ? static_cast<std::uint64_t>(audits) : 0}) &&
            made > 0)
            break;
        samples.raise(counts, {});
        report.passes = passes.made();
        if (report.passes == 1 || report.passes == 1 + parts) rare.emplace(samples);
    }
    Prediction prediction;
    prediction.score(samples);
    if (goal.audited) tell(truth, samples, prediction, *rare, report);
    return finished(samples, prediction, report);
}

}  // namespace lancer::accuracy
