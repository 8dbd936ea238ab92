// All settings that trade speed for accuracy, in one plain struct.
#pragma once

#include <cstdint>
#include <optional>

namespace lancer {

enum class Precision { single, double_, extended };

/// The positions of rays in a pixel: a regular grid, or Owen-scrambled Sobol points, which need
/// fewer rays for the same error.
enum class Sampling { grid, sobol };

/// The script's `render { … }` block; the command line overrides single members.
struct Settings {
    int max_depth = 8;                ///< recursion: 1 = primary rays only
    double min_contribution = 0.002;  ///< a branch whose weight falls below it is not followed
    int samples = 1;                  ///< n = n x n rays per pixel; 1 = through its centre
    Sampling sampling = Sampling::grid;
    std::uint64_t seed = 0;  ///< another seed gives other Sobol points
    bool shadows = true;
    bool smooth = true;    ///< interpolated normals
    bool textures = true;  ///< false: plain colours
    /// A bound on the distance between the drawn and the true surface, in world units: patches
    /// become triangles. Without it, rays intersect the true surface, unless a patch has its own
    /// tolerance.
    std::optional<double> tolerance;
    Precision precision = Precision::double_;
    int threads = 0;  ///< 0 = as many as the machine has cores
};

}  // namespace lancer
