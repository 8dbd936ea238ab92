// Polynomials over [0, 1] in Bernstein form: the sum of c[i] B(n,i)(s). The coefficients bound the
// values and the number of roots, and a polynomial is halved by a few averages. So no tolerance is
// needed. Source: Farin, Curves and Surfaces for CAGD (5th ed., 2002), chapters 4 and 5. In this
// form roots move least when the coefficients are rounded: Farouki, Rajan, "On the numerical
// condition of polynomials in Bernstein form", CAGD 4 (1987).
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace lancer::splines {

/// Coefficients of degree N.
template <class Real, std::size_t N>
using Bernstein = std::array<Real, N + 1>;

template <class Real>
struct ValueAndSlope {
    Real value;
    Real slope;
};

/// Value and first derivative at s, by de Casteljau.
template <class T, class Real, std::size_t Count>
constexpr std::pair<T, T> evaluate(std::array<T, Count> c, Real s) {
    const Real r = 1 - s;
    for (std::size_t n = Count - 1; n > 1; --n) {
        for (std::size_t i = 0; i < n; ++i) c[i] = c[i] * r + c[i + 1] * s;
    }
    return {c[0] * r + c[1] * s, (c[1] - c[0]) * static_cast<Real>(Count - 1)};
}

/// The same polynomial over [0, 1/2] and [1/2, 1], each mapped to [0, 1]. Both have the same number
/// as their common coefficient in the middle.
template <class Real, std::size_t Count>
constexpr std::pair<std::array<Real, Count>, std::array<Real, Count>> halves(
    const std::array<Real, Count>& c) {
    std::array<Real, Count> left{};
    std::array<Real, Count> right = c;
    for (std::size_t n = Count; n > 0; --n) {
        left[Count - n] = right[0];
        for (std::size_t i = 0; i + 1 < n; ++i) right[i] = (right[i] + right[i + 1]) / 2;
    }
    return {left, right};
}

/// The number of sign changes along the coefficients, where 0 counts as positive. It is at least
/// the number of roots in (0, 1), and has the same parity (Descartes' rule in Bernstein form).
template <class Real, std::size_t Count>
constexpr int sign_changes(const std::array<Real, Count>& c) {
    int changes = 0;
    for (std::size_t i = 1; i < Count; ++i) changes += (c[i - 1] < 0) != (c[i] < 0);
    return changes;
}

/// The square of a polynomial of degree 1 or 3, as a polynomial of degree 2 or 6.
template <class Real>
constexpr Bernstein<Real, 2> square(const Bernstein<Real, 1>& a) {
    return {a[0] * a[0], a[0] * a[1], a[1] * a[1]};
}
template <class Real>
constexpr Bernstein<Real, 6> square(const Bernstein<Real, 3>& a) {
    return {a[0] * a[0],
            a[0] * a[1],
            (2 * a[0] * a[2] + 3 * a[1] * a[1]) / 5,
            (a[0] * a[3] + 9 * a[1] * a[2]) / 10,
            (2 * a[1] * a[3] + 3 * a[2] * a[2]) / 5,
            a[2] * a[3],
            a[3] * a[3]};
}

}  // namespace lancer::splines
