// How it is found whether a ray begins in a body.
#pragma once

#include "tracer/intersect/candidates.h"
#include "tracer/intersect/starts_inside.h"

namespace lancer {

template <class Real>
bool starts_inside(const Geometry<Real>& geometry, std::uint32_t index, const Ray<Real>& ray) {
    const Primitive<Real>& p = geometry.primitives[index];
    if (const auto* half = std::get_if<HalfSpace<Real>>(&p.solid)) {
        using std::abs;
        const Vec3<Real> rel = start_from(ray, half->point);
        const Real height = dot(half->normal, rel);
        const Real bound =
            ray.origin_error + gamma<Real>(4) * dot(absolute(half->normal), absolute(rel));
        if (abs(height) > bound) return height < 0;
        return dot(half->normal, ray.dir) < 0;
    }
    if (const CompositeTree<Real>* tree = p.composite()) {
        const Start<Real> here;
        const CompositeStart<Real> known{&here, index};
        return CompositeWalk<Real>(*tree, ray, known).starts_inside();
    }
    int balance = 0;  // exits minus entries ahead
    primitive_crossings(geometry, p, ray, IntersectionHints{}, whole_line<Real>(),
                        [&](const Crossing<Real>& c, Real, Real) {
                            if (c.t > c.error) balance += c.entering ? -1 : 1;
                            return false;
                        });
    return balance > 0;
}

}  // namespace lancer
