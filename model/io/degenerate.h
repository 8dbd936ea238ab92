// Finds triangles without area, by no tolerance that depends on scale.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "model/math.h"

namespace lancer::io {

/// True when two corners coincide, or when all three are collinear within rounding. The answer is
/// the same at any scale. Corners must be finite.
bool is_degenerate(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// v * 2^exponent, exact except for underflow.
inline Vec3d scaled_by_power_of_two(const Vec3d& v, int exponent) {
    // If the factor is a normal number, one product gives the result of ldexp, and is faster.
    constexpr int bias = 1023;
    if (exponent > -bias && exponent <= bias)
        return v * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + bias) << 52);
    return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

}  // namespace lancer::io
