// Eight rays, prepared for tests against boxes. All numbers are those of BoxRay (bvh/slabs.h) for a
// search that begins at 0, by the same operations in the same order. So the proof there holds here.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// far_factor<float>
inline constexpr float far_factor = 1 + 2 * gamma<float, 5>;

/// A float that is at least x: above the float nearest to x by at least a unit in the last place.
LANCER_INLINE Floats clearly_above(const Numbers& x) {
    const Floats f = rounded(x);
    return f + (absolute(f) * all(0x1p-23F) + all(0x1p-149F));
}

class BoxRays {
  public:
    struct Slab {
        Floats enter_origin, leave_origin, enter_inverse, leave_inverse;
        bool minus;     ///< at least one direction is negative
        bool one_sign;  ///< all directions are negative, or none is
    };
    alignas(32) Slab slabs[3];
    Mask misses;  ///< the rays that miss the box of the whole tree

    BoxRays(const Tree& tree, const Rays& r, Mask active, const Numbers& limit) {
        const Numbers zero = all(0.0);
        Numbers near = zero;
        Numbers far = limit;
        cut(tree.min[0], tree.max[0], r.origin.x, r.inv_dir.x, near, far);
        cut(tree.min[1], tree.max[1], r.origin.y, r.inv_dir.y, near, far);
        cut(tree.min[2], tree.max[2], r.origin.z, r.inv_dir.z, near, far);
        misses = less(far + bound<12>() * absolute(far), near);
        if ((active & ~misses) == 0) return;
        active &= ~misses;
        start_ = select(less(zero, near), near - bound<12>() * absolute(near), zero);
        set_scale(r.inv_dir, active);
        set_slab(0, r.origin.x, r.dir.x, r.inv_dir.x, active);
        set_slab(1, r.origin.y, r.dir.y, r.inv_dir.y, active);
        set_slab(2, r.origin.z, r.dir.z, r.inv_dir.z, active);
    }

    /// Upper bounds on the parameters t, as box tests use them.
    LANCER_INLINE Floats parameters(const Numbers& t) const {
        const Numbers error = bound<2>() * (absolute(t) + absolute(start_));
        return clearly_above(((t - start_) + error) * scale_);
    }

  private:
    LANCER_INLINE static void cut(double min, double max, const Numbers& origin,
                                  const Numbers& inverse, Numbers& near, Numbers& far) {
        const Mask minus = negative(inverse);
        const Numbers low = (all(min) - origin) * inverse;
        const Numbers high = (all(max) - origin) * inverse;
        near = larger(select(minus, high, low), near);
        far = smaller(select(minus, low, high), far);
    }

    /// Sets a scale for rays with very long or short directions, which occur in objects' own
    /// spaces.
    LANCER_INLINE void set_scale(const Vectors& inverse, Mask active) {
        scale_ = all(1.0);
        const Vectors size = absolute(inverse);
        const Numbers least = smaller(size.x, smaller(size.y, size.z));
        Mask odd = active & ~(less(all(0x1p-20), least) & less(least, all(0x1p20)));
        odd &= less(all(0.0), least) & less(least, all(infinity));
        for_each_lane(odd, [&](int i) {
            set_lane(scale_, i, __builtin_ldexp(1.0, -__builtin_ilogb(lane(least, i))));
        });
    }

    LANCER_INLINE void set_slab(int axis, const Numbers& origin, const Numbers& dir,
                                const Numbers& inverse, Mask active) {
        Slab& slab = slabs[axis];
        const Numbers way = start_ * dir;
        const Numbers at = origin + way;
        const Numbers error = bound<4>() * (absolute(origin) + absolute(way));
        const Floats exact = rounded(inverse * scale_);
        // Coordinates are rounded up for one side of a box and down for the other.
        const Floats pad = with_sign(clearly_above(all(0x1p-22) * absolute(at) + error), exact);
        const Floats coarse = rounded(at);
        slab.enter_origin = coarse + pad;
        slab.leave_origin = coarse - pad;
        slab.leave_inverse = exact;
        slab.enter_inverse = exact;
        // 1 / direction overflows float although the direction is not 0: the largest float instead
        // of infinity does not put the nearer plane too far.
        constexpr float most = 0x1.fffffep127F;
        const Mask finite = less(absolute(inverse), all(infinity));
        for_each_lane(finite & ~at_most(absolute(exact), all(most)), [&](int i) {
            set_lane(slab.enter_inverse, i, lane(exact, i) < 0 ? -most : most);
        });
        const Mask minus = negative(exact) & active;
        slab.minus = minus != 0;
        slab.one_sign = minus == 0 || minus == active;
    }

    Numbers start_;
    Numbers scale_;
};

}  // namespace lancer::wide::LANCER_LEVEL
