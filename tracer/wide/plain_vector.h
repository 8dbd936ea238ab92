// Vectors as plain numbers.
#pragma once

#include "model/math.h"

namespace lancer::wide {

inline void put(const Vec3d& from, double* to) {
    for (int i = 0; i < 3; ++i) to[i] = from[i];
}

}  // namespace lancer::wide
