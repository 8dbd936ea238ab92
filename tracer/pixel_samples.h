// Where in a pixel its rays go.
#pragma once

#include "model/settings.h"
#include "model/sobol.h"

namespace lancer {

/// Calls use(x, y) for the points of the pixel at column x, row y of the whole picture that rays go
/// through, in the order in which their light is summed.
template <class Real, class Use>
void for_each_sample(const Settings& settings, int x, int y, Use&& use) {
    const int n = settings.samples;
    if (n > 1 && settings.sampling == Sampling::sobol) {
        const SobolPoints points(pixel_key(settings.seed, x, y));
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n * n); ++i) {
            const SquarePoint at = points[i];
            use(static_cast<Real>(x + at.x), static_cast<Real>(y + at.y));
        }
        return;
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            use(static_cast<Real>(x) + (static_cast<Real>(i) + Real(0.5)) / static_cast<Real>(n),
                static_cast<Real>(y) + (static_cast<Real>(j) + Real(0.5)) / static_cast<Real>(n));
        }
    }
}

}  // namespace lancer
