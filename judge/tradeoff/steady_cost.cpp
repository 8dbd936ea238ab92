#include "judge/tradeoff/steady_cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace lancer::judge {
namespace {

constexpr double least_seconds = 1e-6;  // the resolution of the clock
// of a run, as a logarithm; used when single runs show no noise
constexpr double unknown_noise = 0.2;
// of the standard errors, for normally distributed values
constexpr double median_over_mean = 1.25;
constexpr double two_sided_95 = 1.96;
// In standard errors. There are many settings: with a limit of two, one in fifty would seem
// different by chance.
constexpr double sure = 3;
constexpr double least_factor = 0.05;  // of a way, as a logarithm; smaller ones count as none
constexpr double of_a_shadow = 0.5;    // cost of a shadow ray in rays

double counted(const RayCounts& rays) {
    return static_cast<double>(rays.primary + rays.reflected + rays.transmitted) +
           of_a_shadow * static_cast<double>(rays.shadow);
}

/// Other work on the machine can only add to a time, so low quantiles are the best estimate.
double quiet_seconds(const TimedSetting& setting) {
    return std::max(least_seconds, quantile_of(setting.seconds, 0.25));
}

double median_seconds(const TimedSetting& setting) {
    return std::max(least_seconds, median_of(setting.seconds));
}

double standard_error(double noise, std::size_t runs) {
    return median_over_mean * noise / std::sqrt(static_cast<double>(runs));
}

/// What costs: a picture, a step of depth, a ray.
using Row = std::array<double, 3>;

Row row_of(const TimedSetting& setting) {
    return {1, static_cast<double>(setting.max_depth), counted(setting.rays)};
}

double dot(const Row& a, const Row& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The costs, none below 0, with which the rows come as close to 1 as possible. Rows with large
/// deviations get a small weight, so that a few slow runs have little influence.
Row fitted(const std::vector<Row>& rows) {
    Row costs{};
    std::vector<double> weights(rows.size(), 1);
    for (int round = 0; round < 10; ++round) {
        for (int step = 0; step < 300; ++step) {  // coordinate descent
            for (std::size_t k = 0; k < costs.size(); ++k) {
                double wanted = 0;
                double squares = 0;
                for (std::size_t i = 0; i < rows.size(); ++i) {
                    const double rest = 1 - dot(costs, rows[i]) + costs[k] * rows[i][k];
                    wanted += weights[i] * rows[i][k] * rest;
                    squares += weights[i] * rows[i][k] * rows[i][k];
                }
                costs[k] = squares > 0 ? std::max(0.0, wanted / squares) : 0;
            }
        }
        for (std::size_t i = 0; i < rows.size(); ++i)
            weights[i] = 1 / std::max(0.05, std::abs(1 - dot(costs, rows[i])));
    }
    return costs;
}

RaySeconds fit_of(std::span<const TimedSetting> settings) {
    std::vector<Row> rows;
    for (const TimedSetting& s : settings) {
        if (s.way != settings[0].way) continue;
        rows.push_back(row_of(s));
        for (double& r : rows.back()) r /= quiet_seconds(s);
    }
    const Row costs = fitted(rows);
    return {costs[0], costs[1], costs[2]};
}

/// The standard deviation of the logarithm of a run's seconds: that of a normal distribution with
/// the same 90 % quantile of distances. Busy moments are rare and long.
double noise_of(std::span<const TimedSetting> settings) {
    std::vector<double> distances;
    for (const TimedSetting& s : settings)
        for (const double seconds : s.seconds)
            if (s.seconds.size() > 1)
                distances.push_back(
                    std::abs(std::log(std::max(least_seconds, seconds) / median_seconds(s))));
    return distances.empty() ? unknown_noise : quantile_of(distances, 0.9) / 1.64;
}

}  // namespace

double quantile_of(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    // For n random values, a share k / (n + 1) of the distribution lies below the k-th on average.
    const double last = static_cast<double>(values.size() - 1);
    const double place = std::clamp(share * (last + 2) - 1, 0.0, last);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

double median_of(std::vector<double> values) {
    return quantile_of(std::move(values), 0.5);
}

double RaySeconds::of(const TimedSetting& setting) const {
    return dot({picture, depth, ray}, row_of(setting));
}

SteadyCosts steady_costs(std::span<const TimedSetting> settings) {
    const double noise = noise_of(settings);
    SteadyCosts result{fit_of(settings), {}, 0};
    std::vector<double> expected;
    std::map<std::string, std::vector<double>> apart;  // logarithm of seconds over expected, by way
    std::map<std::string, std::size_t> runs;
    std::size_t fewest = settings.empty() ? 1 : settings[0].seconds.size();
    for (const TimedSetting& s : settings) {
        expected.push_back(std::max(least_seconds, result.fitted.of(s)));
        apart[s.way].push_back(std::log(quiet_seconds(s) / expected.back()));
        runs[s.way] += s.seconds.size();
        fewest = std::min(fewest, s.seconds.size());
    }
    result.noise = two_sided_95 * standard_error(noise, std::max<std::size_t>(1, fewest));
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const TimedSetting& s = settings[i];
        // The factor of a way is the median deviation of its settings, if it is significant.
        double factor = s.way == settings[0].way ? 0 : median_of(apart[s.way]);
        if (std::abs(factor) < std::max(least_factor, sure * standard_error(noise, runs[s.way])))
            factor = 0;
        const double own = std::log(quiet_seconds(s) / expected[i]) - factor;
        const double unsure = sure * standard_error(noise, s.seconds.size());
        const double kept = std::copysign(std::max(0.0, std::abs(own) - unsure), own);
        result.seconds.push_back(expected[i] * std::exp(factor + kept));
    }
    return result;
}

}  // namespace lancer::judge
