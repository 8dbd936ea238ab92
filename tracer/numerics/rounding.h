// Floating point made explicit: unit roundoff, exact sums and products, error-free helpers.
// No tolerance of the tracer is a constant: all are multiples of the unit roundoff times sizes that
// occur in the computation whose rounding they bound.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "model/math.h"

namespace lancer {

/// u: half the distance from 1 to the next number. Every rounded operation errs by at most a factor
/// 1 + u.
template <class Real>
inline constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;

/// For what is worked out once, before the first ray: no narrower than `long double`.
template <class Real>
using Wide = std::conditional_t<(std::numeric_limits<Real>::digits >
                                 std::numeric_limits<long double>::digits),
                                Real, long double>;

/// n u / (1 - n u): bounds the relative error of n rounded operations in a row.
/// Higham, Accuracy and Stability of Numerical Algorithms (2002), section 3.1.
template <class Real>
constexpr Real gamma(int n) {
    const Real nu = static_cast<Real>(n) * unit_roundoff<Real>;
    return nu / (1 - nu);
}

/// A number as an unevaluated sum hi + lo, |lo| <= u |hi|.
template <class Real>
struct DoubleWord {
    Real hi;
    Real lo;
};

/// a + b exactly (Knuth, The Art of Computer Programming 2, 4.2.2, theorem B).
template <class Real>
constexpr DoubleWord<Real> two_sum(Real a, Real b) {
    const Real s = a + b;
    const Real b_part = s - a;
    const Real a_part = s - b_part;
    return {s, (a - a_part) + (b - b_part)};
}

/// a b exactly.
template <class Real>
DoubleWord<Real> two_product(Real a, Real b) {
    using std::fma;
    const Real p = a * b;
    return {p, fma(a, b, -p)};
}

/// The sign of a b - c d is exact, and swapping the two products flips it exactly, which triangles
/// that share an edge rely on. The value is that of the rounded products unless they are equal.
template <class Real>
Real signed_difference_of_products(Real a, Real b, Real c, Real d) {
    const Real ab = a * b;
    const Real cd = c * d;
    if (ab != cd) return ab - cd;
    return two_product(a, b).lo - two_product(c, d).lo;
}

/// Bounds |sqrt(x) - sqrt(y)| for |x - y| <= w, x >= 0, y >= 0: w / (sqrt(x) + sqrt(y)), where
/// y >= x - w. Far from 0 (x > 4 w) the sum is at least 1.86 sqrt(x).
///
/// \param root  sqrt(x)
template <class Real>
Real chord_error(Real w, Real x, Real root) {
    using std::sqrt;
    return x > 4 * w ? Real(0.54) * w / root : sqrt(w);
}

/// A vector as an unevaluated sum: places keep the digits that one rounding would take from them.
template <class Real>
struct DoubleWordVector {
    Vec3<Real> hi;
    Vec3<Real> lo;
};

template <class Real>
[[gnu::always_inline]] inline DoubleWordVector<Real> two_sum(const Vec3<Real>& a,
                                                             const Vec3<Real>& b) {
    const DoubleWord<Real> x = two_sum(a.x, b.x);
    const DoubleWord<Real> y = two_sum(a.y, b.y);
    const DoubleWord<Real> z = two_sum(a.z, b.z);
    return {{x.hi, y.hi, z.hi}, {x.lo, y.lo, z.lo}};
}

/// The same sum with |lo| <= u |hi| in each component.
template <class Real>
[[gnu::always_inline]] inline DoubleWordVector<Real> normalized(const Vec3<Real>& hi,
                                                                const Vec3<Real>& lo) {
    if (lo == Vec3<Real>(0)) return {hi, lo};
    return two_sum(hi, lo);
}

/// Whether a type that the processor computes with as fast holds a sum of two of these numbers: so
/// exact differences cost little more than plain ones.
template <class Real>
inline constexpr bool has_fast_wider = std::is_same_v<Real, float>;

/// (hi + lo) - point, the exact difference rounded once, to within u^2. So it is the same wherever
/// both stand, as long as their coordinates are representable there.
template <class Real>
[[gnu::always_inline]] inline Vec3<Real> difference(const Vec3<Real>& hi, const Vec3<Real>& lo,
                                                    const Vec3<Real>& point) {
    if constexpr (has_fast_wider<Real>) {
        // The same as the plain difference where `lo` is 0: what the wider type loses of numbers of
        // so different sizes does not reach the last digit of the narrower one.
        return Vec3<Real>((Vec3<double>(hi) + Vec3<double>(lo)) - Vec3<double>(point));
    } else {
        const DoubleWordVector<Real> d = two_sum(hi, -point);
        return d.hi + (d.lo + lo);
    }
}

}  // namespace lancer
