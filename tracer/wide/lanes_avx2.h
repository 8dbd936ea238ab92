// Eight numbers in two registers of AVX2: see lanes_avx512.h.
#pragma once

#include <immintrin.h>
#include <sleef.h>

#include <cstdint>

namespace lancer::wide::LANCER_LEVEL {

#define LANCER_INLINE [[gnu::always_inline]] inline

/// One bit per lane.
using Mask = unsigned;
inline constexpr int lanes = 8;

struct Numbers {
    __m256d low, high;
};
/// For the tests of boxes.
struct Floats {
    __m256 v;
};

/// The same for two boxes at once.
struct FloatPairs {
    __m256 first, second;
};

LANCER_INLINE Numbers all(double x) {
    return {_mm256_set1_pd(x), _mm256_set1_pd(x)};
}
LANCER_INLINE Numbers load(const double* from) {
    return {_mm256_loadu_pd(from), _mm256_loadu_pd(from + 4)};
}
/// Four numbers, twice.
LANCER_INLINE Numbers load_twice(const double* from) {
    return {_mm256_loadu_pd(from), _mm256_loadu_pd(from)};
}
LANCER_INLINE void store(double* to, const Numbers& a) {
    _mm256_storeu_pd(to, a.low);
    _mm256_storeu_pd(to + 4, a.high);
}

LANCER_INLINE Numbers operator+(const Numbers& a, const Numbers& b) {
    return {_mm256_add_pd(a.low, b.low), _mm256_add_pd(a.high, b.high)};
}
LANCER_INLINE Numbers operator-(const Numbers& a, const Numbers& b) {
    return {_mm256_sub_pd(a.low, b.low), _mm256_sub_pd(a.high, b.high)};
}
LANCER_INLINE Numbers operator*(const Numbers& a, const Numbers& b) {
    return {_mm256_mul_pd(a.low, b.low), _mm256_mul_pd(a.high, b.high)};
}
LANCER_INLINE Numbers operator/(const Numbers& a, const Numbers& b) {
    return {_mm256_div_pd(a.low, b.low), _mm256_div_pd(a.high, b.high)};
}
LANCER_INLINE Numbers operator-(const Numbers& a) {
    const __m256d sign = _mm256_set1_pd(-0.0);
    return {_mm256_xor_pd(a.low, sign), _mm256_xor_pd(a.high, sign)};
}
LANCER_INLINE Numbers root(const Numbers& a) {
    return {_mm256_sqrt_pd(a.low), _mm256_sqrt_pd(a.high)};
}
LANCER_INLINE Numbers floor(const Numbers& a) {
    return {_mm256_floor_pd(a.low), _mm256_floor_pd(a.high)};
}
LANCER_INLINE Numbers absolute(const Numbers& a) {
    const __m256d sign = _mm256_set1_pd(-0.0);
    return {_mm256_andnot_pd(sign, a.low), _mm256_andnot_pd(sign, a.high)};
}
/// `size`, which is not negative, with the sign of `sign`.
LANCER_INLINE Numbers with_sign(const Numbers& size, const Numbers& sign) {
    const __m256d bit = _mm256_set1_pd(-0.0);
    return {_mm256_or_pd(size.low, _mm256_and_pd(sign.low, bit)),
            _mm256_or_pd(size.high, _mm256_and_pd(sign.high, bit))};
}
/// a > b ? a : b
LANCER_INLINE Numbers larger(const Numbers& a, const Numbers& b) {
    return {_mm256_max_pd(a.low, b.low), _mm256_max_pd(a.high, b.high)};
}
/// a < b ? a : b
LANCER_INLINE Numbers smaller(const Numbers& a, const Numbers& b) {
    return {_mm256_min_pd(a.low, b.low), _mm256_min_pd(a.high, b.high)};
}
/// a b - product, rounded once; exact if `product` is the rounded product of a and b.
LANCER_INLINE Numbers product_rest(const Numbers& a, const Numbers& b, const Numbers& product) {
    return {_mm256_fmsub_pd(a.low, b.low, product.low),
            _mm256_fmsub_pd(a.high, b.high, product.high)};
}

LANCER_INLINE Mask bits_of(__m256d low, __m256d high) {
    return static_cast<Mask>(_mm256_movemask_pd(low) | _mm256_movemask_pd(high) << 4);
}
/// The lanes that are negative or -0.
LANCER_INLINE Mask negative(const Numbers& a) {
    return bits_of(a.low, a.high);
}
LANCER_INLINE Mask less(const Numbers& a, const Numbers& b) {
    return bits_of(_mm256_cmp_pd(a.low, b.low, _CMP_LT_OQ),
                   _mm256_cmp_pd(a.high, b.high, _CMP_LT_OQ));
}
LANCER_INLINE Mask at_most(const Numbers& a, const Numbers& b) {
    return bits_of(_mm256_cmp_pd(a.low, b.low, _CMP_LE_OQ),
                   _mm256_cmp_pd(a.high, b.high, _CMP_LE_OQ));
}
LANCER_INLINE Mask equal(const Numbers& a, const Numbers& b) {
    return bits_of(_mm256_cmp_pd(a.low, b.low, _CMP_EQ_OQ),
                   _mm256_cmp_pd(a.high, b.high, _CMP_EQ_OQ));
}
/// All ones in the lanes whose bit is set in the lowest four bits of the mask.
LANCER_INLINE __m256i spread(Mask mask) {
    const __m256i bit = _mm256_setr_epi64x(1, 2, 4, 8);
    const __m256i bits = _mm256_set1_epi64x(static_cast<long long>(mask));
    return _mm256_cmpeq_epi64(_mm256_and_si256(bits, bit), bit);
}
LANCER_INLINE Numbers select(Mask mask, const Numbers& yes, const Numbers& no) {
    return {_mm256_blendv_pd(no.low, yes.low, _mm256_castsi256_pd(spread(mask))),
            _mm256_blendv_pd(no.high, yes.high, _mm256_castsi256_pd(spread(mask >> 4)))};
}
/// Stores the lanes of the mask contiguously at `to`, where there is room for eight.
LANCER_INLINE void store_packed(double* to, Mask mask, const Numbers& a) {
    double each[lanes];
    store(each, a);
    for (; mask != 0; mask &= mask - 1) *to++ = each[__builtin_ctz(mask)];
}
LANCER_INLINE void store_packed(std::uint32_t* to, Mask mask, const std::uint32_t* from) {
    for (; mask != 0; mask &= mask - 1) *to++ = from[__builtin_ctz(mask)];
}
LANCER_INLINE void store_some(double* to, Mask mask, const Numbers& a) {
    _mm256_maskstore_pd(to, spread(mask), a.low);
    _mm256_maskstore_pd(to + 4, spread(mask >> 4), a.high);
}

LANCER_INLINE Floats rounded(const Numbers& a) {
    return {_mm256_set_m128(_mm256_cvtpd_ps(a.high), _mm256_cvtpd_ps(a.low))};
}

LANCER_INLINE FloatPairs both(const Floats& a) {
    return {a.v, a.v};
}
/// Of eight numbers, eight[first] in all lanes of the first box and eight[first + 1] in all lanes
/// of the second.
LANCER_INLINE FloatPairs both(const float* eight, int first) {
    return {_mm256_broadcast_ss(eight + first), _mm256_broadcast_ss(eight + first + 1)};
}
LANCER_INLINE Floats first_of(const FloatPairs& a) {
    return {a.first};
}
LANCER_INLINE Floats second_of(const FloatPairs& a) {
    return {a.second};
}
LANCER_INLINE FloatPairs operator-(const FloatPairs& a, const FloatPairs& b) {
    return {_mm256_sub_ps(a.first, b.first), _mm256_sub_ps(a.second, b.second)};
}
LANCER_INLINE FloatPairs operator*(const FloatPairs& a, const FloatPairs& b) {
    return {_mm256_mul_ps(a.first, b.first), _mm256_mul_ps(a.second, b.second)};
}
LANCER_INLINE FloatPairs larger(const FloatPairs& a, const FloatPairs& b) {
    return {_mm256_max_ps(a.first, b.first), _mm256_max_ps(a.second, b.second)};
}
LANCER_INLINE FloatPairs smaller(const FloatPairs& a, const FloatPairs& b) {
    return {_mm256_min_ps(a.first, b.first), _mm256_min_ps(a.second, b.second)};
}
LANCER_INLINE FloatPairs where_negative(const FloatPairs& sign, const FloatPairs& yes,
                                        const FloatPairs& no) {
    return {_mm256_blendv_ps(no.first, yes.first, sign.first),
            _mm256_blendv_ps(no.second, yes.second, sign.second)};
}
/// The lanes of the first box, then those of the second.
LANCER_INLINE Mask at_most(const FloatPairs& a, const FloatPairs& b) {
    const int first = _mm256_movemask_ps(_mm256_cmp_ps(a.first, b.first, _CMP_LE_OQ));
    const int second = _mm256_movemask_ps(_mm256_cmp_ps(a.second, b.second, _CMP_LE_OQ));
    return static_cast<Mask>(first | second << 8);
}

/// elementary::pow, by a function of the same library that gives the same bits.
LANCER_INLINE Numbers power(const Numbers& x, const Numbers& y) {
    return {Sleef_cinz_powd4_u10avx(x.low, y.low), Sleef_cinz_powd4_u10avx(x.high, y.high)};
}
/// elementary::exp
LANCER_INLINE Numbers exponential(const Numbers& x) {
    return {Sleef_cinz_expd4_u10avx(x.low), Sleef_cinz_expd4_u10avx(x.high)};
}
/// elementary::acos
LANCER_INLINE Numbers arc_cosine(const Numbers& x) {
    return {Sleef_cinz_acosd4_u10avx(x.low), Sleef_cinz_acosd4_u10avx(x.high)};
}

}  // namespace lancer::wide::LANCER_LEVEL
