// The ball.
#pragma once

#include "tracer/rays/crossing.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/traits.h"

namespace lancer {

template <class Real>
struct BallSolid {
    Vec3<Real> center;
    Real radius;
    Real transform_error =
        0;  ///< bound on how far rounding moved it when a transform put it into the world
    Real filter_error =
        transform_error + filter_error_of(center);  ///< error of `center` in a plain difference

    static constexpr SolidTraits traits{.convex = true, .face_by_face = false};
    /// The measure in its own space that must not be too small; infinite if there is none.
    Real size() const { return radius; }
};

/// The filter: whether plain differences of points settle the query. A filter as in Shewchuk,
/// "Adaptive precision floating-point arithmetic", DCG 18 (1997), section 4. It settles most lines
/// that miss, without exact differences, divisions or roots.
///
/// The textbook discriminant is (f·d)^2 - d^2 (f^2 - r^2), with f from the centre to the start. The
/// line certainly misses the ball if the discriminant is negative by more than its own rounding
/// error plus that of both_crossings(): 26 u of the sizes of the terms. If f is a plain difference
/// with the error e, 4 d^2 |f| e must be added, which makes 64 u of the squared sizes of both
/// points.
///
/// If the discriminant exceeds 4096 times this noise, the errors of the textbook roots are below
/// half the chord / 4096, and the bounds of both_crossings() are below half the chord / 2000: with
/// T the root of the terms, `place` there is at most 25 u T, while half the chord is more than 620
/// sqrt(u) T / |d|. So the chord is clear of the interval if its middle lies before the first
/// parameter, or beyond the last, by more than 65/64 of half the chord. This test needs no root. If
/// the middle is behind, the entry is behind as well, which is enough if exits do not matter.
template <class Real, class Last>
bool is_settled(const BallSolid<Real>& ball, const Ray<Real>& ray, const IntersectionHints& hints,
                const RayInterval<Real, Last>& interval) {
    using std::sqrt;
    const Vec3<Real> f = ray.origin - ball.center;
    const Real along = dot(f, ray.dir);
    const Real ff = dot(f, f);
    const Real rr = ball.radius * ball.radius;
    const Real size = size_of_place(ray.filter_error + ball.filter_error);
    const Real terms = ff + rr + size * size;
    const Real discriminant = along * along - ray.dir_squared * (ff - rr);
    const Real noise = gamma<Real>(96) * (ray.dir_squared * terms);
    if (discriminant < -noise) return true;
    if (!(discriminant > 4096 * noise)) return false;
    const Real to_first = along + interval.first * ray.dir_squared;
    const Real from_last = -along - interval.last() * ray.dir_squared;
    const Real away = to_first > from_last ? to_first : from_last;
    if (away > 0 &&
        (away * away > Real(1.04) * discriminant || (away == to_first && !hints.asks_about(false))))
        return true;
    if (!interval.may_accept_estimates) return false;
    const Real half = sqrt(discriminant) * ray.inv_squared;
    const Real middle = -along * ray.inv_squared;
    const Real slack = half / 64;
    const auto at = [&](Real t) { return interval.accepts_estimate(t - slack, t + slack); };
    return (hints.asks_about(true) && at(middle - half)) ||
           (hints.asks_about(false) && at(middle + half));
}

/// The crossing of a line that starts on the ball. The known root is 0, so the other one is twice
/// the middle (Vieta).
template <class Real, class Last, class Report>
[[gnu::noinline]] void crossing_from_surface(const BallSolid<Real>& ball, const Ray<Real>& ray,
                                             const RayInterval<Real, Last>& interval,
                                             Report& report) {
    using std::abs;
    using std::sqrt;
    const Vec3<Real> from_center = start_from(ray, ball.center);
    const Real t = -2 * dot(from_center, ray.dir) * ray.inv_squared;
    if (interval.ends_before(t)) return;
    // Each term of the product is rounded 4 times, and |d|^2 and the quotient another 4 times.
    const Real size = dot(absolute(from_center), absolute(ray.dir));
    const Real error = gamma<Real>(8) * size * ray.inv_squared +
                       2 * (ray.origin_error + ball.transform_error) * sqrt(ray.inv_squared) +
                       gamma<Real>(7) * abs(t);
    const Crossing<Real> c{t, error, 0, t < 0};
    if (interval.holds(c)) report(c);
}

/// |f|^2 - r^2, the power of the start, with a small relative error near the surface. It combines
/// the largest component of f, including its low part, with r. So the height of the start over a
/// giant ball is a difference without error.
template <class Real>
struct Power {
    Real value;
    Real terms;  ///< sum of the sizes of the terms; 5 u of it bound the error

    Power(const BallSolid<Real>& ball, const Ray<Real>& ray, const Vec3<Real>& from_center) {
        using std::abs;
        const Real ff = dot(from_center, from_center);
        const Real rr = ball.radius * ball.radius;
        value = ff - rr;
        terms = ff + rr;
        if (2 * value > ff) return;  // far from the surface nothing cancels
        const Vec3<Real> size = absolute(from_center);
        const int m = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const Real lost = lost_from_start(ray, ball.center, m);
        const Real low = from_center[m] < 0 ? -lost : lost;
        const Real high = ((size[m] - ball.radius) + low) * (size[m] + ball.radius);
        const Real y = size[(m + 1) % 3];
        const Real z = size[(m + 2) % 3];
        value = high + (y * y + z * z);
        terms = abs(high) + (y * y + z * z);
    }
};

/// Reports the two crossings of the line with the sphere.
///
/// The discriminant is r^2 - |l|^2, with the perpendicular l from the centre to the line, instead
/// of b^2 - ac. Its error grows with the distance f like u f, not like u f^2. Source: Haines,
/// Guenther, Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing
/// Gems (2019), ch. 7. The second projection removes the part along the ray that the first one
/// left.
template <class Real, class Last, class Report>
[[gnu::noinline]] void both_crossings(const BallSolid<Real>& ball, const Ray<Real>& ray,
                                      IntersectionHints hints,
                                      const RayInterval<Real, Last>& interval, Report& report) {
    using std::abs;
    using std::copysign;
    using std::sqrt;
    const Vec3<Real> f = start_from(ray, ball.center);
    Real middle = -dot(f, ray.dir) * ray.inv_squared;
    Vec3<Real> l = f + middle * ray.dir;
    const Real rest = -dot(l, ray.dir) * ray.inv_squared;
    l += rest * ray.dir;
    middle += rest;
    // The square of half the chord, in units of t. At most 5 roundings of r^2.
    Real square = (ball.radius * ball.radius - dot(l, l)) * ray.inv_squared;
    if (square < 0) {
        if (!hints.inside) return;
        square = 0;
    }
    const Real half = sqrt(square);
    Real t_in = middle - half;
    Real t_out = middle + half;
    // Where the root nearer to 0 would suffer from cancellation, it is computed as c / q.
    const Real q = middle + copysign(half, middle);
    const bool divides = 2 * half >= abs(middle) && q != 0;
    Real c_terms = 0;
    if (divides) {
        const Power<Real> c(ball, ray, f);
        c_terms = c.terms;
        (q > 0 ? t_in : t_out) = c.value * ray.inv_squared / q;
        if (t_in > t_out) t_in = t_out = middle;
    }

    // f and l are rounded relative to the size of f. This moves the line by at most `place` towards
    // the centre or away from it, and changes r^2 - |l|^2 by at most w = 2 place r + place^2; see
    // chord_error(). c / q has the relative errors of q and of c.
    const auto bound = [&](Real t, bool divided) {
        const Vec3<Real> size = absolute(f);
        const Real f_sum = size.x + size.y + size.z;
        const Real start_error = ray.origin_error + ball.transform_error;
        const Real place = start_error + gamma<Real>(3) * (f_sum + ball.radius);
        const Real w = place * (2 * ball.radius + place) * ray.inv_squared;
        const Real q_error =
            chord_error(w, square, half) + place * sqrt(ray.inv_squared) + gamma<Real>(6) * abs(q);
        if (!divides || !divided) return q_error;
        const Real c_error = gamma<Real>(5) * c_terms + 2 * start_error * f_sum;
        return (c_error * ray.inv_squared + abs(t) * q_error) / abs(q) + gamma<Real>(5) * abs(t);
    };
    if (interval.ends_before(t_in)) return;
    if (hints.asks_about(true)) {
        const Crossing<Real> in{t_in, bound(t_in, q > 0), 0, true, t_out - t_in};
        if (interval.holds(in)) report(in);
    }
    if (interval.ends_before(t_out) || !hints.asks_about(false)) return;
    const Crossing<Real> out{t_out, bound(t_out, q < 0), 0, false};
    if (interval.holds(out)) report(out);
}

template <class Real, class Last, class Report>
void crossings(const BallSolid<Real>& ball, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    if (hints.start_face != none)
        crossing_from_surface(ball, ray, interval, report);
    else if (hints.inside || !is_settled(ball, ray, hints, interval))
        both_crossings(ball, ray, hints, interval, report);
}

/// The point of a crossing, projected onto the sphere. If the ray starts very near to a giant
/// sphere, the point is taken from the ray instead, provided that its error is smaller than that of
/// the projected point.
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
