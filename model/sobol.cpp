#include "model/sobol.h"

namespace lancer {
namespace {

std::uint32_t reversed(std::uint32_t bits) {
    bits = bits >> 16 | bits << 16;
    bits = (bits & 0x00FF00FFU) << 8 | (bits & 0xFF00FF00U) >> 8;
    bits = (bits & 0x0F0F0F0FU) << 4 | (bits & 0xF0F0F0F0U) >> 4;
    bits = (bits & 0x33333333U) << 2 | (bits & 0xCCCCCCCCU) >> 2;
    return (bits & 0x55555555U) << 1 | (bits & 0xAAAAAAAAU) >> 1;
}

/// Changes each bit by a hash of the seed and the bits below it: Owen's scrambling of a number with
/// reversed bits. The factors are Burley's; they are even, so no bit changes itself.
std::uint32_t scrambled_backwards(std::uint32_t bits, std::uint32_t seed) {
    bits += seed;
    bits ^= bits * 0x6C50B47CU;
    bits ^= bits * 0xB82F1E52U;
    bits ^= bits * 0xC7AFE638U;
    bits ^= bits * 0x8D22F6E6U;
    return bits;
}

/// The second coordinate of Sobol's sequence: the columns of Pascal's triangle modulo 2.
std::uint32_t second_coordinate(std::uint32_t index) {
    std::uint32_t bits = 0;
    for (std::uint32_t column = 1U << 31; index != 0; index >>= 1, column ^= column >> 1)
        if ((index & 1U) != 0) bits ^= column;
    return bits;
}

/// The middle of the interval of length 2^-32 that these digits give.
double unit(std::uint32_t bits) {
    return (static_cast<double>(bits) + 0.5) * 0x1p-32;
}

/// Stafford's variant 13 of the finalizer of MurmurHash3.
std::uint64_t mixed(std::uint64_t bits) {
    bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ bits >> 27) * 0x94D049BB133111EBU;
    return bits ^ bits >> 31;
}

}  // namespace

SobolPoints::SobolPoints(std::uint64_t key)
    : seed_x_(static_cast<std::uint32_t>(key)), seed_y_(static_cast<std::uint32_t>(key >> 32)) {}

SquarePoint SobolPoints::operator[](std::uint32_t index) const {
    // The first coordinate is the index with reversed bits, and the scrambling works on reversed
    // bits: so the two reversals cancel.
    return {unit(reversed(scrambled_backwards(index, seed_x_))),
            unit(reversed(scrambled_backwards(reversed(second_coordinate(index)), seed_y_)))};
}

std::uint64_t pixel_key(std::uint64_t seed, int x, int y, std::uint64_t stream) {
    constexpr std::uint64_t golden = 0x9E3779B97F4A7C15U;
    const std::uint64_t place = static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32 |
                                static_cast<std::uint32_t>(x);
    return mixed(mixed(mixed(seed + golden) ^ (place + golden)) ^ (stream + golden));
}

}  // namespace lancer
