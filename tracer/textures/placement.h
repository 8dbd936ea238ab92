// The placement of a texture on a primitive: from the tracer's space to the texture's own space.
#pragma once

#include "model/affine.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/surface_point.h"

namespace lancer {

/// A point of texture space, and bounds on the rounding errors of its coordinates.
template <class Real>
struct PatternPoint {
    Vec3<Real> at;
    Vec3<Real> bound;
};

/// The integer part of x; if x is below an integer by no more than its bound, that integer. So a
/// floor at y = 0 lies in one layer of a checker's cubes, whatever the last bits of its points are.
template <class Real>
Real whole_part(Real x, Real bound) {
    using std::floor;
    return floor(x + bound);
}

/// The map from the space of a primitive's SurfacePoints, which is scaled and may be the world, to
/// the space in which a texture is defined.
template <class Real>
struct Placement {
    Affine<Real> map;    ///< of points relative to `from`
    Vec3<Real> bound{};  ///< how far rounding may have moved the primitive or the texture
    Vec3<Real> from{};   ///< a point with the texture: its origin, or that of the object
};

template <class Real>
PatternPoint<Real> place(const Placement<Real>& placement, const SurfacePoint<Real>& p) {
    const Affine<Real>& m = placement.map;
    // Relative to a point that moves with the texture, the point is the same wherever both are.
    const Vec3<Real> anchor = (p.anchor - placement.from) + p.rest;
    PatternPoint<Real> point{map_point(m, anchor) + map_vector(m, p.offset), placement.bound};
    // Entries of the matrix, products and sums each have a few roundings.
    constexpr Real roundings = gamma<Real>(16);
    const Vec3<Real> reach =
        Vec3<Real>(p.error) + roundings * (absolute(anchor) + absolute(p.offset));
    point.bound += map_bound(m, reach);
    return point;
}

}  // namespace lancer
