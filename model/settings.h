// How to render: every knob that trades speed for accuracy, in one plain struct.
#pragma once

#include <optional>

namespace lancer {

enum class Precision { single, double_, extended };

/// The script's `render { … }` block; the command line overrides single members.
struct Settings {
    int max_depth = 8;                ///< recursion: 1 = primary rays only
    double min_contribution = 0.002;  ///< a branch whose weight falls below it is not followed
    int samples = 1;                  ///< n = n x n rays per pixel on a regular grid
    bool shadows = true;
    bool smooth = true;    ///< interpolated normals
    bool textures = true;  ///< false: plain colours
    /// Bound on the distance of what is drawn from the true surface, in world units: patches become
    /// triangles. Without it they are met on their true surface, unless one has a tolerance.
    std::optional<double> tolerance;
    Precision precision = Precision::double_;
    int threads = 0;  ///< 0 = as many as the machine has
};

}  // namespace lancer
