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

/// lost_from_start() for one component.
LANCER_INLINE Numbers lost_from_start(const Numbers& origin, const Numbers& origin_lo,
                                      const Numbers& point) {
    const NumberPair d = two_sum(origin, -point);
    const Numbers rest = d.lo + origin_lo;
    return rest - ((d.hi + rest) - d.hi);
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

/// The bodies that eight rays are inside of, in the order entered: MediaList.
struct Bodies {
    alignas(32) std::uint32_t item[most_bodies][lanes];  ///< `nothing` after a lane's last body
    int depth = 0;                                       ///< number of rows in use

    /// The lanes that are inside of the item.
    LANCER_INLINE Mask inside(std::uint32_t of) const {
        Mask mask = 0;
        for (int k = 0; k < depth; ++k) mask |= equal(item[k], of);
        return mask;
    }
    /// The lanes that are inside of any body.
    LANCER_INLINE Mask some() const { return depth == 0 ? 0 : 255 & ~equal(item[0], nothing); }
    std::uint32_t last(int i) const {
        int k = depth;
        while (k > 0 && item[k - 1][i] == nothing) --k;
        return k == 0 ? nothing : item[k - 1][i];
    }
    /// \return whether there was room
    bool add(int i, std::uint32_t of) {
        int k = depth;
        while (k > 0 && item[k - 1][i] == nothing) --k;
        if (k == most_bodies) return false;
        if (k == depth) {
            for (int other = 0; other < lanes; ++other) item[k][other] = nothing;
            ++depth;
        }
        item[k][i] = of;
        return true;
    }
    /// Removes a body from a lane, or adds it: toggle().
    ///
    /// \return whether there was room
    bool toggle(int i, std::uint32_t of) {
        if ((inside(of) >> i & 1) == 0) return add(i, of);
        remove(i, of);
        return true;
    }
    /// Removes a body from a lane. The lane must be inside of it.
    void remove(int i, std::uint32_t of) {
        int k = 0;
        while (item[k][i] != of) ++k;
        for (; k + 1 < depth; ++k) item[k][i] = item[k + 1][i];
        item[k][i] = nothing;
    }
};

/// Eight LaneStarts: the items that the rays start on, the items that they leave for good, and the
/// bodies that contain them; `nothing` in lanes without.
struct Starts {
    alignas(32) std::uint32_t item[lanes];
    alignas(32) std::uint32_t left[lanes];
    alignas(32) std::uint32_t face[lanes];
    Mask entering = 0;
    Mask planes = 0;  ///< lanes in which `normal`, of what the ray starts on, is known
    Vectors normal;
    Bodies bodies;
    Bodies optical;  ///< Media::optical

    LaneStart lane(int i) const {
        LaneStart start{item[i], face[i], (entering >> i & 1) != 0, left[i], {}, {}};
        for (int k = 0; k < most_bodies; ++k) {
            start.bodies[k] = k < bodies.depth ? bodies.item[k][i] : nothing;
            start.optical[k] = k < optical.depth ? optical.item[k][i] : nothing;
        }
        return start;
    }
};

/// Which entries and exits of an item count, by the state rule of IntersectionFilter, per lane.
struct Ways {
    Mask in = 255, out = 255;
    Mask inside = 0;  ///< lanes that are in the item

    LANCER_INLINE Ways(bool clear, std::uint32_t index, const Bodies& bodies) {
        if (!clear) return;
        inside = bodies.inside(index);
        in = 255 & ~inside;
        out = inside;
    }
    Ways() = default;
};

}  // namespace lancer::wide::LANCER_LEVEL
