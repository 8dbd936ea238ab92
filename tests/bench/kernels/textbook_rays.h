// Rays whose start is one rounded number and that precompute only reciprocals. Must be included
// before code that calls these functions with vectors alone, because such calls find only functions
// that are already declared.
#pragma once

#include "tests/bench/kernels/textbook_methods.h"
#include "tracer/rays/frame.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/shear.h"

namespace lancer {

/// Moeller and Trumbore's test needs no shear.
template <methods::Shapes Real>
Shear<Real> shear_of(const Ray<Real>&) {
    return {};
}

template <methods::Places Real>
[[gnu::always_inline]] inline DoubleWordVector<Real> two_sum(const Vec3<Real>& a,
                                                             const Vec3<Real>& b) {
    return {a + b, Vec3<Real>(0)};
}

template <methods::Places Real>
[[gnu::always_inline]] inline Vec3<Real> start_from(const Ray<Real>& ray, const Vec3<Real>& point) {
    return ray.origin - point;
}

template <methods::Places Real>
Real lost_from_start(const Ray<Real>&, const Vec3<Real>&, int) {
    return 0;
}

template <methods::Places Real>
[[gnu::always_inline]] inline Vec3<Real> difference(const Vec3<Real>& hi, const Vec3<Real>&,
                                                    const Vec3<Real>& point) {
    return hi - point;
}

template <methods::Places Real>
Vec3<Real> unit(const Vec3<Real>& v) {
    return normalize(v);
}

template <methods::Places Real>
Ray<Real> to_local(const Ray<Real>& ray, const Frame<Real>& frame) {
    return make_ray(map_vector(frame.linear_inverse, ray.origin - frame.to_world.shift),
                    Vec3<Real>(0), map_vector(frame.linear_inverse, ray.dir), Real(0));
}

}  // namespace lancer
