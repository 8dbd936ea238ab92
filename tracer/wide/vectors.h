// Eight vectors, and bounds on rounding errors: model/math.h and numerics/rounding.h for lanes, by
// the same operations in the same order.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

inline constexpr double infinity = __builtin_inf();

template <class Real>
inline constexpr Real unit_roundoff = sizeof(Real) == sizeof(float) ? Real(0x1p-24) : Real(0x1p-53);
/// lancer::gamma(n), as a constant.
template <class Real, int n>
inline constexpr Real gamma = n* unit_roundoff<Real> / (1 - n * unit_roundoff<Real>);
/// The same in every lane.
template <int n>
LANCER_INLINE Numbers bound() {
    return all(gamma<double, n>);
}

LANCER_INLINE double lane(const Numbers& a, int i) {
    double x;
    __builtin_memcpy(&x, reinterpret_cast<const char*>(&a) + 8 * i, sizeof x);
    return x;
}
LANCER_INLINE void set_lane(Numbers& a, int i, double x) {
    __builtin_memcpy(reinterpret_cast<char*>(&a) + 8 * i, &x, sizeof x);
}
/// Calls work(lane) for each lane of the mask.
template <class Work>
LANCER_INLINE void for_each_lane(Mask mask, Work&& work) {
    for (; mask != 0; mask &= mask - 1) work(__builtin_ctz(mask));
}

/// Calls work(item, lanes) once for each different item of the lanes of the mask.
template <class Work>
LANCER_INLINE void for_each_item(const std::uint32_t* items, Mask mask, Work&& work) {
    while (mask != 0) {
        const std::uint32_t item = items[__builtin_ctz(mask)];
        const Mask same = mask & equal(items, item);
        work(item, same);
        mask &= ~same;
    }
}

struct Vectors {
    Numbers x, y, z;
};

LANCER_INLINE Vectors all(const double* v) {
    return {all(v[0]), all(v[1]), all(v[2])};
}
LANCER_INLINE Vectors operator+(const Vectors& a, const Vectors& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
LANCER_INLINE Vectors operator-(const Vectors& a, const Vectors& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
LANCER_INLINE Vectors operator*(const Vectors& a, const Vectors& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
LANCER_INLINE Vectors operator*(const Numbers& a, const Vectors& b) {
    return {a * b.x, a * b.y, a * b.z};
}
LANCER_INLINE Vectors operator*(const Vectors& a, const Numbers& b) {
    return {a.x * b, a.y * b, a.z * b};
}
LANCER_INLINE Vectors operator/(const Vectors& a, const Numbers& b) {
    return {a.x / b, a.y / b, a.z / b};
}
LANCER_INLINE Vectors operator-(const Vectors& a) {
    return {-a.x, -a.y, -a.z};
}
LANCER_INLINE Vectors absolute(const Vectors& a) {
    return {absolute(a.x), absolute(a.y), absolute(a.z)};
}
LANCER_INLINE Vectors select(Mask mask, const Vectors& yes, const Vectors& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}
LANCER_INLINE void set_lane(Vectors& a, int i, const double* v) {
    set_lane(a.x, i, v[0]);
    set_lane(a.y, i, v[1]);
    set_lane(a.z, i, v[2]);
}
LANCER_INLINE Numbers dot(const Vectors& a, const Vectors& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
LANCER_INLINE Numbers length(const Vectors& a) {
    return root(dot(a, a));
}
LANCER_INLINE Vectors normalize(const Vectors& a) {
    return a / length(a);
}
LANCER_INLINE Numbers max_component(const Vectors& a) {
    return larger(larger(a.x, a.y), a.z);
}
LANCER_INLINE Mask is_zero(const Vectors& a) {
    const Numbers zero = all(0.0);
    return equal(a.x, zero) & equal(a.y, zero) & equal(a.z, zero);
}
LANCER_INLINE Mask is_sound_square(const Numbers& square) {
    constexpr double epsilon = 0x1p-52;
    constexpr double least = 0x1p-1022 / (epsilon * epsilon);
    return less(all(least), square) & less(square, all(1 / least));
}

struct NumberPair {
    Numbers hi, lo;
};
struct VectorPair {
    Vectors hi, lo;
};
LANCER_INLINE NumberPair two_sum(const Numbers& a, const Numbers& b) {
    const Numbers s = a + b;
    const Numbers b_part = s - a;
    const Numbers a_part = s - b_part;
    return {s, (a - a_part) + (b - b_part)};
}
LANCER_INLINE VectorPair two_sum(const Vectors& a, const Vectors& b) {
    const NumberPair x = two_sum(a.x, b.x);
    const NumberPair y = two_sum(a.y, b.y);
    const NumberPair z = two_sum(a.z, b.z);
    return {{x.hi, y.hi, z.hi}, {x.lo, y.lo, z.lo}};
}
/// (hi + lo) - point, the exact difference rounded once.
LANCER_INLINE Vectors difference(const Vectors& hi, const Vectors& lo, const Vectors& point) {
    const VectorPair d = two_sum(hi, -point);
    return d.hi + (d.lo + lo);
}
/// chord_error() of numerics/rounding.h
LANCER_INLINE Numbers chord_error(const Numbers& w, const Numbers& x, const Numbers& x_root) {
    return select(less(all(4.0) * w, x), all(0.54) * w / x_root, root(w));
}

}  // namespace lancer::wide::LANCER_LEVEL
