// Explicit floating point: unit roundoff, exact sums and products, error bounds.
// No tolerance of the tracer is a constant. Each is a multiple of the unit roundoff times sizes
// that occur in the computation whose rounding error it bounds.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "model/math.h"

namespace lancer {

/// u: half the distance from 1 to the next number. The relative error of every rounded operation is
/// at most u.
template <class Real>
inline constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;

/// The type for values that are computed once, before the first ray: at least `long double`.
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

/// a b - c d with the exact sign. Swapping the two products changes exactly the sign, on which
/// triangles with a common edge rely. The value is the difference of the rounded products, unless
/// these are equal.
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

/// A vector as an unevaluated sum. So points keep the digits that one rounding would remove.
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

/// The same sum, with |lo| <= u |hi| in each component.
template <class Real>
[[gnu::always_inline]] inline DoubleWordVector<Real> normalized(const Vec3<Real>& hi,
                                                                const Vec3<Real>& lo) {
    if (lo == Vec3<Real>(0)) return {hi, lo};
    return two_sum(hi, lo);
}

/// Whether there is a wider type that is about as fast and holds the sum of two numbers of this
/// type. Exact differences then cost little more than plain ones.
template <class Real>
inline constexpr bool has_fast_wider = std::is_same_v<Real, float>;

/// (hi + lo) - point: the exact difference rounded once, up to u^2. So it does not change when both
/// are translated, as long as their coordinates stay representable.
template <class Real>
[[gnu::always_inline]] inline Vec3<Real> difference(const Vec3<Real>& hi, const Vec3<Real>& lo,
                                                    const Vec3<Real>& point) {
    if constexpr (has_fast_wider<Real>) {
        // If `lo` is 0, this equals the plain difference: where numbers of very different sizes
        // lose digits in the wider type, the loss does not reach the last digit of the narrower.
        return Vec3<Real>((Vec3<double>(hi) + Vec3<double>(lo)) - Vec3<double>(point));
    } else {
        const DoubleWordVector<Real> d = two_sum(hi, -point);
        return d.hi + (d.lo + lo);
    }
}

}  // namespace lancer
