// A proved bound on the light that a picture misses because of its limits.
#pragma once

#include <functional>
#include <vector>

#include "accuracy/light_bound.h"
#include "tracer/render.h"

namespace lancer::accuracy {

/// The bound assumes that a branch that was cut would go on through this many surfaces.
inline constexpr int surfaces_beyond = 256;

/// If each branch that the limits ended went on through surfaces_beyond more surfaces, no channel
/// of any pixel would change by more than `largest`, and the RMSE of the change would be at most
/// `rmse`. Both are in linear light.
///
/// Proof: the light of a ray is a sum over the tree of its branches. Each branch is weighted by the
/// product of the factors on the path to it. The branches that are followed are the same with and
/// without limits. So the difference is the sum, over the branches that were cut, of factor times
/// light, and no light exceeds most_light(). A pixel is the mean of its rays. All factors and
/// lights are assumed to be at least 0; rounding is not included.
struct CutBound {
    double largest = 0;
    double rmse = 0;
    TraceLimits limits;
};

/// The sample points of the pixel at column x, row y of the whole picture; the same number in each
/// pixel.
using PointsOfPixel = std::function<std::vector<PicturePoint>(int x, int y)>;

/// \param limits  as in Renderer::trace()
/// \param points  where the picture's rays go; Renderer::samples() for render()
CutBound bound_of_cut(const Renderer& renderer, const Scene& scene, const View& view,
                      const TraceLimits& limits, const PointsOfPixel& points,
                      const Progress& progress);

}  // namespace lancer::accuracy
