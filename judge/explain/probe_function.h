// The renderer's probe as a function: how the judge samples a point of a picture.
#pragma once

#include <cstddef>
#include <functional>

#include "model/image.h"
#include "model/math.h"
#include "tracer/render.h"

namespace lancer::judge {

/// Traces a ray through (x, y), in pixels from the picture's top left corner; (0.5, 0.5) is the
/// centre of the first pixel. The colour has the units of the judged picture. Must be a pure
/// function.
using ProbeFunction = std::function<Probe(double x, double y)>;

/// The largest absolute difference of the components.
inline double distance(const Color& a, const Color& b) {
    return max_component(absolute(a - b));
}

/// The index of a pixel in a list of all pixels, rows from the top.
inline std::size_t index_of(const Image& image, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
           static_cast<std::size_t>(x);
}

inline Color color_at(const Image& image, int x, int y) {
    const double* p = image.pixel(x, y);
    return {p[0], p[1], p[2]};
}

}  // namespace lancer::judge
