// Frames: objects' own spaces.
#pragma once

#include "model/affine.h"
#include "tracer/rays/ray.h"

namespace lancer {

/// An object's own space, for shapes that a world-space primitive cannot express.
template <class Real>
struct Frame {
    Affine<Real> to_world;
    Affine<Real> linear_inverse;  ///< the inverse of the linear part; `shift` is 0
    Real norm;                    ///< largest absolute row sum of the linear part
    Real inverse_norm;            ///< the same for the inverse
    Real transform_error =
        0;  ///< bound, in the world, on how far rounding moved objects in this space
    bool keeps_digits = false;  ///< the linear part is a power of two, so it maps vectors exactly
};

/// A bound on the rounding error of mapping a point. It is `by_map`, which grows with the
/// coordinates. If the map keeps all digits, it is only the rounding of `low`, the sum of the
/// point's low parts. So a translation that changes no digit of the coordinates never changes which
/// hits are one contact.
template <class Real>
Real mapping_error(const Frame<Real>& frame, Real by_map, const Vec3<Real>& low) {
    return frame.keeps_digits ? gamma<Real>(2) * max_component(absolute(low)) : by_map;
}

/// The ray in the frame's space, with the same parameter t.
template <class Real>
Ray<Real> to_local(const Ray<Real>& ray, const Frame<Real>& frame) {
    // Both parts of the start are kept. So a map with a power of two as its linear part loses
    // nothing. What another map rounds depends on how the parts share the digits: the start from
    // the frame's place is normalised, so that it is the same wherever the frame is.
    const DoubleWordVector<Real> about = two_sum(ray.origin, -frame.to_world.shift);
    const Vec3<Real> low = about.lo + ray.origin_lo;
    const DoubleWordVector<Real> start = normalized(about.hi, low);
    // Three products and two sums per component, with rounded entries.
    const Real by_map = gamma<Real>(6) * max_component(absolute(start.hi));
    const Real error = frame.inverse_norm * (ray.origin_error + frame.transform_error +
                                             mapping_error(frame, by_map, low));
    const DoubleWordVector<Real> local = normalized(map_vector(frame.linear_inverse, start.hi),
                                                    map_vector(frame.linear_inverse, start.lo));
    return make_ray(local.hi, local.lo, map_vector(frame.linear_inverse, ray.dir), error);
}

}  // namespace lancer
