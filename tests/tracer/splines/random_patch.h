// Bent patches.
#pragma once

#include <random>

#include "model/shapes.h"

namespace lancer {

/// A square of `factor`, moved about in its own plane, and bent out of it.
///
/// \param corner  where the square begins along both axes, in thirds of it; -1.5: about the origin
inline Patch random_patch(unsigned seed, double factor, double bend, double corner = -1.5) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> shift(-1, 1);
    Patch patch;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            patch.control.push_back(Vec3d(j + corner + 0.4 * shift(generator),
                                          bend * shift(generator),
                                          i + corner + 0.4 * shift(generator)) *
                                    (factor / 3));
        }
    }
    return patch;
}

/// The same with a corner at the origin, bent by twice `flatness`.
inline Patch random_patch_from_corner(unsigned seed, double factor, double flatness) {
    return random_patch(seed, factor, 2 * flatness, 0);
}

}  // namespace lancer
