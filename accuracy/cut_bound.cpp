#include "accuracy/cut_bound.h"

#include <algorithm>
#include <cmath>

namespace lancer::accuracy {
namespace {

/// share * light, where 0 times infinity is 0.
double bound(double share, double light) {
    return share > 0 ? share * light : 0;
}

}  // namespace

CutBound bound_of_cut(const Renderer& renderer, const Scene& scene, const View& view,
                      const TraceLimits& limits, const PointsOfPixel& points_of,
                      const Progress& progress) {
    CutBound result;
    result.limits = limits;
    // Then only camera rays exist. They have weight 1, so the limits do not cut them.
    if (!has_branches(scene) && limits.min_contribution <= 1) return result;
    const Color light = most_light(scene, surfaces_beyond);
    const Crop part = view.crop.value_or(Crop{0, 0, view.width, view.height});
    double squares = 0;
    std::vector<PicturePoint> points;
    std::vector<Color> shares;
    for (int y = part.y; y < part.y + part.height; ++y) {
        points.clear();
        for (int x = part.x; x < part.x + part.width; ++x) {
            const std::vector<PicturePoint> of_pixel = points_of(x, y);
            points.insert(points.end(), of_pixel.begin(), of_pixel.end());
        }
        shares.resize(points.size());
        renderer.cut_shares(view, points, limits, shares, {});
        const std::size_t per_pixel = points.size() / static_cast<std::size_t>(part.width);
        for (std::size_t at = 0; at < shares.size(); at += per_pixel) {
            Color share(0);
            for (std::size_t i = at; i < at + per_pixel; ++i) share += shares[i];
            share = share / static_cast<double>(per_pixel);
            for (const double error :
                 {bound(share.x, light.x), bound(share.y, light.y), bound(share.z, light.z)}) {
                result.largest = std::max(result.largest, error);
                squares += error * error;
            }
        }
        if (progress) progress(double(y - part.y + 1) / part.height);
    }
    result.rmse = std::sqrt(squares / (3.0 * part.width * part.height));
    return result;
}

}  // namespace lancer::accuracy
