// What SHA-256 does to its state for each block of 64 bytes: FIPS 180-4, 6.2.2.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lancer {

using Sha256State = std::array<std::uint32_t, 8>;

/// The fastest of the two below that this processor has.
void absorb(Sha256State& state, const char* blocks, std::size_t count);

void absorb_plainly(Sha256State& state, const char* blocks, std::size_t count);

/// By the instructions that x86 processors have for it, where they have them: five times as fast.
bool has_sha_instructions();
void absorb_by_instructions(Sha256State& state, const char* blocks, std::size_t count);

}  // namespace lancer
