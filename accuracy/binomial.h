// What a count of successes says of the chance behind it.
#pragma once

#include <cstdint>

namespace lancer::accuracy {

/// Chances between 0 and 1.
struct ChanceInterval {
    double low = 0;
    double high = 1;
};

/// The interval of 95 % for the chance of a success, from `successes` in `trials` independent
/// trials, trials > 0: below `low` so many or more, above `high` so few or fewer come about at most
/// once in 40 times. It never holds the chance less often than that, however few successes there
/// are. Clopper and Pearson, "The use of confidence or fiducial limits illustrated in the case of
/// the binomial", Biometrika 26, 1934. The same bits on every processor, unlike a library's.
ChanceInterval clopper_pearson(std::uint64_t successes, std::uint64_t trials);

/// The chance of a success with which at most `most` in `trials` come about with `probability`.
double chance_of_at_most(std::uint64_t most, std::uint64_t trials, double probability);

}  // namespace lancer::accuracy
