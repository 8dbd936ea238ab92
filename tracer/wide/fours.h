// Four doubles: the triangles of a leaf, for one ray.
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
LANCER_INLINE Fours operator-(const Fours& a, const Fours& b) {
    return {_mm256_sub_pd(a.v, b.v)};
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
LANCER_INLINE Mask less(const Fours& a, const Fours& b) {
    return static_cast<Mask>(_mm256_movemask_pd(_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)));
}

}  // namespace lancer::wide::LANCER_LEVEL
