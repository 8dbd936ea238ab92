// Patches for tests of the spline methods.
#pragma once

#include "model/shapes.h"
#include "tests/oracle/tally.h"

namespace lancer::oracle {

/// In a part of the cases the net is skewed, thin or nearly folded.
inline Patch random_patch(Draw& draw, double size) {
    const double thin = draw.number() % 48 == 0 ? draw.decade(-6, 0) : 1;
    const double rough = draw.between(0, 0.6);
    Patch patch;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j)
            patch.control.push_back(size * Vec3d(j + rough * draw.between(-1, 1),
                                                 draw.between(-1, 1),
                                                 thin * i + thin * rough * draw.between(-1, 1)));
    }
    return patch;
}

}  // namespace lancer::oracle
