#include "base/sha256_blocks.h"

#include <bit>

#ifdef __x86_64__
#include <cpuid.h>
#include <immintrin.h>
#endif

namespace lancer {

namespace {

// FIPS 180-4, 4.2.2: the first 32 bits of the fractional parts of the cube roots of the first
// primes.
alignas(16) constexpr std::array<std::uint32_t, 64> round_constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

void absorb_block(Sha256State& state, const char* block) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 64; ++i)
        w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(block[i]);
    for (std::size_t i = 16; i < 64; ++i) {
        const std::uint32_t s0 =
            std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ (w[i - 15] >> 3);
        const std::uint32_t s1 =
            std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ (w[i - 2] >> 10);
        w[i] = w[i - 16] + s0 + w[i - 7] + s1;
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < 64; ++i) {
        const std::uint32_t s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const std::uint32_t t1 = h + s1 + ((e & f) ^ (~e & g)) + round_constants[i] + w[i];
        const std::uint32_t s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const std::uint32_t t2 = s0 + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + t1;
        d = c;
        c = b;
        b = a;
        a = t1 + t2;
    }
    const Sha256State step{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < 8; ++i) state[i] += step[i];
}

}  // namespace

void absorb_plainly(Sha256State& state, const char* blocks, std::size_t count) {
    for (; count > 0; --count, blocks += 64) absorb_block(state, blocks);
}

#ifdef __x86_64__

bool has_sha_instructions() {
    unsigned a = 0;
    unsigned b = 0;
    unsigned c = 0;
    unsigned d = 0;
    return __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & bit_SSE4_1) != 0 && (c & bit_SSSE3) != 0 &&
           __get_cpuid_count(7, 0, &a, &b, &c, &d) != 0 && (b & bit_SHA) != 0;
}

/// Four rounds at a time. The instructions hold the state as (a, b, e, f) and (c, d, g, h), the
/// first in the highest lane: Intel 64 and IA-32 Architectures Software Developer's Manual, vol. 2,
/// SHA256RNDS2.
[[gnu::target("sha,ssse3,sse4.1")]] void absorb_by_instructions(Sha256State& state,
                                                                const char* blocks,
                                                                std::size_t count) {
    const auto lanes = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        return _mm_set_epi32(static_cast<int>(state[i]), static_cast<int>(state[j]),
                             static_cast<int>(state[k]), static_cast<int>(state[l]));
    };
    const __m128i big_endian = _mm_set_epi64x(0x0c0d0e0f08090a0b, 0x0405060700010203);
    __m128i abef = lanes(0, 1, 4, 5);
    __m128i cdgh = lanes(2, 3, 6, 7);
    for (; count > 0; --count, blocks += 64) {
        const __m128i abef_before = abef;
        const __m128i cdgh_before = cdgh;
        __m128i w[4];
        for (int i = 0; i < 4; ++i) {
            const auto* words = reinterpret_cast<const __m128i*>(blocks + 16 * i);
            w[i] = _mm_shuffle_epi8(_mm_loadu_si128(words), big_endian);
        }
        for (int i = 0; i < 16; ++i) {
            const auto* constants =
                reinterpret_cast<const __m128i*>(round_constants.data() + 4 * i);
            __m128i& here = w[i % 4];
            const __m128i last = w[(i + 3) % 4];
            __m128i sum = _mm_add_epi32(here, _mm_load_si128(constants));
            cdgh = _mm_sha256rnds2_epu32(cdgh, abef, sum);
            sum = _mm_shuffle_epi32(sum, 0x0E);
            abef = _mm_sha256rnds2_epu32(abef, cdgh, sum);
            // The schedule words that are needed sixteen rounds later.
            const __m128i seven_back = _mm_alignr_epi8(last, w[(i + 2) % 4], 4);
            const __m128i first = _mm_sha256msg1_epu32(here, w[(i + 1) % 4]);
            here = _mm_sha256msg2_epu32(_mm_add_epi32(first, seven_back), last);
        }
        abef = _mm_add_epi32(abef, abef_before);
        cdgh = _mm_add_epi32(cdgh, cdgh_before);
    }
    alignas(16) std::array<std::uint32_t, 4> words;
    const auto store = [&](__m128i from, std::size_t i, std::size_t j, std::size_t k,
                           std::size_t l) {
        _mm_store_si128(reinterpret_cast<__m128i*>(words.data()), from);
        state[i] = words[3];
        state[j] = words[2];
        state[k] = words[1];
        state[l] = words[0];
    };
    store(abef, 0, 1, 4, 5);
    store(cdgh, 2, 3, 6, 7);
}

#else

bool has_sha_instructions() {
    return false;
}
void absorb_by_instructions(Sha256State& state, const char* blocks, std::size_t count) {
    absorb_plainly(state, blocks, count);
}

#endif

void absorb(Sha256State& state, const char* blocks, std::size_t count) {
    static const bool fast = has_sha_instructions();
    (fast ? absorb_by_instructions : absorb_plainly)(state, blocks, count);
}

}  // namespace lancer
