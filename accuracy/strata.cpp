#include "accuracy/strata.h"

#include <algorithm>
#include <vector>

#include "model/elementary.h"

namespace lancer::accuracy {
namespace {

constexpr double tail = 0.025;
/// Intervals of the grid over the calm pixels' probability. Within an interval the bound uses the
/// worse of its ends. A large t occurs only far from any share that is asked for, so a coarse grid
/// will do there.
int grid_for(std::uint64_t t) {
    return t < 3000 ? 96 : 8;
}
constexpr int halvings = 32;

/// Upper bounds on the probabilities that at most 0, 1 ... `most` of the draws are off, where the
/// draws' probabilities have the mean `chance`. Exact if they are alike.
std::vector<double> at_most(std::uint64_t most, std::uint64_t draws, double chance, bool alike) {
    std::vector<double> sums(most + 1, 1);
    if (chance <= 0 || draws == 0) return sums;
    if (chance >= 1) {
        for (std::uint64_t k = 0; k < std::min(most + 1, draws); ++k) sums[k] = 0;
        return sums;
    }
    const double odds = elementary::log(chance) - elementary::log(1 - chance);
    const double n = static_cast<double>(draws);
    double log_term = n * elementary::log(1 - chance);
    double sum = 0;
    for (std::uint64_t k = 0; k <= std::min(most, draws); ++k) {
        sum += elementary::exp(log_term);
        // Hoeffding: for counts well below the mean, equal probabilities give the largest value.
        const bool is_bound = alike || static_cast<double>(k) + 1 <= n * chance;
        sums[k] = is_bound ? std::min(1.0, sum) : 1;
        if (k < draws)
            log_term += odds + elementary::log(static_cast<double>(draws - k)) -
                        elementary::log(static_cast<double>(k + 1));
    }
    return sums;
}

/// The probability of at most t, with these probabilities of the kinds; an upper bound if the
/// draws are not alike.
double chance_low(const TwoKinds& kinds, std::uint64_t t, double calm, double risky) {
    const std::uint64_t most = std::min(t / kinds.step, kinds.calm.draws);
    const std::vector<double> of_calm = at_most(most, kinds.calm.draws, calm, kinds.alike);
    const std::vector<double> of_risky =
        at_most(std::min(t, kinds.risky.draws), kinds.risky.draws, risky, kinds.alike);
    const auto left = [&](std::uint64_t j) {
        return of_risky[std::min(t - kinds.step * j, kinds.risky.draws)];
    };
    // The sum over the calm count j of P(j) left(j), summed by parts. So bounds on P(at most j) are
    // enough.
    double sum = 0;
    for (std::uint64_t j = 0; j <= most; ++j)
        sum += of_calm[j] * (left(j) - (j < most ? left(j + 1) : 0));
    return sum;
}

/// Upper bounds on the probabilities that at least 0, 1 ... `most` of the draws are off, where the
/// draws' probabilities have the mean `chance`. Exact if they are alike.
std::vector<double> at_least(std::uint64_t most, std::uint64_t draws, double chance, bool alike) {
    const std::vector<double> fewer = at_most(most, draws, chance, true);
    std::vector<double> sums(most + 1, 1);
    for (std::uint64_t k = 1; k <= most; ++k) {
        const bool is_bound =
            alike || k > draws || static_cast<double>(draws) * chance + 1 <= static_cast<double>(k);
        if (is_bound) sums[k] = std::max(0.0, 1 - fewer[k - 1]);
    }
    return sums;
}

/// The probability of at least t, with these probabilities of the kinds; an upper bound if the
/// draws are not alike.
double chance_high(const TwoKinds& kinds, std::uint64_t t, double calm, double risky) {
    const std::uint64_t enough =
        std::min((t + kinds.step - 1) / kinds.step, kinds.calm.draws);  // calm draws that reach t
    const std::vector<double> of_calm = at_least(enough, kinds.calm.draws, calm, kinds.alike);
    const std::vector<double> of_risky =
        at_least(std::min(t, kinds.risky.draws), kinds.risky.draws, risky, kinds.alike);
    const auto left = [&](std::uint64_t j) {
        const std::uint64_t least = t - std::min(t, kinds.step * j);
        return least > kinds.risky.draws ? 0 : of_risky[least];
    };
    double sum = left(0);
    for (std::uint64_t j = 1; j <= enough; ++j) sum += (left(j) - left(j - 1)) * of_calm[j];
    return sum;
}

/// The end of the range of probabilities, from 0, where a condition holds: a probability just
/// outside the range, or one within.
template <class Holds>
double end_of(const Holds& holds, bool outside) {
    if (holds(1)) return 1;
    double low = 0;
    double high = 1;
    for (int step = 0; step < halvings; ++step) {
        const double middle = (low + high) / 2;
        (holds(middle) ? low : high) = middle;
    }
    return outside ? high : low;
}

}  // namespace

double upper_share(const TwoKinds& kinds, std::uint64_t t) {
    const auto fits = [&](double calm, double risky) {
        return chance_low(kinds, t, calm, risky) > tail;
    };
    const double most = end_of([&](double calm) { return fits(calm, 0); }, true);
    const int grid = grid_for(t);
    double share = 0;
    for (int i = 0; i < grid; ++i) {
        // Within the interval, the largest risky probability is the one that fits the lower end: it
        // decreases as the calm probability grows.
        const double from = most * i / grid;
        const double to = most * (i + 1) / grid;
        if (!fits(from, 0)) break;
        const double risky = end_of([&](double chance) { return fits(from, chance); }, true);
        share = std::max(share, kinds.calm.weight * to + kinds.risky.weight * risky);
    }
    return std::min(1.0, share);
}

double lower_share(const TwoKinds& kinds, std::uint64_t t) {
    if (t == 0) return 0;
    const auto is_too_low = [&](double calm, double risky) {
        return chance_high(kinds, t, calm, risky) <= tail;
    };
    const double most = end_of([&](double calm) { return is_too_low(calm, 0); }, true);
    const int grid = grid_for(t);
    double share = 1;
    for (int i = 0; i <= grid; ++i) {
        const double from = most * i / grid;
        const double to = most * (i + 1) / grid;
        if (is_too_low(to, 1)) continue;  // no risky probability is large enough
        const double risky =
            is_too_low(to, 0) ? end_of([&](double c) { return is_too_low(to, c); }, false) : 0;
        share = std::min(share, kinds.calm.weight * from + kinds.risky.weight * risky);
    }
    return share;
}

}  // namespace lancer::accuracy
