// Eight rays by one ball in world space: shapes/sphere.h for lanes. The filter's proof is there.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// What plain differences of places tell of a ball.
struct BallGuess {
    Numbers along, discriminant;
    Mask may_meet;  ///< rays that do not pass the ball for certain
    Mask clear;     ///< rays whose roots are known well enough to compare them

    LANCER_INLINE BallGuess(const Ball& ball, const Rays& r, Mask active) {
        const Vectors f = r.origin - all(ball.center);
        along = dot(f, r.dir);
        const Numbers ff = dot(f, f);
        const Numbers rr = all(ball.radius) * all(ball.radius);
        constexpr double by_error = 1 / gamma<double, 16>;
        const Numbers size = (r.filter_error + all(ball.filter_error)) * all(by_error);
        const Numbers terms = ff + rr + size * size;
        discriminant = along * along - r.dir_squared * (ff - rr);
        const Numbers noise = bound<96>() * (r.dir_squared * terms);
        may_meet = active & ~less(discriminant, -noise);
        clear = less(all(4096.0) * noise, discriminant);
    }

    /// Takes out the rays whose chord is clear of the interval from 0 to `last`.
    LANCER_INLINE void cut(const Rays& r, const Numbers& last) {
        const Numbers away = larger(along, -along - last * r.dir_squared);
        may_meet &= ~(clear & less(all(0.0), away) & less(all(1.04) * discriminant, away * away));
    }
};

/// Adds the crossings of rays that do not start on the ball: both_crossings().
///
/// \return the rays that are too near for the plain roots, nothing added
LANCER_INLINE Mask ball_crossings(const Ball& ball, std::uint32_t item, const Rays& r, Mask active,
                                  NearestHits& hits) {
    BallGuess guess(ball, r, active);
    if (guess.may_meet == 0) return 0;
    guess.cut(r, hits.limit);
    Mask mask = guess.may_meet;
    if (mask == 0) return 0;
    const Vectors f = start_from(r, all(ball.center));
    Numbers middle = -dot(f, r.dir) * r.inv_squared;
    Vectors l = f + middle * r.dir;
    const Numbers rest = -dot(l, r.dir) * r.inv_squared;
    l = l + rest * r.dir;
    middle = middle + rest;
    const Numbers radius = all(ball.radius);
    const Numbers square = (radius * radius - dot(l, l)) * r.inv_squared;
    mask &= ~less(square, all(0.0));
    if (mask == 0) return 0;
    const Numbers half = root(square);
    const Numbers t_in = middle - half;
    const Numbers t_out = middle + half;
    const Numbers q = middle + with_sign(half, middle);
    const Mask near = mask & at_most(absolute(middle), all(2.0) * half) & ~equal(q, all(0.0));
    mask &= ~near & ~less(hits.limit, t_in);
    if (mask == 0) return near;

    const Vectors size = absolute(f);
    const Numbers f_sum = size.x + size.y + size.z;
    const Numbers start_error = r.origin_error + all(ball.transform_error);
    const Numbers place = start_error + bound<3>() * (f_sum + radius);
    const Numbers w = place * (all(2.0) * radius + place) * r.inv_squared;
    const Numbers error =
        chord_error(w, square, half) + place * root(r.inv_squared) + bound<6>() * absolute(q);
    hits.add_ahead(mask, t_in, error, item, mask);
    hits.add_ahead(mask & ~less(hits.limit, t_out), t_out, error, item, 0);
    return near;
}

/// Whether the ball hides the light from eight rays that do not start on it.
struct BallShadow {
    Mask blocks = 0;
    Mask unsure = 0;

    LANCER_INLINE BallShadow(const Ball& ball, const Rays& r, Mask active,
                             const Numbers& distance) {
        BallGuess guess(ball, r, active);
        if (guess.may_meet == 0) return;
        guess.cut(r, distance);
        const Mask mask = guess.may_meet;
        if (mask == 0) return;
        const Numbers half = root(guess.discriminant) * r.inv_squared;
        const Numbers middle = -guess.along * r.inv_squared;
        const Numbers slack = half / all(64.0);
        const auto lies_between = [&](const Numbers& t) {
            return less(all(0.0), t - slack) & less(t + slack, distance);
        };
        blocks = mask & guess.clear & (lies_between(middle - half) | lies_between(middle + half));
        unsure = mask & ~blocks;
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
