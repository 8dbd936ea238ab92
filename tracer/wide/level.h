// How many rays are traced side by side, by the instructions of the processor at hand.
#pragma once

namespace lancer {

/// Pictures are the same bytes on every level.
enum class Level {
    scalar,  ///< one ray at a time
    avx2,    ///< eight rays, in pairs of vectors of four numbers
    avx512,  ///< eight rays in vectors of eight
};

/// `scalar`, `avx2`, `avx512`
const char* name_of(Level level);

/// Whether the processor at hand has the level's instructions.
bool is_supported(Level level);

/// The fastest that the processor at hand has.
Level best_level();

}  // namespace lancer
