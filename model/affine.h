// Affine maps: the transforms of the language.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/math.h"

namespace lancer {

/// p -> rows·p + shift. `rows[i]` is the i-th row of the linear part.
template <class Real>
struct Affine {
    std::array<Vec3<Real>, 3> rows{Vec3<Real>(1, 0, 0), Vec3<Real>(0, 1, 0), Vec3<Real>(0, 0, 1)};
    Vec3<Real> shift{0, 0, 0};
    /// Bound on how far rounding took `shift` from where the numbers that it is made of put it. Not
    /// a share of it: a move that changes no digit adds nothing.
    Real shift_error = 0;

    bool operator==(const Affine& other) const {
        return rows == other.rows && shift == other.shift;
    }
};

template <class Real>
Vec3<Real> map_vector(const Affine<Real>& m, const Vec3<Real>& v) {
    return {dot(m.rows[0], v), dot(m.rows[1], v), dot(m.rows[2], v)};
}

template <class Real>
Vec3<Real> map_point(const Affine<Real>& m, const Vec3<Real>& p) {
    return map_vector(m, p) + m.shift;
}

/// A bound on how far points move when each coordinate of the argument changes by up to that of
/// `v`.
template <class Real>
Vec3<Real> map_bound(const Affine<Real>& m, const Vec3<Real>& v) {
    return {dot(absolute(m.rows[0]), v), dot(absolute(m.rows[1]), v), dot(absolute(m.rows[2]), v)};
}

/// The transposed linear part times v. It transforms a normal with the surface when `m` is the
/// inverse of the map that moves the surface.
template <class Real>
Vec3<Real> map_transposed(const Affine<Real>& m, const Vec3<Real>& v) {
    return m.rows[0] * v.x + m.rows[1] * v.y + m.rows[2] * v.z;
}

/// Whether a product with this row of a map loses no digit: one number, a power of two.
template <class Real>
bool keeps_digits(const Vec3<Real>& row) {
    using std::abs;
    using std::frexp;
    int exponent = 0;
    const Real sum = abs(row.x) + abs(row.y) + abs(row.z);
    return max_component(absolute(row)) == sum && frexp(sum, &exponent) == Real(0.5);
}

/// Bound on what rounding takes when `m` maps p.
template <class Real>
Real rounding_of(const Affine<Real>& m, const Vec3<Real>& p) {
    using std::abs;
    Real most = 0;
    if (p == Vec3<Real>(0)) return most;
    for (int i = 0; i < 3; ++i) {
        const Vec3<Real>& row = m.rows[static_cast<std::size_t>(i)];
        // What the last sum loses, exactly (Knuth); before it the products, on rounded entries.
        const Real a = m.shift[i];
        const Real b = dot(row, p);
        const Real sum = a + b;
        const Real b_kept = sum - a;
        Real lost = abs((a - (sum - b_kept)) + (b - b_kept));
        if (!keeps_digits(row))
            lost += 4 * std::numeric_limits<Real>::epsilon() * dot(absolute(row), absolute(p));
        if (lost > most) most = lost;
    }
    return most;
}

/// Applies `inner` first, then `outer`.
template <class Real>
Affine<Real> compose(const Affine<Real>& outer, const Affine<Real>& inner) {
    Affine<Real> m;
    for (std::size_t i = 0; i < 3; ++i) m.rows[i] = map_transposed(inner, outer.rows[i]);
    m.shift = map_point(outer, inner.shift);
    m.shift_error = outer.shift_error + rounding_of(outer, inner.shift) +
                    max_component(map_bound(outer, Vec3<Real>(inner.shift_error)));
    return m;
}

template <class Real>
Real determinant(const Affine<Real>& m) {
    return dot(m.rows[0], cross(m.rows[1], m.rows[2]));
}

/// The inverse map. The linear part must not be singular.
template <class Real>
Affine<Real> inverse(const Affine<Real>& m) {
    const Vec3<Real> a = cross(m.rows[1], m.rows[2]);
    const Vec3<Real> b = cross(m.rows[2], m.rows[0]);
    const Vec3<Real> c = cross(m.rows[0], m.rows[1]);
    const Real d = dot(m.rows[0], a);
    Affine<Real> inv;
    inv.rows[0] = Vec3<Real>(a.x, b.x, c.x) / d;
    inv.rows[1] = Vec3<Real>(a.y, b.y, c.y) / d;
    inv.rows[2] = Vec3<Real>(a.z, b.z, c.z) / d;
    inv.shift = -map_vector(inv, m.shift);
    return inv;
}

/// A bound on the factor by which the map lengthens vectors, exact for similarities: the root of
/// the largest absolute row sum of M^T M. > 0 for a map that is not singular.
inline double largest_stretch(const Affine<double>& map) {
    double size = 0;
    for (const Vec3d& row : map.rows) size = std::max(size, max_component(absolute(row)));
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        double sum = 0;
        for (int j = 0; j < 3; ++j) {
            double product = 0;
            for (const Vec3d& row : map.rows) product += row[i] / size * (row[j] / size);
            sum += std::abs(product);
        }
        most = std::max(most, sum);
    }
    return size * std::sqrt(most);
}

/// The same map in another number type.
template <class To, class From>
Affine<To> convert(const Affine<From>& m) {
    Affine<To> r;
    for (std::size_t i = 0; i < 3; ++i) r.rows[i] = convert<To>(m.rows[i]);
    r.shift = convert<To>(m.shift);
    // The sum and the conversion round the bound itself.
    r.shift_error =
        static_cast<To>(m.shift_error + max_component(absolute(convert<From>(r.shift) - m.shift))) *
        (1 + 4 * std::numeric_limits<To>::epsilon());
    return r;
}

}  // namespace lancer
