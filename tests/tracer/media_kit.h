// Scenes of clear bodies, and their pictures, of which no ray may lose a crossing.
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/tracer/scene_kit.h"

namespace lancer::kit {

/// Something to see from all sides: a striped sky of large glowing balls around the origin.
inline void surround(Scene& scene) {
    scene.background = {0.1, 0.2, 0.4};
    int n = 0;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                ++n;
                show(scene, Sphere{{20.0 * x, 20.0 * y, 20.0 * z}, 6},
                     glowing({0.03 * n, 1 - 0.03 * n, (n % 4) * 0.25}));
            }
        }
    }
    scene.settings.min_contribution = 0;
    scene.settings.max_depth = 200;
}

/// Largest difference of any channel of any pixel.
inline double largest_difference(const Image& a, const Image& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i)
        most = std::max(most, std::abs(a.data[i] - b.data[i]));
    return most;
}

inline Image without_losses(const Scene& scene, int width = 32, int height = 24) {
    RayCounts counts;
    Image image = picture(scene, width, height, &counts);
    EXPECT_EQ(counts.media_lost, 0U);
    return image;
}

/// Pixels in which some channel differs by more than rounding and the edge of one bead account for.
inline int pixels_apart(const Image& a, const Image& b, double bound) {
    int apart = 0;
    for (std::size_t i = 0; i < a.data.size(); i += 3) {
        double most = 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(a.data[i + c] - b.data[i + c]));
        apart += most > bound;
    }
    return apart;
}

}  // namespace lancer::kit
