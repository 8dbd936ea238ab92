// The ball.
#pragma once

#include "tracer/ray.h"

namespace lancer {

template <class Real>
struct BallSolid {
    Vec3<Real> center;
    Real radius;
    Real placed = 0;  ///< bound on how far rounding moved it when a transform put it into the world
};

/// Whether the line passes the ball for certain: the textbook discriminant (f·d)^2 - d^2 (f^2 -
/// r^2), f from the centre to the start, is negative by more than all roundings of it (16 u of the
/// terms' sizes) and of what follows here (10 u) can make up for. A filter as in Shewchuk,
/// "Adaptive precision floating-point arithmetic", DCG 18 (1997), section 4: most lines that miss
/// are told apart without a division or a root.
template <class Real>
bool misses(const BallSolid<Real>& ball, const Ray<Real>& ray, const Vec3<Real>& from_center) {
    const Real along = dot(from_center, ray.dir);
    const Real ff = dot(from_center, from_center);
    const Real rr = ball.radius * ball.radius;
    return along * along - ray.dir_squared * (ff - rr) <
           -gamma<Real>(32) * (ray.dir_squared * (ff + rr));
}

/// The known root is 0, so the other is twice the middle (Vieta).
template <class Real, class Last, class Report>
void crossing_from_surface(const BallSolid<Real>& ball, const Ray<Real>& ray,
                           const Vec3<Real>& from_center, const Stretch<Real, Last>& stretch,
                           Report&& report) {
    using std::abs;
    using std::sqrt;
    const Real t = -2 * dot(from_center, ray.dir) / ray.dir_squared;
    if (stretch.ends_before(t)) return;
    // Each term of the product is rounded 4 times, |d|^2 and the quotient another 4 times.
    const Real size = dot(absolute(from_center), absolute(ray.dir));
    const Real error =
        (gamma<Real>(8) * size / sqrt(ray.dir_squared) + 2 * (ray.origin_error + ball.placed)) /
            sqrt(ray.dir_squared) +
        gamma<Real>(5) * abs(t);
    const Crossing<Real> c{t, error, 0, t < 0};
    if (stretch.holds(c)) report(c);
}

/// Reports the two crossings of the line with the sphere.
///
/// The discriminant is r^2 - |l|^2 with l the perpendicular from the centre to the line, not b^2 -
/// ac: its error grows with the distance f like u f, not u f^2. Source: Haines, Guenther,
/// Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019),
/// ch. 7. The second projection removes what the first left along the ray.
template <class Real, class Last, class Report>
void crossings(const BallSolid<Real>& ball, const Ray<Real>& ray, const Known& known,
               const Stretch<Real, Last>& stretch, Report&& report) {
    using std::abs;
    using std::copysign;
    using std::sqrt;
    const Vec3<Real> from_center = start_from(ray, ball.center);
    if (known.start_face != none) {
        crossing_from_surface(ball, ray, from_center, stretch, report);
        return;
    }
    if (!known.inside && misses(ball, ray, from_center)) return;
    const Vec3<Real> f = -from_center;
    const Real inv_squared = 1 / ray.dir_squared;
    Real middle = dot(f, ray.dir) * inv_squared;
    Vec3<Real> l = f - middle * ray.dir;
    const Real rest = dot(l, ray.dir) * inv_squared;
    l -= rest * ray.dir;
    middle += rest;
    const Real distance = length(l);
    Real inner = (ball.radius - distance) * (ball.radius + distance);
    if (inner < 0) {
        if (!known.inside) return;
        inner = 0;
    }
    const Real root = sqrt(inner);
    const Real inv_length = 1 / sqrt(ray.dir_squared);
    const Real half = root * inv_length;

    // The root nearer to 0 as c/q, so that it is not lost to cancellation. c = |f|^2 - r^2 takes
    // the largest component of f together with r and with its low part: over a giant ball the
    // height of the start is then a difference without error.
    const Vec3<Real> size = absolute(f);
    const int m = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const Real lost = lost_from_start(ray, ball.center, m);
    const Real low = f[m] > 0 ? -lost : lost;
    const Real high = ((size[m] - ball.radius) + low) * (size[m] + ball.radius);
    const Real aside =
        size[(m + 1) % 3] * size[(m + 1) % 3] + size[(m + 2) % 3] * size[(m + 2) % 3];
    const Real q = middle + copysign(half, middle);
    Real t_in = middle - half;
    Real t_out = middle + half;
    Real near = 0;
    Real inv_q = 0;
    if (q != 0) {
        inv_q = 1 / (q * ray.dir_squared);
        near = (high + aside) * inv_q;
        (q > 0 ? t_in : t_out) = near;
    }
    if (t_in > t_out) t_in = t_out = middle;
    if (stretch.ends_before(t_in)) return;

    // f and l are rounded at the size of f, which moves the line by `place` from the centre or
    // towards it, and r^2 - |l|^2, the square of the half chord h, by w = 2 place r + place^2. The
    // half chord then changes by at most w / (h + sqrt(h^2 - w)), or by sqrt(w) near a tangent.
    const Real start_error = ray.origin_error + ball.placed;
    const Real f_sum = size.x + size.y + size.z;
    const Real place = start_error + gamma<Real>(3) * f_sum + gamma<Real>(2) * ball.radius;
    const Real w = place * (2 * ball.radius + place);
    const Real q_error =
        (chord_error(w, inner, root) + place) * inv_length + gamma<Real>(6) * abs(q);
    // c / q inherits the relative error of q, and that of c.
    Real near_error = q_error;
    if (q != 0) {
        const Real c_error = gamma<Real>(5) * (abs(high) + aside) + 2 * start_error * f_sum;
        near_error = (c_error + abs(near) * q_error * ray.dir_squared) * abs(inv_q) +
                     gamma<Real>(5) * abs(near);
    }
    const bool in_is_near = q > 0;
    const Crossing<Real> in{t_in, in_is_near ? near_error : q_error, 0, true, t_out - t_in};
    const Crossing<Real> out{t_out, in_is_near ? q_error : near_error, 0, false};
    if (stretch.holds(in)) report(in);
    if (stretch.holds(out) && !stretch.ends_before(t_out)) report(out);
}

/// The crossing's point, put back onto the sphere; or, next to a giant one, taken from the ray,
/// when that is nearer to it than a radius can be rounded.
template <class Real>
SurfacePoint<Real> surface_point(const BallSolid<Real>& ball, const Ray<Real>& ray, Real t,
                                 std::uint32_t /*face*/) {
    using std::sqrt;
    const Vec3<Real> from_center = start_from(ray, ball.center);
    const Vec3<Real> normal = normalize(from_center + t * ray.dir);
    const Real way = t * t * ray.dir_squared;
    const Real scale = ball.radius / 1024;
    if (way < scale * scale) {
        const Vec3<Real> squares = from_center * from_center;
        const Real aside = squares.x + squares.y + squares.z - max_component(squares);
        const Real error = gamma<Real>(8) * (sqrt(way) + aside / ball.radius) + ray.origin_error;
        if (error < gamma<Real>(6) * ball.radius)
            return {ray.origin, t * ray.dir, error, normal, normal, Vec2<Real>(0), ray.origin_lo};
    }
    return {ball.center, ball.radius * normal, gamma<Real>(6) * ball.radius, normal,
            normal,      Vec2<Real>(0)};
}

}  // namespace lancer
