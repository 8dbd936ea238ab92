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
        transform_error + filter_error_of(center);  ///< of `center` in a plain difference

    static constexpr SolidTraits traits{.convex = true, .face_by_face = false};
    /// The largest measure in its own space; infinite where none can be too small.
    Real size() const { return radius; }
};

/// Whether plain differences of places tell all that the query wants to know. A filter as in
/// Shewchuk, "Adaptive precision floating-point arithmetic", DCG 18 (1997), section 4: most lines
/// that miss are told apart without exact differences, a division or a root.
///
/// The line passes the ball for certain where the textbook discriminant (f·d)^2 - d^2 (f^2 - r^2),
/// f from the centre to the start, is negative by more than all roundings of it and of what follows
/// here can make up for: 26 u of the terms' sizes. Where f is a plain difference that is off by e,
/// 4 d^2 |f| e more, hence 64 u of the squared sizes of both places.
///
/// Where it is 4096 times as large as that noise, the textbook's roots are off by less than half
/// the chord / 4096, and both_crossings() bounds its own by less than 1/2000 of that: the place is
/// off by 25 u T, T the root of the terms, while half the chord is more than 620 sqrt(u) T / |d|.
/// So the chord is clear of the interval when its middle lies before the first parameter, or beyond
/// the last, by more than 65/64 of half of it, which takes no root to tell. The way in is behind as
/// soon as the middle is: enough where nothing is asked about the way out.
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

/// The known root is 0, so the other is twice the middle (Vieta).
template <class Real, class Last, class Report>
[[gnu::noinline]] void crossing_from_surface(const BallSolid<Real>& ball, const Ray<Real>& ray,
                                             const RayInterval<Real, Last>& interval,
                                             Report& report) {
    using std::abs;
    using std::sqrt;
    const Vec3<Real> from_center = start_from(ray, ball.center);
    const Real t = -2 * dot(from_center, ray.dir) * ray.inv_squared;
    if (interval.ends_before(t)) return;
    // Each term of the product is rounded 4 times, |d|^2 and the quotient another 4 times.
    const Real size = dot(absolute(from_center), absolute(ray.dir));
    const Real error = gamma<Real>(8) * size * ray.inv_squared +
                       2 * (ray.origin_error + ball.transform_error) * sqrt(ray.inv_squared) +
                       gamma<Real>(7) * abs(t);
    const Crossing<Real> c{t, error, 0, t < 0};
    if (interval.holds(c)) report(c);
}

/// |f|^2 - r^2 with its relative precision near the surface: it takes the largest component of f
/// together with r and with its low part, so that over a giant ball the height of the start is a
/// difference without error.
template <class Real>
struct Power {
    Real value;
    Real terms;  ///< sum of the sizes of what is summed: 5 roundings of it bound the error

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
/// The discriminant is r^2 - |l|^2 with l the perpendicular from the centre to the line, not b^2 -
/// ac: its error grows with the distance f like u f, not u f^2. Source: Haines, Guenther,
/// Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019),
/// ch. 7. The second projection removes what the first left along the ray.
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
    // The square of half the chord, in units of t. 5 roundings of r^2 at most.
    Real square = (ball.radius * ball.radius - dot(l, l)) * ray.inv_squared;
    if (square < 0) {
        if (!hints.inside) return;
        square = 0;
    }
    const Real half = sqrt(square);
    Real t_in = middle - half;
    Real t_out = middle + half;
    // Where the root nearer to 0 would lose to cancellation, it is c / q.
    const Real q = middle + copysign(half, middle);
    const bool divides = 2 * half >= abs(middle) && q != 0;
    Real c_terms = 0;
    if (divides) {
        const Power<Real> c(ball, ray, f);
        c_terms = c.terms;
        (q > 0 ? t_in : t_out) = c.value * ray.inv_squared / q;
        if (t_in > t_out) t_in = t_out = middle;
    }

    // f and l are rounded at the size of f, which moves the line by `place` from the centre or
    // towards it, and r^2 - |l|^2 by w = 2 place r + place^2; see chord_error(). c / q inherits the
    // relative error of q, and that of c.
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
