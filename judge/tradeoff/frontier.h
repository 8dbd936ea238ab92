// The Pareto frontier of settings: those that no other beats in both time and error.
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

/// The points on the frontier, the fastest first; the error decreases from each to the next.
std::vector<std::size_t> frontier(std::span<const TradePoint> points);

/// Costs that differ by a smaller share count as equal.
inline constexpr double least_saving = 0.05;

/// The frontier without points that noise could add or remove: a point is dropped when its error is
/// less than 2 % below that of a cheaper one. Of points whose costs are within `saving` of the
/// first of them, only the last is kept, which has the least error.
std::vector<std::size_t> clear_frontier(std::span<const TradePoint> points,
                                        double saving = least_saving);

/// For each point, the one on the clear frontier that beats it: among those that are as cheap,
/// within `saving`, the one with the least error. Nothing for points on the frontier.
std::vector<std::optional<std::size_t>> dominators(std::span<const TradePoint> points,
                                                   double saving = least_saving);

}  // namespace lancer::judge
