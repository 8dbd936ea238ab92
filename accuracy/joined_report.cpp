#include "accuracy/joined_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "accuracy/strata.h"
#include "model/elementary.h"

namespace lancer::accuracy {
namespace {

constexpr std::size_t named_pixels = 3;

double pixels_of(std::span<const ErrorSums> parts) {
    double pixels = 0;
    for (const ErrorSums& part : parts) pixels += part.pixels;
    return pixels;
}

void keep_largest(std::vector<PixelShare>& pixels, double total) {
    std::stable_sort(pixels.begin(), pixels.end(),
                     [](const PixelShare& a, const PixelShare& b) { return a.share > b.share; });
    pixels.resize(std::min(pixels.size(), named_pixels));
    if (total > 0)
        for (PixelShare& p : pixels) p.share /= total;
}

Specks all_specks(std::span<const ErrorSums> parts) {
    Specks all;
    for (const ErrorSums& part : parts) {
        all.error += part.specks.error;
        all.squares += part.specks.squares;
        for (PixelShare p : part.specks.pixels) {
            p.share *= part.specks.error;
            all.pixels.push_back(p);
        }
    }
    keep_largest(all.pixels, all.error);
    return all;
}

/// The pixels that contribute most to the audits' result. A part's shares are weighted by the
/// part's contribution to the sum of squared terms, where each term has the stratum's weight
/// divided by its number of draws.
std::vector<PixelShare> all_dominant(std::span<const ErrorSums> parts, bool printed) {
    const double pixels = pixels_of(parts);
    std::vector<PixelShare> dominant;
    double total = 0;
    for (const ErrorSums& part : parts) {
        const TermSums& sums = printed ? part.printed : part.deciding;
        const double weight = part.pixels / pixels / sums.count;
        total += weight * weight * sums.squares;
        if (part.deciding.are_zero() != printed) continue;  // its pixels are of the other audit
        for (PixelShare p : part.dominant) {
            p.share *= weight * weight * sums.squares;
            dominant.push_back(p);
        }
    }
    keep_largest(dominant, total);
    return dominant;
}

/// The expected standard error of the logarithm of the printed audits' mean square, from the
/// deciding audits.
double expected_log_error(std::span<const ErrorSums> parts, double mean_square) {
    const double pixels = pixels_of(parts);
    double variance = 0;
    for (const ErrorSums& part : parts) {
        const double weight = part.pixels / pixels;
        variance += weight * weight * part.deciding.variance() / part.printed.count;
    }
    return std::sqrt(variance) / mean_square;
}

/// The contribution to the picture's predicted RMSE of the parts where no draw found a difference.
double unfound(std::span<const ErrorSums> parts) {
    double sum = 0;
    for (const ErrorSums& part : parts)
        if (part.deciding.are_zero() && part.printed.are_zero()) sum += part.predicted;
    return std::sqrt(sum / (3 * pixels_of(parts)));
}

void tell_error(ErrorReport& report, std::span<const ErrorSums> parts) {
    const double pixels = pixels_of(parts);
    const Specks specks = all_specks(parts);
    report.rare_light =
        specks.forbid(report.asked, pixels) ||
        std::any_of(parts.begin(), parts.end(), [](const ErrorSums& p) { return p.rare_light; });
    if (report.rare_light) {
        report.dominant = specks.pixels;
        return;
    }
    std::vector<Stratum> deciding;
    std::vector<Stratum> printed;
    for (const ErrorSums& part : parts) {
        deciding.push_back({part.pixels / pixels, part.deciding, {}});
        printed.push_back({part.pixels / pixels, part.printed, part.deciding});
    }
    const ErrorEstimate judged = estimate_of_strata(deciding);
    report.effective_draws = judged.effective_draws;
    constexpr double rounding = 1.001;  // numbers of draws are rounded
    report.is_told = judged.effective_draws >= least_effective_draws && judged.mean_square > 0 &&
                     expected_log_error(parts, judged.mean_square) <= told_log_error * rounding &&
                     unfound(parts) <= nearly_none * report.asked;
    if (report.is_told || judged.all_zero) report.error = estimate_of_strata(printed);
    if (judged.all_zero) report.effective_draws = report.error.effective_draws;
    report.dominant = all_dominant(parts, judged.all_zero);
}

/// Bounds on a kind's weight w: its pixels off, as a share of the picture, are w times the mean
/// probability of its draws. w is not known exactly when parts have different numbers of draws per
/// pixel, because most pixels off may lie in a part with few.
struct Weights {
    double least = HUGE_VAL;
    double most = 0;
};
Weights weights_of(std::span<const ErrorSums> parts, const KindCount OffCount::*kind,
                   const KindCount& all) {
    if (all.pixels == 0) return {0, 0};
    Weights weights;
    for (const ErrorSums& part : parts) {
        const KindCount& count = part.off->printed.*kind;
        if (count.pixels == 0) continue;
        const double a_draw = static_cast<double>(count.pixels) / static_cast<double>(count.draws) *
                              static_cast<double>(all.draws) / pixels_of(parts);
        weights.most = std::max(weights.most, a_draw);
        weights.least = std::min(weights.least, a_draw);
    }
    return weights;
}

/// The parts have nearly equal numbers of draws per pixel of a kind. So the draws that are off are
/// counted over all parts.
void tell_off(OffReport& off, std::span<const ErrorSums> parts) {
    const double pixels = pixels_of(parts);
    OffCount all;
    off.estimate = {0, 0, 1};
    for (const ErrorSums& part : parts) {
        const OffCount& count = part.off->printed;
        all.calm.add(count.calm);
        all.risky.add(count.risky);
        all.step = std::max(all.step, count.step);
        off.estimate.share += part.pixels / pixels * share_of(count);
    }
    const Weights calm = weights_of(parts, &OffCount::calm, all.calm);
    const Weights risky = weights_of(parts, &OffCount::risky, all.risky);
    const bool alike = parts.size() == 1;
    off.estimate.low =
        lower_share({{calm.least, all.calm.draws}, {risky.least, all.risky.draws}, all.step, alike},
                    all.least());
    off.estimate.high = upper_share(
        {{calm.most, all.calm.draws}, {risky.most, all.risky.draws}, all.step, alike}, all.most());
}

}  // namespace

void tell_costs(ErrorReport& report, std::span<const ErrorSums> parts) {
    const double pixels = pixels_of(parts);
    double predicted = 0;
    double scores = 0;
    report.picture = report.deciding = report.printed = {};
    for (const ErrorSums& part : parts) {
        predicted += part.predicted;
        scores += part.scores;
        report.picture += part.picture;
        report.deciding += part.deciding_rays;
        report.printed += part.printed_rays;
    }
    report.predicted = std::sqrt(predicted / (3 * pixels));
    report.rays_per_pixel = static_cast<double>(report.picture.primary) / pixels;
    if (predicted > 0) report.even_rays_per_pixel = elementary::pow(scores / predicted, 2.0 / 3);
}

ErrorReport joined_report(std::span<const ErrorSums> parts) {
    const ErrorSums& first = parts.front();
    ErrorReport report;
    report.asked = first.asked;
    report.audited = first.audited;
    tell_costs(report, parts);
    if (first.off) {
        report.off.emplace();
        report.off->asked = first.off->asked;
        report.off->steps = first.off->steps;
        for (const ErrorSums& part : parts)
            report.off->predicted += part.off->predicted / pixels_of(parts);
        if (report.audited) tell_off(*report.off, parts);
    } else if (report.audited) {
        tell_error(report, parts);
    }
    return report;
}

}  // namespace lancer::accuracy
