// The point of a hit, for each kind of solid.
#pragma once

#include "tracer/intersect/local_point.h"

namespace lancer {

template <class Real>
SurfacePoint<Real> local_point(const Geometry<Real>& geometry, const Primitive<Real>& primitive,
                               const Ray<Real>& ray, const Hit<Real>& hit) {
    return std::visit(
        [&](const auto& solid) -> SurfacePoint<Real> {
            using S = std::decay_t<decltype(solid)>;
            if constexpr (std::is_same_v<S, MeshInstance<Real>>) {
                SurfacePoint<Real> p =
                    triangle_point(solid.mesh->triangle(hit.surface.face), hit.u, hit.v);
                p.shading = shading_normal(solid, hit.surface.face, hit.u, hit.v, p.normal);
                return p;
            } else if constexpr (std::is_same_v<S, PatchSolid<Real>>) {
                return patch_point(solid, hit.surface.face, hit.u, hit.v);
            } else if constexpr (std::is_same_v<S, BicubicSolid<Real>>) {
                return bicubic_point(solid, hit.surface.face, hit.u, hit.v);
            } else if constexpr (std::is_same_v<S, FacetSolid<Real>>) {
                return facet_point(solid, hit.surface.face, hit.u, hit.v);
            } else if constexpr (std::is_same_v<S, TriangleSheet<Real>>) {
                SurfacePoint<Real> p = triangle_point(solid, hit.u, hit.v);
                if (primitive.corner_normals != none) {
                    const auto& n = geometry.corner_normals[primitive.corner_normals];
                    p.shading = (1 - hit.u - hit.v) * n[0] + hit.u * n[1] + hit.v * n[2];
                }
                return p;
            } else if constexpr (std::is_same_v<S, CompositeSolid<Real>>) {
                return {};  // never reached: hits of a composite belong to its leaves
            } else {
                return surface_point(solid, ray, hit.t, hit.surface.face);
            }
        },
        primitive.solid);
}

}  // namespace lancer
