// The limits up to which the branches of a ray are followed.
#pragma once

namespace lancer {

/// Settings has members with the same names.
struct TraceLimits {
    int max_depth = 8;                ///< recursion: 1 = primary rays only
    double min_contribution = 0.002;  ///< a branch whose weight falls below it is not followed
};

}  // namespace lancer
