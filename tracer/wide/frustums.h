// The filter for eight rays and one cylinder or cone in world space: that of shapes/frustum.h for
// lanes. The proof is there. frustum_crossings.h computes the rays that the filter does not settle.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The rays that may meet what a ball holds, between 0 and `last`. So most rays that miss a frustum
/// are told without its memory.
LANCER_INLINE Mask may_come_near(const Ball& around, const Rays& r, Mask active,
                                 const Numbers& last) {
    BallGuess guess(around, r, active);
    guess.cut(r, last);
    return guess.may_meet;
}

struct FrustumGuess {
    Mask unsettled;    ///< rays that may have crossings in [0, last]
    Mask between = 0;  ///< of those, rays that certainly cross the side between 0 and `last`

    LANCER_INLINE FrustumGuess(const Frustum& f, const Rays& r, Mask active, const Numbers& last) {
        const Vectors axis = all(f.axis);
        const Vectors start = r.origin - all(f.small_end);
        const Numbers start_axial = dot(axis, start);
        const Vectors start_perp = start - start_axial * axis;
        const Numbers dir_axial = dot(axis, r.dir);
        const Vectors dir_perp = r.dir - dir_axial * axis;

        const Numbers slope = all(f.slope);
        const Numbers rate = slope * dir_axial;
        const Numbers radius = all(f.radius) + slope * start_axial;
        const Numbers qa = dot(dir_perp, dir_perp) - rate * rate;
        const Numbers qb = dot(start_perp, dir_perp) - radius * rate;
        const Numbers qc = dot(start_perp, start_perp) - radius * radius;
        const Numbers grow = all(1 + f.slope * f.slope);
        const Numbers steep = grow * r.dir_squared;
        constexpr double by_error = 1 / gamma<double, 16>;
        const Numbers size = (r.filter_error + all(f.filter_error)) * all(by_error);
        const Numbers squares = size * size + all(f.radius * f.radius);
        const Numbers noise = bound<512>() * (steep * grow) * squares;
        const Numbers discriminant = qb * qb - qa * qc;
        const Mask outside = less(discriminant, -noise);
        unsettled = active & ~(outside & less(bound<64>() * steep, qa));
        const Mask clear = unsettled & ~outside & less(all(4096.0) * noise, discriminant) &
                           less(steep, all(16.0) * qa);
        if (clear == 0) return;

        const Numbers zero = all(0.0);
        const Numbers inv = all(1.0) / qa;
        const Numbers half = root(discriminant) * inv;
        const Numbers middle = -qb * inv;
        const Numbers slack = half / all(64.0);
        const Numbers in = middle - half;
        const Numbers out = middle + half;
        Mask passes = less(last, in - slack) | less(out + slack, zero);
        const Numbers in_axial = start_axial + in * dir_axial;
        const Numbers out_axial = start_axial + out * dir_axial;
        const Numbers margin =
            absolute(dir_axial) * slack + bound<512>() * (size + all(f.radius) + all(f.height));
        const Numbers most = all(f.height) + margin;
        passes |= less(in_axial, -margin) & less(out_axial, -margin);
        passes |= less(most, in_axial) & less(most, out_axial);
        unsettled &= ~(clear & passes);
        const auto is_between = [&](const Numbers& t, const Numbers& axial) {
            return less(margin, axial) & less(axial, all(f.height) - margin) &
                   less(zero, t - slack) & less(t + slack, last);
        };
        between = clear & ~passes & (is_between(in, in_axial) | is_between(out, out_axial));
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
