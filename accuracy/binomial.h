// Bounds on the probability of a success, from the number of successes in a number of trials.
#pragma once

#include <cstdint>

namespace lancer::accuracy {

/// Chances between 0 and 1.
struct ChanceInterval {
    double low = 0;
    double high = 1;
};

/// The exact 95 % interval for the probability of a success, from `successes` in `trials`
/// independent trials, trials > 0. With a probability below `low`, so many successes or more occur
/// with a probability of at most 1/40; with one above `high`, so few or fewer do. The interval
/// covers the true probability in at least 95 % of all cases, even for few successes. Clopper and
/// Pearson, "The use of confidence or fiducial limits illustrated in the case of the binomial",
/// Biometrika 26, 1934. The same bits on every processor, unlike a library's function.
ChanceInterval clopper_pearson(std::uint64_t successes, std::uint64_t trials);

/// The probability of a success for which at most `most` successes in `trials` trials have the
/// probability `probability`.
double chance_of_at_most(std::uint64_t most, std::uint64_t trials, double probability);

}  // namespace lancer::accuracy
