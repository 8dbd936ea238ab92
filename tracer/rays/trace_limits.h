// How far the branches of a ray are followed.
#pragma once

namespace lancer {

/// Settings has the same members.
struct TraceLimits {
    int max_depth = 8;                ///< recursion: 1 = primary rays only
    double min_contribution = 0.002;  ///< a branch whose weight falls below it is not followed
};

}  // namespace lancer
