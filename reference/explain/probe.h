// How the judge asks the renderer that it judges: a port, so that this folder never sees the
// tracer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "model/image.h"
#include "model/math.h"

namespace lancer::reference {

/// What one ray through a point of the picture brought, and what it met first.
struct ProbeSample {
    Color color{0, 0, 0};  ///< in the units of the picture that is judged
    std::uint32_t object =
        0;  ///< any number that names what was hit; one of them for the background
    double depth = 0;
    Vec3d normal{0, 0, 0};
    std::uint64_t lit = 0;   ///< one bit per light that reaches the point
    std::uint64_t path = 0;  ///< equal paths differ only by smooth amounts, or by a texture's edge
    std::uint64_t rays = 1;  ///< of all kinds that it took: what the look cost
};

/// A ray through (x, y), in pixels from the picture's top left corner: (0.5, 0.5) is the centre of
/// the first pixel. Must be a pure function.
using Probe = std::function<ProbeSample(double x, double y)>;

/// The largest absolute difference of the components.
inline double distance(const Color& a, const Color& b) {
    return max_component(absolute(a - b));
}

/// Where a pixel stands in a list of all of them, rows from the top.
inline std::size_t index_of(const Image& image, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
           static_cast<std::size_t>(x);
}

inline Color color_at(const Image& image, int x, int y) {
    const double* p = image.pixel(x, y);
    return {p[0], p[1], p[2]};
}

}  // namespace lancer::reference
