// Intersects eight rays with one ball in world space: shapes/sphere.h for lanes. The proof of the
// filter is there.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The filter, computed from plain differences of points.
struct BallGuess {
    Numbers along, discriminant;
    Mask may_meet;  ///< rays that may meet the ball; all others miss it for certain
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

    /// Removes from may_meet the rays whose chord lies clearly outside the interval [0, last].
    LANCER_INLINE void cut(const Rays& r, const Numbers& last) {
        const Numbers away = larger(along, -along - last * r.dir_squared);
        may_meet &= ~(clear & less(all(0.0), away) & less(all(1.04) * discriminant, away * away));
    }
};

/// |f|^2 - r^2 with a small relative error near the surface: Power.
struct BallPower {
    Numbers value, terms;

    LANCER_INLINE BallPower(const Ball& ball, const Rays& r, const Vectors& f) {
        const Numbers ff = dot(f, f);
        const Numbers radius = all(ball.radius);
        const Numbers rr = radius * radius;
        value = ff - rr;
        terms = ff + rr;
        const Mask far = less(ff, all(2.0) * value);
        if (far == 255) return;
        const Vectors size = absolute(f);
        const Mask first = less(size.y, size.x);
        const Mask is_x = first & less(size.z, size.x);
        const Mask is_y = ~first & less(size.z, size.y);
        // Rotates the components so that the largest one comes first.
        const auto turned = [&](const Vectors& v) {
            return Vectors{select(is_x, v.x, select(is_y, v.y, v.z)),
                           select(is_x, v.y, select(is_y, v.z, v.x)),
                           select(is_x, v.z, select(is_y, v.x, v.y))};
        };
        const Numbers along = turned(f).x;
        const Numbers lost =
            lost_from_start(turned(r.origin).x, turned(r.origin_lo).x, turned(all(ball.center)).x);
        const Numbers low = select(less(along, all(0.0)), -lost, lost);
        const Vectors sizes = turned(size);
        const Numbers high = ((sizes.x - radius) + low) * (sizes.x + radius);
        const Numbers rest = sizes.y * sizes.y + sizes.z * sizes.z;
        value = select(far, value, high + rest);
        terms = select(far, terms, absolute(high) + rest);
    }
};

/// The crossings of lines that do not start on the ball: both_crossings().
struct BallRoots {
    Numbers in, out;
    Mask met;   ///< lines that meet the ball
    Mask near;  ///< of those, lines with one root computed as a quotient: see both_crossings()

    LANCER_INLINE BallRoots(const Ball& ball, const Rays& r, Mask active) : met(active) {
        f_ = start_from(r, all(ball.center));
        Numbers middle = -dot(f_, r.dir) * r.inv_squared;
        Vectors l = f_ + middle * r.dir;
        const Numbers rest = -dot(l, r.dir) * r.inv_squared;
        l = l + rest * r.dir;
        middle = middle + rest;
        const Numbers radius = all(ball.radius);
        square_ = (radius * radius - dot(l, l)) * r.inv_squared;
        met &= ~less(square_, all(0.0));
        if (met == 0) return;
        half_ = root(square_);
        in = middle - half_;
        out = middle + half_;
        q_ = middle + with_sign(half_, middle);
        near = met & at_most(absolute(middle), all(2.0) * half_) & ~equal(q_, all(0.0));
        if (near != 0) divide(ball, r, middle);
    }

    /// Bounds on the errors of `in` and `out`.
    LANCER_INLINE void bound_errors(const Ball& ball, const Rays& r, Numbers& in_error,
                                    Numbers& out_error) const {
        const Vectors size = absolute(f_);
        const Numbers f_sum = size.x + size.y + size.z;
        const Numbers start_error = r.origin_error + all(ball.transform_error);
        const Numbers place = start_error + bound<3>() * (f_sum + all(ball.radius));
        const Numbers w = place * (all(2.0) * all(ball.radius) + place) * r.inv_squared;
        const Numbers error = chord_error(w, square_, half_) + place * root(r.inv_squared) +
                              bound<6>() * absolute(q_);
        in_error = out_error = error;
        if (near == 0) return;
        const Numbers c_error = bound<5>() * terms_ + all(2.0) * start_error * f_sum;
        const Mask first = less(all(0.0), q_);
        const Numbers t = absolute(select(first, in, out));
        const Numbers divided =
            (c_error * r.inv_squared + t * error) / absolute(q_) + bound<5>() * t;
        in_error = select(near & first, divided, error);
        out_error = select(near & ~first, divided, error);
    }

  private:
    LANCER_INLINE void divide(const Ball& ball, const Rays& r, const Numbers& middle) {
        const BallPower c(ball, r, f_);
        terms_ = c.terms;
        const Numbers t = c.value * r.inv_squared / q_;
        const Mask first = less(all(0.0), q_);
        in = select(near & first, t, in);
        out = select(near & ~first, t, out);
        const Mask crossed = near & less(out, in);
        in = select(crossed, middle, in);
        out = select(crossed, middle, out);
    }

    Vectors f_;
    Numbers square_, half_, q_, terms_;
};

/// The second crossing of rays that start on the ball: crossing_from_surface().
struct BallFromSurface {
    Numbers t, error;

    LANCER_INLINE BallFromSurface(const Ball& ball, const Rays& r) {
        const Vectors f = start_from(r, all(ball.center));
        t = all(-2.0) * dot(f, r.dir) * r.inv_squared;
        const Numbers size = dot(absolute(f), absolute(r.dir));
        error = bound<8>() * size * r.inv_squared +
                all(2.0) * (r.origin_error + all(ball.transform_error)) * root(r.inv_squared) +
                bound<7>() * absolute(t);
    }
};

/// Adds the crossings of rays that do not start on the ball.
///
/// \return rays inside the ball that miss it because of rounding; nothing is added for them
LANCER_INLINE Mask ball_crossings(const Ball& ball, std::uint32_t item, const Rays& r, Mask active,
                                  const Ways& ways, NearestHits& hits) {
    BallGuess guess(ball, r, active);
    guess.may_meet |= active & ways.inside;
    if (guess.may_meet == 0) return 0;
    guess.cut(r, hits.limit);
    const Mask asked = guess.may_meet | (active & ways.inside);
    if (asked == 0) return 0;
    const BallRoots roots(ball, r, asked);
    const Mask lost = active & ways.inside & ~roots.met;
    const Mask enters = roots.met & ways.in & ~less(hits.limit, roots.in);
    const Mask leaves = roots.met & ways.out & ~less(hits.limit, roots.out);
    if ((enters | leaves) == 0) return lost;
    Numbers in_error, out_error;
    roots.bound_errors(ball, r, in_error, out_error);
    hits.add_ahead(enters, roots.in, in_error, item, enters);
    hits.add_ahead(leaves & ~less(hits.limit, roots.out), roots.out, out_error, item, 0);
    return lost;
}

/// The same for rays that start on the ball. They cannot enter a ball that they just left.
LANCER_INLINE void crossings_from_ball(const Ball& ball, std::uint32_t item, const Rays& r,
                                       Mask active, const Ways& ways, NearestHits& hits) {
    const BallFromSurface other(ball, r);
    const Mask leaves = active & ways.out & ~less(other.t, all(0.0)) & ~less(hits.limit, other.t);
    hits.add_ahead(leaves, other.t, other.error, item, 0);
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
