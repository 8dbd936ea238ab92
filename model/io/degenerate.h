// Triangles without area, found without a tolerance that depends on scale.
#pragma once

#include "model/math.h"

namespace lancer::io {

/// True when two corners coincide, or when a line passes through all three as far as rounding can
/// tell. Gives the same answer at any scale. For finite corners.
bool is_degenerate(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// v * 2^exponent, exact but for underflow.
inline Vec3d scaled_by_power_of_two(const Vec3d& v, int exponent) {
    return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

}  // namespace lancer::io
