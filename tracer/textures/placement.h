// Where a texture lies on a primitive: from the tracer's space back to the texture's own.
#pragma once

#include "model/affine.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/surface_point.h"

namespace lancer {

/// A point of texture space, and how far rounding may have carried each coordinate.
template <class Real>
struct PatternPoint {
    Vec3<Real> at;
    Vec3<Real> bound;
};

/// The whole number that x belongs to: below, or at, or above by no more than its bound. So a
/// floor at y = 0 lies in one row of a checker's cubes, whatever the last bit of its points says.
template <class Real>
Real whole_part(Real x, Real bound) {
    using std::floor;
    return floor(x + bound);
}

/// From the space of a primitive's `SurfacePoint`s, scaled and perhaps baked into the world, to a
/// space in which a texture is defined.
template <class Real>
struct Placement {
    Affine<Real> map;
    Vec3<Real> bound{};  ///< what the rounding of the primitive's own place adds
};

template <class Real>
PatternPoint<Real> place(const Placement<Real>& placement, const SurfacePoint<Real>& p) {
    const Affine<Real>& m = placement.map;
    // The anchor first: it and the shift may be large and cancel, and the offset is then added to a
    // small number.
    PatternPoint<Real> point{map_point(m, p.anchor) + map_vector(m, p.offset), placement.bound};
    // An entry of the matrix errs by a few roundings of itself, as do the products and sums.
    constexpr Real roundings = gamma<Real>(16);
    const Vec3<Real> reach =
        Vec3<Real>(p.error) + roundings * (absolute(p.anchor) + absolute(p.offset));
    point.bound += map_bound(m, reach);
    return point;
}

}  // namespace lancer
