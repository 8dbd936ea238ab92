// A bent patch.
#pragma once

#include <random>

#include "model/shapes.h"

namespace lancer {

inline Patch random_patch(unsigned seed, double factor, double bend) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> shift(-1, 1);
    Patch patch;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            patch.control.push_back(Vec3d(j - 1.5 + 0.4 * shift(generator), bend * shift(generator),
                                          i - 1.5 + 0.4 * shift(generator)) *
                                    (factor / 3));
        }
    }
    return patch;
}

}  // namespace lancer
