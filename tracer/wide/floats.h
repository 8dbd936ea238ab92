// Eight floats, for the tests of boxes; the same instructions on both levels.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

LANCER_INLINE Floats all(float x) {
    return {_mm256_set1_ps(x)};
}
LANCER_INLINE Floats load(const float* from) {
    return {_mm256_loadu_ps(from)};
}
LANCER_INLINE void store(float* to, const Floats& a) {
    _mm256_storeu_ps(to, a.v);
}
LANCER_INLINE Floats operator+(const Floats& a, const Floats& b) {
    return {_mm256_add_ps(a.v, b.v)};
}
LANCER_INLINE Floats operator-(const Floats& a, const Floats& b) {
    return {_mm256_sub_ps(a.v, b.v)};
}
LANCER_INLINE Floats operator*(const Floats& a, const Floats& b) {
    return {_mm256_mul_ps(a.v, b.v)};
}
LANCER_INLINE Floats absolute(const Floats& a) {
    return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v)};
}
/// a > b ? a : b
LANCER_INLINE Floats larger(const Floats& a, const Floats& b) {
    return {_mm256_max_ps(a.v, b.v)};
}
/// a < b ? a : b
LANCER_INLINE Floats smaller(const Floats& a, const Floats& b) {
    return {_mm256_min_ps(a.v, b.v)};
}
LANCER_INLINE Mask at_most(const Floats& a, const Floats& b) {
    return static_cast<Mask>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}
/// `size`, which is not negative, with the sign of `sign`.
LANCER_INLINE Floats with_sign(const Floats& size, const Floats& sign) {
    return {_mm256_or_ps(size.v, _mm256_and_ps(sign.v, _mm256_set1_ps(-0.0F)))};
}
/// `yes` in the lanes where `sign` is negative or -0, else `no`.
LANCER_INLINE Floats where_negative(const Floats& sign, const Floats& yes, const Floats& no) {
    return {_mm256_blendv_ps(no.v, yes.v, sign.v)};
}
LANCER_INLINE Mask negative(const Floats& a) {
    return static_cast<Mask>(_mm256_movemask_ps(a.v));
}
LANCER_INLINE float lane(const Floats& a, int i) {
    float x;
    __builtin_memcpy(&x, reinterpret_cast<const char*>(&a) + 4 * i, sizeof x);
    return x;
}
LANCER_INLINE void set_lane(Floats& a, int i, float x) {
    __builtin_memcpy(reinterpret_cast<char*>(&a) + 4 * i, &x, sizeof x);
}

/// All ones in the lanes of the mask.
LANCER_INLINE __m256i spread_32(Mask mask) {
    const __m256i bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i bits = _mm256_set1_epi32(static_cast<int>(mask));
    return _mm256_cmpeq_epi32(_mm256_and_si256(bits, bit), bit);
}
/// Stores eight integers: `yes` in the lanes of the mask, else `no`.
LANCER_INLINE void put_selected(std::uint32_t* to, Mask mask, const std::uint32_t* yes,
                                std::uint32_t no) {
    const __m256i own = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(yes));
    const __m256i other = _mm256_set1_epi32(static_cast<int>(no));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_blendv_epi8(other, own, spread_32(mask)));
}
/// Stores `x` in the lanes of the mask.
LANCER_INLINE void put_some(std::uint32_t* to, Mask mask, std::uint32_t x) {
    const __m256i own = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(to));
    const __m256i other = _mm256_set1_epi32(static_cast<int>(x));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_blendv_epi8(own, other, spread_32(mask)));
}

/// Which of eight integers equal `x`.
LANCER_INLINE Mask equal(const std::uint32_t* numbers, std::uint32_t x) {
    const __m256i eight = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers));
    const __m256i same = _mm256_cmpeq_epi32(eight, _mm256_set1_epi32(static_cast<int>(x)));
    return static_cast<Mask>(_mm256_movemask_ps(_mm256_castsi256_ps(same)));
}

}  // namespace lancer::wide::LANCER_LEVEL
