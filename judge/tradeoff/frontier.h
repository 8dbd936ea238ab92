// Which settings are worth having: those that no other beats in both time and error.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace lancer::judge {

struct TradePoint {
    double seconds = 0;
    double error = 0;
};

/// The points on the frontier, the fastest first: each errs less than the one before.
std::vector<std::size_t> frontier(std::span<const TradePoint> points);

/// What the clock cannot tell at best, as a share of a time.
inline constexpr double least_time_noise = 0.03;

/// The frontier without those that hardly earn their place, which the clock's noise would put there
/// in one run and not in the next: what errs by less than 2 % less than a faster one, and of those
/// whose times are within `time_noise` of the first of them all but the last, which errs least.
std::vector<std::size_t> clear_frontier(std::span<const TradePoint> points,
                                        double time_noise = least_time_noise);

/// For each point the one on the clear frontier that beats it: of those as fast, within the noise,
/// that with the least error. Nothing for those on the frontier.
std::vector<std::optional<std::size_t>> dominators(std::span<const TradePoint> points,
                                                   double time_noise = least_time_noise);

}  // namespace lancer::judge
