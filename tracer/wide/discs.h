// Eight rays and the flat disc that a torus lies in: most rays that come to a torus' box miss it.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The rays whose lines may meet the disc: all points of the ball of its radius that are not
/// farther from its plane than its height. Nothing is divided, and no root is drawn.
///
/// Proof. Let the line be the one that the scalar method computes with, rounded numbers and all. It
/// is nowhere near the disc farther than 16 filter_errors from the given one, measured in the world
/// and times `blur` or `lift` if the torus' own space stretches it. The disc is larger by 1024 of
/// these, and by 2^-30 of the torus' reach in all directions, which is more than the roundings of
/// the quartic can move a root. So it is enough to compare the given line and the torus' disc.
///
/// The part of the line in the ball is centred at the point next to the ball's centre. From there
/// to its ends the height changes by the climb times half its length. If the line is higher than
/// that in its middle, the part misses the slab. Where |m|^2 - (m d)^2 / d^2 cancels, its error is
/// below 2^-48 |m|^2.
LANCER_INLINE Mask may_meet(const Disc& disc, const Rays& r) {
    const Numbers zero = all(0.0);
    const Vectors axis = all(disc.axis);
    const Vectors from = r.origin - all(disc.center);
    const Numbers square = dot(from, from);
    const Numbers along = dot(from, r.dir);
    const Numbers to_middle = along * r.inv_squared;
    const Numbers climb = dot(axis, r.dir);
    const Numbers height = absolute(dot(axis, from) - to_middle * climb);
    const Numbers moved = all(1024.0) * r.filter_error;
    const Numbers radius = all(disc.radius) + all(disc.blur) * moved;
    // The square of half the length in the ball
    const Numbers inside = (radius * radius + all(0x1p-44) * square) - (square - to_middle * along);
    const Numbers above = height - (all(disc.height) + all(disc.lift) * moved);
    const Numbers change = (climb * climb) * (r.inv_squared * inside);
    const Mask misses = less(inside, zero) | (less(zero, above) & less(change, above * above));
    return 255 & ~misses;
}

}  // namespace lancer::wide::LANCER_LEVEL
