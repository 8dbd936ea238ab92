// Tests whether one picture is the other, shifted by a fraction of a pixel.
#pragma once

#include <vector>

#include "judge/explain/edges.h"
#include "model/image.h"

namespace lancer::judge {

/// A displacement in pixels, x to the right and y down, with its standard errors.
struct Shift {
    double x = 0;
    double y = 0;
    double error_x = 0;
    double error_y = 0;
    /// The number of pixels or offsets used; 0: nothing could be estimated.
    std::size_t count = 0;

    double length() const;
    /// True when the displacement is longer than `least` pixels and, along its own direction,
    /// longer than `sigmas` standard errors. The factor is larger when few offsets determine the
    /// error.
    bool is_significant(double least, double sigmas) const;
};

/// The shift that explains `theirs` best as `theirs(p) = ours(p - shift)`, by least squares over
/// the pixels that are not in `skip` and have no neighbour there: Lucas and Kanade, "An Iterative
/// Image Registration Technique with an Application to Stereo Vision", IJCAI 1981, one iteration.
/// On a shaded surface it detects thousandths of a pixel, long before an edge crosses a pixel's
/// centre.
Shift register_pictures(const Image& ours, const Image& theirs, const Mask& skip);

/// Mean and standard error of the mean of `offsets`.
struct Offset {
    double x = 0;
    double y = 0;
};
Shift mean_offset(const std::vector<Offset>& offsets);

}  // namespace lancer::judge
