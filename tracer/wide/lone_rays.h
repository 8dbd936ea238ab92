// One of eight rays in the space of a mesh, with its coordinates side by side: rays/frame.h and
// bvh/slabs.h for one ray, by the same operations in the same order for each coordinate.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

LANCER_INLINE Fours coordinates(const Vectors& v, int i) {
    return {_mm256_setr_pd(lane(v.x, i), lane(v.y, i), lane(v.z, i), 0.0)};
}
LANCER_INLINE Fours map_vector(const Mesh& mesh, const Fours& v) {
    return three(mesh.inverse_x) * only<0>(v) + three(mesh.inverse_y) * only<1>(v) +
           three(mesh.inverse_z) * only<2>(v);
}
LANCER_INLINE Vectors all(const Fours& v) {
    double each[4];
    store(each, v);
    return all(each);
}

/// normalized()
LANCER_INLINE void normalize(Fours& hi, Fours& lo) {
    if ((equal(lo, four(0.0)) & 7) == 7) return;
    const Fours sum = hi + lo;
    const Fours lo_part = sum - hi;
    const Fours hi_part = sum - lo_part;
    lo = (hi - hi_part) + (lo - lo_part);
    hi = sum;
}

/// to_local()
struct LoneRay {
    Fours origin, origin_lo, dir, inv_dir;
    Fours about;  ///< the start minus the frame's shift, in world space: the high part
    Fours low;    ///< the low part before it was normalised
    bool whole;

    LANCER_INLINE LoneRay(const Rays& r, int i, const Mesh& mesh) {
        const Fours from = coordinates(r.origin, i);
        const Fours shift = -three(mesh.shift);
        about = from + shift;
        const Fours shift_part = about - from;
        const Fours from_part = about - shift_part;
        low = ((from - from_part) + (shift - shift_part)) + coordinates(r.origin_lo, i);
        Fours rest = low;
        normalize(about, rest);
        origin = map_vector(mesh, about);
        origin_lo = map_vector(mesh, rest);
        normalize(origin, origin_lo);
        whole = (equal(origin_lo, four(0.0)) & 7) == 7;
        dir = map_vector(mesh, coordinates(r.dir, i));
        inv_dir = four(1.0) / dir;
    }

    /// origin_error
    LANCER_INLINE double error(double in_world, const Mesh& mesh) const {
        const double moved = mesh.keeps_digits ? gamma<double, 2> * largest(absolute(low))
                                               : gamma<double, 6> * largest(absolute(about));
        return mesh.inverse_norm * (in_world + mesh.transform_error + moved);
    }
};

/// BoxRays
struct LoneBoxRay {
    LoneSlabs slabs;
    bool misses;

    LANCER_INLINE LoneBoxRay(const Tree& tree, const LoneRay& r, double limit) {
        const Fours min = three(tree.min);
        const Fours max = three(tree.max);
        const Fours in = (where_negative(r.inv_dir, max, min) - r.origin) * r.inv_dir;
        const Fours out = (where_negative(r.inv_dir, min, max) - r.origin) * r.inv_dir;
        // NaNs lose every comparison; the fourth lane is NaN.
        const double near = largest(larger(in, four(0.0)));
        const double far = smallest(smaller(out, four(limit)));
        misses = near > far + gamma<double, 12> * __builtin_fabs(far);
        if (misses) return;
        start_ = near > 0 ? near - gamma<double, 12> * near : 0;
        set_scale(r.inv_dir);
        const Fours way = four(start_) * r.dir;
        const Fours at = r.origin + way;
        const Fours error = four(gamma<double, 4>) * (absolute(r.origin) + absolute(way));
        const FourFloats inverse = rounded(r.inv_dir * four(scale_));
        const FourFloats pad =
            with_sign(clearly_above(four(0x1p-22) * absolute(at) + error), inverse);
        const FourFloats coarse = rounded(at);
        float from_enter[4], from_leave[4], by_enter[4], by_leave[4];
        store(from_enter, coarse + pad);
        store(from_leave, coarse - pad);
        store(by_leave, inverse);
        store(by_enter, inverse);
        constexpr float most = 0x1.fffffep127F;
        if ((at_most(absolute(inverse), four(most)) & 7) != 7) bring_near(r.inv_dir, by_enter);
        const Mask minus = negative(r.inv_dir);
        for (int a = 0; a < 3; ++a)
            slabs.axes[a].put(a, from_enter[a], from_leave[a], by_enter[a], by_leave[a],
                              (minus >> a & 1) != 0);
    }

    /// An upper bound on the parameter t, as box tests use it.
    LANCER_INLINE float parameter(double t) const {
        const double error = gamma<double, 2> * (__builtin_fabs(t) + __builtin_fabs(start_));
        return lone_clearly_above(((t - start_) + error) * scale_);
    }

  private:
    LANCER_INLINE static FourFloats clearly_above(const Fours& x) {
        const FourFloats f = rounded(x);
        return f + (absolute(f) * four(0x1p-23F) + four(0x1p-149F));
    }
    LANCER_INLINE static float lone_clearly_above(double x) {
        const auto f = static_cast<float>(x);
        return f + (__builtin_fabsf(f) * 0x1p-23F + 0x1p-149F);
    }

    /// Where 1 / direction overflows float although the direction is not 0: replaces infinity by
    /// the largest float, so that the nearer plane is not put too far.
    [[gnu::noinline]] static void bring_near(const Fours& inverse, float* by_enter) {
        double exact[4];
        store(exact, inverse);
        constexpr float most = 0x1.fffffep127F;
        for (int a = 0; a < 3; ++a) {
            if (!(__builtin_fabsf(by_enter[a]) <= most) && __builtin_fabs(exact[a]) < infinity)
                by_enter[a] = by_enter[a] < 0 ? -most : most;
        }
    }

    LANCER_INLINE void set_scale(const Fours& inverse) {
        double size[4];
        store(size, absolute(inverse));
        double least = size[0] < size[1] ? size[0] : size[1];
        least = least < size[2] ? least : size[2];
        if (!(least > 0x1p-20 && least < 0x1p20) && least > 0 && least < infinity)
            scale_ = __builtin_ldexp(1.0, -__builtin_ilogb(least));
    }

    double start_ = 0;
    double scale_ = 1;
};

}  // namespace lancer::wide::LANCER_LEVEL
