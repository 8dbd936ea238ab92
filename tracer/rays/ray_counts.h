// How many rays of each kind were traced.
#pragma once

#include <cstdint>

namespace lancer {

/// Exact counts of one render() call.
struct RayCounts {
    std::uint64_t primary = 0;
    std::uint64_t shadow = 0;
    std::uint64_t reflected = 0;
    std::uint64_t transmitted = 0;
    std::uint64_t media_lost = 0;  ///< bodies whose exit was lost; 0 in a sound scene

    RayCounts& operator+=(const RayCounts& more) {
        primary += more.primary;
        shadow += more.shadow;
        reflected += more.reflected;
        transmitted += more.transmitted;
        media_lost += more.media_lost;
        return *this;
    }
    std::uint64_t rays() const { return primary + shadow + reflected + transmitted; }
};

}  // namespace lancer
