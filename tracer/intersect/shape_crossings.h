// One function for the crossings of a ray with any shape except composites.
#pragma once

#include "tracer/rays/crossing.h"
#include "tracer/rays/shear.h"
#include "tracer/scene/geometry.h"

namespace lancer {

/// Reports the crossings of the ray with a shape in the shape's own space: report(Crossing, u, v),
/// which returns true to stop.
template <class S, class Real, class Last, class Report>
[[gnu::always_inline]] inline void shape_crossings(const S& shape, const Ray<Real>& ray,
                                                   const IntersectionHints& hints,
                                                   const RayInterval<Real, Last>& interval,
                                                   Report& report) {
    if constexpr (std::is_same_v<S, MeshInstance<Real>> || std::is_same_v<S, PatchSolid<Real>> ||
                  std::is_same_v<S, BicubicSolid<Real>> || std::is_same_v<S, FacetSolid<Real>>) {
        crossings(shape, ray, hints, interval, report);
    } else if constexpr (std::is_same_v<S, TriangleSheet<Real>>) {
        TriangleHit<Real> hit;
        Shear<Real> shear = shear_of(ray);
        shear.noise = edge_noise(ray, shape.reach());
        if (intersect(shape, ray, shear, interval, hit))
            report(Crossing<Real>{hit.t, hit.error, 0, hit.entering}, hit.u, hit.v);
    } else {
        crossings(shape, ray, hints, interval,
                  [&](const Crossing<Real>& c) { report(c, Real(0), Real(0)); });
    }
}

}  // namespace lancer
