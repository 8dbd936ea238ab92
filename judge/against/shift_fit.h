// Causes that move the picture: flips, and rays that miss the pixels' centres.
#pragma once

#include <vector>

#include "judge/against/value_fits.h"

namespace lancer::judge {

/// Upside down, mirrored, both.
std::vector<Explanation> turned_pictures(const TrialPixels& samples, const VariantTracer& tracer,
                                         const Scene& scene, const Renderer& renderer);

/// The picture whose rays go through other points of the pixels, up to a pixel and a half away:
/// places half a pixel apart are tried at some of the samples, and from the best of them the
/// place is refined by Gauss and Newton's method, pixels that a shift explains badly counting
/// little.
Explanation shifted_picture(const TrialPixels& samples, const VariantTracer& tracer,
                            const Scene& scene, const Renderer& renderer, double center_x,
                            double center_y);

}  // namespace lancer::judge
