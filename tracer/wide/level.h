// How many rays are traced side by side, and with which instructions.
#pragma once

namespace lancer {

/// Pictures have the same bytes on every level.
enum class Level {
    scalar,  ///< one ray at a time
    avx2,    ///< eight rays, in pairs of vectors of four numbers
    avx512,  ///< eight rays in vectors of eight
};

/// `scalar`, `avx2`, `avx512`
const char* name_of(Level level);

/// Whether the present processor has the level's instructions.
bool is_supported(Level level);

/// The fastest level that the present processor supports.
Level best_level();

}  // namespace lancer
