#include "tracer/wide/flat_frustums.h"

#include <cmath>

#include "tracer/wide/plain_vector.h"

namespace lancer::wide {

Frustum flat_frustum(const FrustumSolid<double>& frustum) {
    Frustum f{};
    put(frustum.small_end, f.small_end);
    put(frustum.large_end, f.large_end);
    put(frustum.axis, f.axis);
    f.height = frustum.height;
    f.radius = frustum.radius;
    f.slope = frustum.slope;
    f.filter_error = frustum.filter_error;
    f.transform_error = frustum.transform_error;
    f.capped = frustum.capped;
    f.tilted = frustum.tilted;
    return f;
}

Ball ball_around(const FrustumSolid<double>& frustum) {
    const double widest = frustum.radius + frustum.slope * frustum.height;
    Ball ball{};
    put(frustum.small_end + frustum.height / 2 * frustum.axis, ball.center);
    ball.radius = std::hypot(frustum.height / 2, widest) * (1 + 0x1p-20);
    ball.transform_error = frustum.transform_error;
    ball.filter_error = 2 * frustum.filter_error + filter_error_of(frustum.large_end);
    return ball;
}

}  // namespace lancer::wide
