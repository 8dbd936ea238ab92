// The test which boxes of a node a ray may meet, and the ray prepared for it.
//
// Boxes may have a coarser number type than the ray (float for double). Then the ray's start is
// first moved, in the ray's own number type, to the point where it enters the box of the whole
// tree. So numbers that are rounded to the coarser type have the size of the tree, even if the ray
// starts far away. Each coordinate of the start is rounded up for one side of a box and down for
// the other, so that the interval between the two planes only grows. The remaining errors are
// relative to a distance, and are covered as in Ize, "Robust BVH Ray Traversal", JCGT 2(2) 2013.
#pragma once

#include <cmath>
#include <limits>

#include "tracer/bvh/bvh.h"
#include "tracer/rays/ray.h"

namespace lancer {

/// A float that is at most x: below the float nearest to x by at least a unit in the last place,
/// which is at most 2^-23 of it (2^-149 if it is subnormal).
inline float clearly_below(double x) {
    const auto f = static_cast<float>(x);
    return f - (std::abs(f) * 0x1p-23F + std::numeric_limits<float>::denorm_min());
}
inline float clearly_above(double x) {
    return -clearly_below(-x);
}

/// A ray, prepared for the pairs of planes perpendicular to one axis.
template <class Number>
struct SlabRay {
    Number enter_origin, leave_origin;    ///< the start, for the near and for the far plane
    Number enter_inverse, leave_inverse;  ///< 1 / direction
    bool negative;                        ///< the direction's sign

    /// The start is hi + lo, but the tests use only hi. Near the plane, |lo| <= u |hi| is less than
    /// the amount by which boxes are `widened`. Far from the plane, lo changes the distance by a
    /// relative 2 u.
    static SlabRay of(Number origin, Number inverse) {
        using std::signbit;
        return {origin, origin, inverse, inverse, signbit(inverse)};
    }
};

/// A ray, prepared for box tests. These use the parameter (t - start) * scale in place of t.
template <class Real>
class BoxRay {
  public:
    using Number = BoxNumber<Real>;

    /// \param bounds  those of the whole tree
    BoxRay(const Bounds<Real>& bounds, const Ray<Real>& ray, Real t_min, Real limit) {
        if constexpr (std::is_same_v<Number, Real>) {
            for (int i = 0; i < 3; ++i) slabs[i] = SlabRay<Real>::of(ray.origin[i], ray.inv_dir[i]);
            first = t_min;
        } else {
            enter(bounds, ray, t_min, limit);
        }
    }

    bool misses = false;  ///< the ray misses the box of the whole tree
    Number first = 0;     ///< where the search begins
    SlabRay<Number> slabs[3];

    /// An upper bound on the parameter t, as box tests use it.
    Number parameter(Real t) const {
        if constexpr (std::is_same_v<Number, Real>) {
            return t;
        } else {  // the error of the difference is u of both
            const Real error = gamma<Real>(2) * (std::abs(t) + std::abs(start_));
            return clearly_above(((t - start_) + error) * scale_);
        }
    }

  private:
    void enter(const Bounds<Real>& bounds, const Ray<Real>& ray, Real t_min, Real limit) {
        Real near = t_min;
        Real far = limit;
        for (int i = 0; i < 3; ++i) {
            const bool negative = std::signbit(ray.inv_dir[i]);
            const Real in =
                ((negative ? bounds.max[i] : bounds.min[i]) - ray.origin[i]) * ray.inv_dir[i];
            const Real out =
                ((negative ? bounds.min[i] : bounds.max[i]) - ray.origin[i]) * ray.inv_dir[i];
            if (in > near) near = in;
            if (out < far) far = out;
        }
        misses = near > far + gamma<Real>(12) * std::abs(far);
        if (misses) return;
        start_ = near > t_min ? near - gamma<Real>(12) * std::abs(near) : t_min;
        for (int i = 0; i < 3; ++i) {
            const Real way = start_ * ray.dir[i];
            const Real at = ray.origin[i] + way;
            // `error`: two roundings, and the low part of the start. `pad` adds the rounding to the
            // coarser type and those of the sums below.
            const Real error = gamma<Real>(4) * (std::abs(ray.origin[i]) + std::abs(way));
            const float pad = clearly_above(Real(0x1p-22) * std::abs(at) + error);
            const float coarse = static_cast<float>(at);
            const bool negative = std::signbit(ray.inv_dir[i]);
            slabs[i].negative = negative;
            slabs[i].enter_origin = negative ? coarse - pad : coarse + pad;
            slabs[i].leave_origin = negative ? coarse + pad : coarse - pad;
        }
        set_inverses(ray.inv_dir);
    }

    void set_inverses(const Vec3<Real>& inverse) {
        // In an object's own space, directions may be very long or short.
        const Vec3<Real> size = absolute(inverse);
        const Real least = std::min(size.x, std::min(size.y, size.z));
        if (!(least > Real(0x1p-20) && least < Real(0x1p20)) && least > 0 && std::isfinite(least))
            scale_ = std::ldexp(Real(1), -std::ilogb(least));
        for (int i = 0; i < 3; ++i) {
            const Real exact = inverse[i] * scale_;
            const auto rounded = static_cast<float>(exact);
            slabs[i].leave_inverse = rounded;
            slabs[i].enter_inverse = rounded;
            // 1 / direction overflows float although the direction is not 0: the largest float
            // instead of infinity does not put the nearer plane too far.
            if (std::isinf(rounded) && std::isfinite(inverse[i]))
                slabs[i].enter_inverse = std::copysign(std::numeric_limits<float>::max(), rounded);
        }
    }

    Real start_ = 0;
    Real scale_ = 1;
};

/// Clips the intervals [near, far] to the slabs between the boxes' planes perpendicular to `axis`.
/// NaN (0 times infinity, for a ray in a face of the box) loses every comparison and keeps the box.
template <class Real>
[[gnu::always_inline]] inline void cut_to_slabs(const BvhNode<Real>& node, std::size_t axis,
                                                const SlabRay<BoxNumber<Real>>& ray,
                                                Children<Real>& near, Children<Real>& far) {
    const Children<Real> enter(ray.negative ? node.max[axis] : node.min[axis]);
    const Children<Real> leave(ray.negative ? node.min[axis] : node.max[axis]);
    near = larger((enter - Children<Real>(ray.enter_origin)) * Children<Real>(ray.enter_inverse),
                  near);
    far = smaller((leave - Children<Real>(ray.leave_origin)) * Children<Real>(ray.leave_inverse),
                  far);
}

/// Far distances are multiplied by this factor, after the minimum, with which it commutes: Ize
/// (above), with two more roundings for the low part of the origin. In the coarser type these two
/// cover the rounding of the inverse.
template <class Number>
inline constexpr Number far_factor = 1 + 2 * gamma<Number>(5);

/// \tparam Numbers  Children<Real>
template <class Real, class Numbers>
Numbers widened_far(const Numbers& far) {
    return far * Numbers(far_factor<BoxNumber<Real>>);
}

}  // namespace lancer
