// How much of a picture's light its limits can have left out: a bound, not an estimate.
#pragma once

#include <functional>
#include <vector>

#include "accuracy/light_bound.h"
#include "tracer/render.h"

namespace lancer::accuracy {

/// How far a branch that was cut would have been followed, in surfaces.
inline constexpr int surfaces_beyond = 256;

/// Were each branch that the limits ended followed through surfaces_beyond more surfaces, no
/// channel of any pixel would change by more than `largest`, nor the picture by an RMSE of more
/// than `rmse`. In linear light.
///
/// Proof: the light of a ray is a sum over the tree of its branches; a branch counts by the product
/// of the factors along the way. What is followed is the same with and without limits, so the
/// difference is the sum over the branches that were cut of factor times light, and no light is
/// larger than most_light() says. A pixel is the mean of its rays. All factors and lights are
/// taken as at least 0; rounding is not counted.
struct CutBound {
    double largest = 0;
    double rmse = 0;
    TraceLimits limits;
};

/// The points of the pixel at column x, row y of the whole picture, as many in each.
using PointsOfPixel = std::function<std::vector<PicturePoint>(int x, int y)>;

/// \param limits  as in Renderer::trace()
/// \param points  where the picture's rays go; Renderer::samples() for render()
CutBound bound_of_cut(const Renderer& renderer, const Scene& scene, const View& view,
                      const TraceLimits& limits, const PointsOfPixel& points,
                      const Progress& progress);

}  // namespace lancer::accuracy
