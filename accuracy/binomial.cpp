#include "accuracy/binomial.h"

#include "model/elementary.h"

namespace lancer::accuracy {
namespace {

constexpr double tail = 0.025;

/// The probability of at most `most` successes, where one success has the probability `chance`,
/// 0 < chance < 1.
double at_most(std::uint64_t most, std::uint64_t trials, double chance) {
    const double odds = elementary::log(chance) - elementary::log(1 - chance);
    double log_term = static_cast<double>(trials) * elementary::log(1 - chance);
    double sum = elementary::exp(log_term);
    for (std::uint64_t k = 0; k < most; ++k) {
        log_term += odds + elementary::log(static_cast<double>(trials - k)) -
                    elementary::log(static_cast<double>(k + 1));
        sum += elementary::exp(log_term);
    }
    return sum;
}

}  // namespace

double chance_of_at_most(std::uint64_t most, std::uint64_t trials, double probability) {
    double low = 0;
    double high = 1;
    for (int step = 0; step < 50; ++step) {  // at_most() falls as the chance grows
        const double middle = (low + high) / 2;
        (at_most(most, trials, middle) > probability ? low : high) = middle;
    }
    return high;
}

ChanceInterval clopper_pearson(std::uint64_t successes, std::uint64_t trials) {
    ChanceInterval interval;
    if (successes > 0) interval.low = chance_of_at_most(successes - 1, trials, 1 - tail);
    if (successes < trials) interval.high = chance_of_at_most(successes, trials, tail);
    return interval;
}

}  // namespace lancer::accuracy
