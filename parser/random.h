// rand(): a hash of its arguments, the same on every machine.
#pragma once

#include <bit>
#include <cstdint>

namespace lancer {

/// The finaliser of SplitMix64 over the bits of each number in turn. Source: Steele, Lea, Flood,
/// "Fast splittable pseudorandom number generators", OOPSLA 2014; the constants are Stafford's
/// variant 13. docs/language.md describes the algorithm.
class RandomHash {
  public:
    void add(double x) {
        if (x == 0) x = 0;  // -0 counts as 0
        state_ = mix((state_ ^ std::bit_cast<std::uint64_t>(x)) + 0x9e3779b97f4a7c15);
    }
    /// In [0, 1): the upper 53 bits.
    double fraction() const { return static_cast<double>(state_ >> 11) * 0x1p-53; }

  private:
    static std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    std::uint64_t state_ = 0;
};

}  // namespace lancer
