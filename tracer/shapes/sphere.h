// The ball.
#pragma once

#include "tracer/ray.h"

namespace lancer {

template <class Real>
struct BallSolid {
    Vec3<Real> center;
    Real radius;
};

/// Reports the two crossings of the line with the sphere.
///
/// The discriminant is r^2 - |l|^2 with l the perpendicular from the centre to the line, not b^2 -
/// ac: its error grows with the distance f like u f, not u f^2. Source: Haines, Guenther,
/// Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019),
/// ch. 7. The second projection removes what the first left along the ray.
template <class Real, class Report>
void crossings(const BallSolid<Real>& ball, const Ray<Real>& ray, const Known& known,
               Report&& report) {
    using std::abs;
    using std::copysign;
    using std::sqrt;
    const Vec3<Real> f = -start_from(ray, ball.center);
    Real middle = dot(f, ray.dir) / ray.dir_squared;
    const Real ray_length = sqrt(ray.dir_squared);
    if (known.start_face != none) {
        // One root is 0, so the other is twice the middle (Vieta).
        const Real t = 2 * middle;
        const Real error = gamma<Real>(8) * abs(t) + 2 * ray.origin_error / ray_length;
        report(Crossing<Real>{t, error, 0, t < 0});
        return;
    }
    Vec3<Real> l = f - middle * ray.dir;
    const Real rest = dot(l, ray.dir) / ray.dir_squared;
    l -= rest * ray.dir;
    middle += rest;
    const Real distance = length(l);
    Real inner = (ball.radius - distance) * (ball.radius + distance);
    if (inner < 0) {
        if (!known.inside) return;
        inner = 0;
    }
    const Real half = sqrt(inner / ray.dir_squared);

    // The root nearer to 0 as c/q, so that it is not lost to cancellation.
    const Real f_length = length(f);
    const Real c = (f_length - ball.radius) * (f_length + ball.radius);
    const Real q = middle + copysign(half, middle);
    Real t_in = middle - half;
    Real t_out = middle + half;
    if (q != 0) {
        const Real near = c / (q * ray.dir_squared);
        (q > 0 ? t_in : t_out) = near;
    }
    if (t_in > t_out) t_in = t_out = middle;

    // The centre's and the origin's difference, and l, are rounded at the size of f; how far that
    // moves a root depends on the angle at which the line meets the sphere, but never by more than
    // the half chord that the same error adds to a tangent.
    const Real place = ray.origin_error + gamma<Real>(3) * f_length + gamma<Real>(3) * ball.radius;
    const Real cosine = half * ray_length / ball.radius;
    Real along = sqrt(2 * place * ball.radius + place * place);
    if (place < along * cosine) along = place / cosine;
    along /= ray_length;
    report(Crossing<Real>{t_in, along + gamma<Real>(3) * abs(t_in), 0, true, t_out - t_in});
    report(Crossing<Real>{t_out, along + gamma<Real>(3) * abs(t_out), 0, false});
}

/// The crossing's point, put back onto the sphere.
template <class Real>
SurfacePoint<Real> surface_point(const BallSolid<Real>& ball, const Ray<Real>& ray, Real t,
                                 std::uint32_t /*face*/) {
    const Vec3<Real> normal = normalize(start_from(ray, ball.center) + t * ray.dir);
    return {ball.center, ball.radius * normal, gamma<Real>(6) * ball.radius, normal,
            normal,      Vec2<Real>(0)};
}

}  // namespace lancer
