// The shear that turns a ray into an axis, for triangles.
#pragma once

#include <limits>
#include <utility>

#include "tracer/rays/ray.h"

namespace lancer {

/// Woop's shear: turns the ray into the +z axis, so that a triangle test is three 2-D edge
/// functions. Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1) 2013,
/// section 3.
template <class Real>
struct Shear {
    int x = 0;  ///< axes after the permutation that makes z the ray's longest component
    int y = 1;
    int z = 2;
    Real sx = 0;
    Real sy = 0;
    Real sz = 1;
    /// Bound on the error of a triangle's edge function by plain differences: edge_noise().
    Real noise = std::numeric_limits<Real>::infinity();
};

/// The shear is the same for all triangles that the ray meets, so adjacent triangles agree.
template <class Real>
Shear<Real> shear_of(const Ray<Real>& ray) {
    using std::abs;
    const Vec3<Real>& dir = ray.dir;
    Shear<Real> s;
    const Real ax = abs(dir.x);
    const Real ay = abs(dir.y);
    const Real az = abs(dir.z);
    s.z = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
    s.x = (s.z + 1) % 3;
    s.y = (s.z + 2) % 3;
    if (dir[s.z] < 0) std::swap(s.x, s.y);  // keeps the winding
    s.sz = ray.inv_dir[s.z];
    s.sx = dir[s.x] * s.sz;
    s.sy = dir[s.y] * s.sz;
    return s;
}

/// A bound on the difference between a triangle's edge function by plain differences and by exact
/// ones. Let S be the size of start and corners, from their filter errors. Plain differences have
/// an error of 18 u S, sheared coordinates (up to 2 S) of 43 u S, and the difference of two of
/// their products of 360 u S^2; from exact differences it is 72 u S^2. If the start has no low
/// part, both are equal. If exact differences are as cheap, about_from_start() uses them anyway.
///
/// \param reach  bound on the corners' coordinates
template <class Real>
Real edge_noise(const Ray<Real>& ray, Real reach) {
    if (ray.whole || has_fast_wider<Real>) return 0;
    const Real size = reach + size_of_place(ray.filter_error);
    return gamma<Real>(512) * size * size;
}

}  // namespace lancer
