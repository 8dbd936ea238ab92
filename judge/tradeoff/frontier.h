// Which settings are worth having: those that no other beats in both time and error.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace lancer::judge {

struct TradePoint {
    double seconds = 0;  ///< what it costs
    double error = 0;
};

/// The points on the frontier, the fastest first: each errs less than the one before.
std::vector<std::size_t> frontier(std::span<const TradePoint> points);

/// Costs that differ by a smaller share are as good as one.
inline constexpr double least_saving = 0.05;

/// The frontier without those that hardly earn their place, which noise would put there in one run
/// and not in the next: what errs by less than 2 % less than a cheaper one, and of those whose
/// costs are within `saving` of the first of them all but the last, which errs least.
std::vector<std::size_t> clear_frontier(std::span<const TradePoint> points,
                                        double saving = least_saving);

/// For each point the one on the clear frontier that beats it: of those as cheap, within `saving`,
/// that with the least error. Nothing for those on the frontier.
std::vector<std::optional<std::size_t>> dominators(std::span<const TradePoint> points,
                                                   double saving = least_saving);

}  // namespace lancer::judge
