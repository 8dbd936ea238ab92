#include "judge/tradeoff/frontier.h"

#include <algorithm>
#include <numeric>

namespace lancer::judge {
namespace {

constexpr double error_noise = 0.02;

}  // namespace

std::vector<std::size_t> frontier(std::span<const TradePoint> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (points[a].seconds != points[b].seconds) return points[a].seconds < points[b].seconds;
        return points[a].error < points[b].error;
    });
    std::vector<std::size_t> best;
    for (const std::size_t i : order)
        if (best.empty() || points[i].error < points[best.back()].error) best.push_back(i);
    return best;
}

std::vector<std::size_t> clear_frontier(std::span<const TradePoint> points, double saving) {
    std::vector<std::size_t> best;
    double group = 0;  // seconds of the cheapest in the current group
    for (const std::size_t i : frontier(points)) {
        if (!best.empty() && points[i].error > (1 - error_noise) * points[best.back()].error)
            continue;
        if (!best.empty() && points[i].seconds < (1 + saving) * group) {
            best.back() = i;
            continue;
        }
        group = points[i].seconds;
        best.push_back(i);
    }
    return best;
}

std::vector<std::optional<std::size_t>> dominators(std::span<const TradePoint> points,
                                                   double saving) {
    const std::vector<std::size_t> best = clear_frontier(points, saving);
    std::vector<std::optional<std::size_t>> result(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::find(best.begin(), best.end(), i) != best.end()) continue;
        // Among those that are as cheap, chooses the one with the least error.
        for (const std::size_t b : best) {
            if (result[i] && points[b].seconds > (1 + saving) * points[i].seconds) break;
            result[i] = b;
        }
    }
    return result;
}

}  // namespace lancer::judge
