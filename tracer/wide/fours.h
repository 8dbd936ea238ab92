// Four doubles for one ray: one number for each triangle of a leaf, or three coordinates and 0.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

struct Fours {
    __m256d v;
};

LANCER_INLINE Fours four(double x) {
    return {_mm256_set1_pd(x)};
}
LANCER_INLINE Fours four(const double* from) {
    return {_mm256_loadu_pd(from)};
}
/// Three coordinates, and 0.
LANCER_INLINE Fours three(const double* from) {
    return {_mm256_maskload_pd(from, _mm256_setr_epi64x(-1, -1, -1, 0))};
}
LANCER_INLINE void store(double* to, const Fours& a) {
    _mm256_storeu_pd(to, a.v);
}
LANCER_INLINE Fours operator+(const Fours& a, const Fours& b) {
    return {_mm256_add_pd(a.v, b.v)};
}
LANCER_INLINE Fours operator-(const Fours& a, const Fours& b) {
    return {_mm256_sub_pd(a.v, b.v)};
}
LANCER_INLINE Fours operator-(const Fours& a) {
    return {_mm256_xor_pd(a.v, _mm256_set1_pd(-0.0))};
}
LANCER_INLINE Fours operator/(const Fours& a, const Fours& b) {
    return {_mm256_div_pd(a.v, b.v)};
}
LANCER_INLINE Fours absolute(const Fours& a) {
    return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v)};
}
/// `yes` in the lanes where `sign` is negative or -0, else `no`.
LANCER_INLINE Fours where_negative(const Fours& sign, const Fours& yes, const Fours& no) {
    return {_mm256_blendv_pd(no.v, yes.v, sign.v)};
}
/// One of the four in all lanes.
template <int at>
LANCER_INLINE Fours only(const Fours& a) {
    return {_mm256_permute4x64_pd(a.v, at * 0x55)};
}
LANCER_INLINE Fours operator*(const Fours& a, const Fours& b) {
    return {_mm256_mul_pd(a.v, b.v)};
}
LANCER_INLINE Fours larger(const Fours& a, const Fours& b) {
    return {_mm256_max_pd(a.v, b.v)};
}
LANCER_INLINE Fours smaller(const Fours& a, const Fours& b) {
    return {_mm256_min_pd(a.v, b.v)};
}
LANCER_INLINE Mask negative(const Fours& a) {
    return static_cast<Mask>(_mm256_movemask_pd(a.v));
}
LANCER_INLINE Mask equal(const Fours& a, const Fours& b) {
    return static_cast<Mask>(_mm256_movemask_pd(_mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ)));
}
LANCER_INLINE Mask less(const Fours& a, const Fours& b) {
    return static_cast<Mask>(_mm256_movemask_pd(_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)));
}

LANCER_INLINE double first(const Fours& a) {
    return _mm256_cvtsd_f64(a.v);
}
/// The largest of all four. None may be NaN.
LANCER_INLINE double largest(const Fours& a) {
    const __m128d pair = _mm_max_pd(_mm256_castpd256_pd128(a.v), _mm256_extractf128_pd(a.v, 1));
    return _mm_cvtsd_f64(_mm_max_sd(pair, _mm_unpackhi_pd(pair, pair)));
}
LANCER_INLINE double smallest(const Fours& a) {
    const __m128d pair = _mm_min_pd(_mm256_castpd256_pd128(a.v), _mm256_extractf128_pd(a.v, 1));
    return _mm_cvtsd_f64(_mm_min_sd(pair, _mm_unpackhi_pd(pair, pair)));
}

struct FourFloats {
    __m128 v;
};

LANCER_INLINE FourFloats four(float x) {
    return {_mm_set1_ps(x)};
}
LANCER_INLINE FourFloats rounded(const Fours& a) {
    return {_mm256_cvtpd_ps(a.v)};
}
LANCER_INLINE void store(float* to, const FourFloats& a) {
    _mm_storeu_ps(to, a.v);
}
LANCER_INLINE FourFloats operator+(const FourFloats& a, const FourFloats& b) {
    return {_mm_add_ps(a.v, b.v)};
}
LANCER_INLINE FourFloats operator-(const FourFloats& a, const FourFloats& b) {
    return {_mm_sub_ps(a.v, b.v)};
}
LANCER_INLINE FourFloats operator*(const FourFloats& a, const FourFloats& b) {
    return {_mm_mul_ps(a.v, b.v)};
}
LANCER_INLINE FourFloats absolute(const FourFloats& a) {
    return {_mm_andnot_ps(_mm_set1_ps(-0.0F), a.v)};
}
/// `size`, which is not negative, with the sign of `sign`.
LANCER_INLINE FourFloats with_sign(const FourFloats& size, const FourFloats& sign) {
    return {_mm_or_ps(size.v, _mm_and_ps(sign.v, _mm_set1_ps(-0.0F)))};
}
LANCER_INLINE Mask at_most(const FourFloats& a, const FourFloats& b) {
    return static_cast<Mask>(_mm_movemask_ps(_mm_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}

}  // namespace lancer::wide::LANCER_LEVEL
