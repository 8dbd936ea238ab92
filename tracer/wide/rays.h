// Eight rays: Ray<double> for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

struct Rays {
    Vectors origin, origin_lo, dir;
    Numbers dir_squared, inv_squared, origin_error, filter_error;
    Vectors inv_dir;
    Mask whole;
};

/// make_ray()
LANCER_INLINE Rays make_rays(const Vectors& origin, const Vectors& origin_lo, const Vectors& dir,
                             const Numbers& origin_error) {
    Rays r;
    r.origin = origin;
    r.origin_lo = origin_lo;
    r.dir = dir;
    r.dir_squared = dot(dir, dir);
    const Numbers one = all(1.0);
    const Numbers excess = r.dir_squared - one;
    r.inv_squared = select(less(absolute(excess), bound<16>()), one - excess, one / r.dir_squared);
    r.origin_error = origin_error;
    const Vectors size = absolute(origin);
    r.filter_error = bound<16>() * (size.x + size.y + size.z) + origin_error;
    r.inv_dir = {one / dir.x, one / dir.y, one / dir.z};
    r.whole = is_zero(origin_lo);
    return r;
}

/// The starts relative to `point`: start_from().
LANCER_INLINE Vectors start_from(const Rays& r, const Vectors& point) {
    const Vectors plain = r.origin - point;
    if (r.whole == 255) return plain;
    return select(r.whole, plain, difference(r.origin, r.origin_lo, point));
}

[[gnu::noinline]] inline LaneRay lane_ray(const Rays& r, int i) {
    return {{lane(r.origin.x, i), lane(r.origin.y, i), lane(r.origin.z, i)},
            {lane(r.origin_lo.x, i), lane(r.origin_lo.y, i), lane(r.origin_lo.z, i)},
            {lane(r.dir.x, i), lane(r.dir.y, i), lane(r.dir.z, i)},
            lane(r.dir_squared, i),
            lane(r.inv_squared, i),
            lane(r.origin_error, i),
            lane(r.filter_error, i),
            {lane(r.inv_dir.x, i), lane(r.inv_dir.y, i), lane(r.inv_dir.z, i)},
            (r.whole >> i & 1) != 0};
}

/// What eight rays start on, and what they leave for good; `nothing` in lanes without.
struct Starts {
    alignas(32) std::uint32_t item[lanes];
    alignas(32) std::uint32_t left[lanes];
    alignas(32) std::uint32_t face[lanes];
    Mask entering = 0;

    LaneStart lane(int i) const { return {item[i], face[i], (entering >> i & 1) != 0, left[i]}; }
};

}  // namespace lancer::wide::LANCER_LEVEL
