// The compression function of SHA-256: updates the state for each block of 64 bytes (FIPS 180-4,
// 6.2.2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lancer {

using Sha256State = std::array<std::uint32_t, 8>;

/// The faster of the two functions below that this processor supports.
void absorb(Sha256State& state, const char* blocks, std::size_t count);

void absorb_plainly(Sha256State& state, const char* blocks, std::size_t count);

/// Uses the SHA instructions of x86 processors, if there are any: five times as fast.
bool has_sha_instructions();
void absorb_by_instructions(Sha256State& state, const char* blocks, std::size_t count);

}  // namespace lancer
