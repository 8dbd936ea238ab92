// Powers of two. Multiplying by them does not round.
#pragma once

#include <cmath>

#include "model/math.h"

namespace lancer {

/// k such that 2^k extent lies in [0.5, 1); 0 for 0, infinity and NaN.
inline int exponent_for(double extent) {
    if (!(extent > 0) || !std::isfinite(extent)) return 0;
    int exponent = 0;
    std::frexp(extent, &exponent);
    return -exponent;
}

/// 2^exponent p.
inline Vec3d scaled(const Vec3d& p, int exponent) {
    return {ldexp(p.x, exponent), ldexp(p.y, exponent), ldexp(p.z, exponent)};
}

}  // namespace lancer
