// Eight numbers in one AVX-512 register. lanes_avx2.h has the same in two AVX2 registers.
//
// The headers with code in this folder use a namespace of their level, and call no functions from
// elsewhere. Reason: if several object files contain the same inline function, the linker takes it
// from any of them. A processor without the level's instructions must never run a function that was
// compiled with them.
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
    __m512d v;
};
/// For the tests of boxes.
struct Floats {
    __m256 v;
};

/// The same for two boxes at once.
struct FloatPairs {
    __m512 v;
};

LANCER_INLINE Numbers all(double x) {
    return {_mm512_set1_pd(x)};
}
LANCER_INLINE Numbers load(const double* from) {
    return {_mm512_loadu_pd(from)};
}
/// Four numbers, twice.
LANCER_INLINE Numbers load_twice(const double* from) {
    return {_mm512_broadcast_f64x4(_mm256_loadu_pd(from))};
}
LANCER_INLINE void store(double* to, const Numbers& a) {
    _mm512_storeu_pd(to, a.v);
}

LANCER_INLINE Numbers operator+(const Numbers& a, const Numbers& b) {
    return {_mm512_add_pd(a.v, b.v)};
}
LANCER_INLINE Numbers operator-(const Numbers& a, const Numbers& b) {
    return {_mm512_sub_pd(a.v, b.v)};
}
LANCER_INLINE Numbers operator*(const Numbers& a, const Numbers& b) {
    return {_mm512_mul_pd(a.v, b.v)};
}
LANCER_INLINE Numbers operator/(const Numbers& a, const Numbers& b) {
    return {_mm512_div_pd(a.v, b.v)};
}
LANCER_INLINE Numbers operator-(const Numbers& a) {
    return {_mm512_xor_pd(a.v, _mm512_set1_pd(-0.0))};
}
LANCER_INLINE Numbers root(const Numbers& a) {
    return {_mm512_sqrt_pd(a.v)};
}
LANCER_INLINE Numbers floor(const Numbers& a) {
    return {_mm512_roundscale_pd(a.v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)};
}
LANCER_INLINE Numbers absolute(const Numbers& a) {
    return {_mm512_abs_pd(a.v)};
}
/// `size`, which is not negative, with the sign of `sign`.
LANCER_INLINE Numbers with_sign(const Numbers& size, const Numbers& sign) {
    return {_mm512_or_pd(size.v, _mm512_and_pd(sign.v, _mm512_set1_pd(-0.0)))};
}
/// a > b ? a : b
LANCER_INLINE Numbers larger(const Numbers& a, const Numbers& b) {
    return {_mm512_max_pd(a.v, b.v)};
}
/// a < b ? a : b
LANCER_INLINE Numbers smaller(const Numbers& a, const Numbers& b) {
    return {_mm512_min_pd(a.v, b.v)};
}
/// a b - product, rounded once; exact if `product` is the rounded product of a and b.
LANCER_INLINE Numbers product_rest(const Numbers& a, const Numbers& b, const Numbers& product) {
    return {_mm512_fmsub_pd(a.v, b.v, product.v)};
}

/// The lanes that are negative or -0.
LANCER_INLINE Mask negative(const Numbers& a) {
    return _mm512_movepi64_mask(_mm512_castpd_si512(a.v));
}
LANCER_INLINE Mask less(const Numbers& a, const Numbers& b) {
    return _mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ);
}
LANCER_INLINE Mask at_most(const Numbers& a, const Numbers& b) {
    return _mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ);
}
LANCER_INLINE Mask equal(const Numbers& a, const Numbers& b) {
    return _mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ);
}
LANCER_INLINE Numbers select(Mask mask, const Numbers& yes, const Numbers& no) {
    return {_mm512_mask_blend_pd(static_cast<__mmask8>(mask), no.v, yes.v)};
}
/// Stores the lanes of the mask contiguously at `to`, where there is room for eight.
LANCER_INLINE void store_packed(double* to, Mask mask, const Numbers& a) {
    _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(mask), a.v));
}
LANCER_INLINE void store_packed(std::uint32_t* to, Mask mask, const std::uint32_t* from) {
    const __m256i eight = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(mask), eight));
}
LANCER_INLINE void store_some(double* to, Mask mask, const Numbers& a) {
    _mm512_mask_storeu_pd(to, static_cast<__mmask8>(mask), a.v);
}

LANCER_INLINE Floats rounded(const Numbers& a) {
    return {_mm512_cvtpd_ps(a.v)};
}

LANCER_INLINE FloatPairs both(const Floats& a) {
    return {_mm512_broadcast_f32x8(a.v)};
}
/// Of eight numbers, eight[first] in all lanes of the first box and eight[first + 1] in all lanes
/// of the second.
LANCER_INLINE FloatPairs both(const float* eight, int first) {
    const __m512i at =
        _mm512_inserti32x8(_mm512_set1_epi32(first), _mm256_set1_epi32(first + 1), 1);
    return {_mm512_permutexvar_ps(at, _mm512_castps256_ps512(_mm256_loadu_ps(eight)))};
}
LANCER_INLINE Floats first_of(const FloatPairs& a) {
    return {_mm512_castps512_ps256(a.v)};
}
LANCER_INLINE Floats second_of(const FloatPairs& a) {
    return {_mm512_extractf32x8_ps(a.v, 1)};
}
LANCER_INLINE FloatPairs operator-(const FloatPairs& a, const FloatPairs& b) {
    return {_mm512_sub_ps(a.v, b.v)};
}
LANCER_INLINE FloatPairs operator*(const FloatPairs& a, const FloatPairs& b) {
    return {_mm512_mul_ps(a.v, b.v)};
}
LANCER_INLINE FloatPairs larger(const FloatPairs& a, const FloatPairs& b) {
    return {_mm512_max_ps(a.v, b.v)};
}
LANCER_INLINE FloatPairs smaller(const FloatPairs& a, const FloatPairs& b) {
    return {_mm512_min_ps(a.v, b.v)};
}
LANCER_INLINE FloatPairs where_negative(const FloatPairs& sign, const FloatPairs& yes,
                                        const FloatPairs& no) {
    return {_mm512_mask_blend_ps(_mm512_movepi32_mask(_mm512_castps_si512(sign.v)), no.v, yes.v)};
}
/// The lanes of the first box, then those of the second.
LANCER_INLINE Mask at_most(const FloatPairs& a, const FloatPairs& b) {
    return _mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ);
}

/// elementary::pow, by a function of the same library that gives the same bits.
LANCER_INLINE Numbers power(const Numbers& x, const Numbers& y) {
    return {Sleef_cinz_powd8_u10avx512fnofma(x.v, y.v)};
}
/// elementary::exp
LANCER_INLINE Numbers exponential(const Numbers& x) {
    return {Sleef_cinz_expd8_u10avx512fnofma(x.v)};
}
/// elementary::acos
LANCER_INLINE Numbers arc_cosine(const Numbers& x) {
    return {Sleef_cinz_acosd8_u10avx512fnofma(x.v)};
}

}  // namespace lancer::wide::LANCER_LEVEL
