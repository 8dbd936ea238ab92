// Triangles: alone, and in meshes that share their vertices.
#pragma once

#include "tracer/ray.h"

namespace lancer {

template <class Real>
struct TriangleSheet {
    Vec3<Real> a;
    Vec3<Real> b;
    Vec3<Real> c;
};

template <class Real>
struct TriangleHit {
    Real t;
    Real error;
    Real u;         ///< weight of b
    Real v;         ///< weight of c
    bool entering;  ///< against the normal (b - a) x (c - a)
};

/// Watertight: of two triangles that share an edge, a line that passes between their other corners
/// hits at least one, because both form the same products at the shared edge and zero counts as
/// inside. Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1) 2013; an
/// edge value whose products are equal takes its exact sign from their rounding errors, where the
/// paper goes to a wider type.
template <class Real>
bool intersect(const TriangleSheet<Real>& triangle, const Ray<Real>& ray, TriangleHit<Real>& hit) {
    using std::abs;
    const Shear<Real>& s = ray.shear;
    const Vec3<Real> a = -start_from(ray, triangle.a);
    const Vec3<Real> b = -start_from(ray, triangle.b);
    const Vec3<Real> c = -start_from(ray, triangle.c);
    const Real ax = a[s.x] - s.sx * a[s.z];
    const Real ay = a[s.y] - s.sy * a[s.z];
    const Real bx = b[s.x] - s.sx * b[s.z];
    const Real by = b[s.y] - s.sy * b[s.z];
    const Real cx = c[s.x] - s.sx * c[s.z];
    const Real cy = c[s.y] - s.sy * c[s.z];
    const Real u = signed_difference_of_products(cx, by, cy, bx);
    const Real v = signed_difference_of_products(ax, cy, ay, cx);
    const Real w = signed_difference_of_products(bx, ay, by, ax);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const Real det = u + v + w;
    if (det == 0) return false;
    const Real az = s.sz * a[s.z];
    const Real bz = s.sz * b[s.z];
    const Real cz = s.sz * c[s.z];
    const Real t = (u * az + v * bz + w * cz) / det;

    // The weights have one sign, so the quotient itself is good to a few roundings of t. What the
    // rounded corners add: each coordinate errs by at most `place`, which moves the weights, and
    // the hit along the triangle's slope.
    Real size = max_component(absolute(a));
    const Real size_b = max_component(absolute(b));
    const Real size_c = max_component(absolute(c));
    if (size_b > size) size = size_b;
    if (size_c > size) size = size_c;
    const Real place = ray.origin_error + gamma<Real>(3) * size;
    const Real slope = abs(az - t) * (abs(bx) + abs(by) + abs(cx) + abs(cy)) +
                       abs(bz - t) * (abs(ax) + abs(ay) + abs(cx) + abs(cy)) +
                       abs(cz - t) * (abs(ax) + abs(ay) + abs(bx) + abs(by));
    hit.t = t;
    hit.error = gamma<Real>(6) * abs(t) + place * slope / abs(det) + ray.origin_error * abs(s.sz);
    hit.u = v / det;
    hit.v = w / det;
    hit.entering = det > 0;
    return true;
}

/// The point of the triangle with these weights: on it, however far away the ray started.
template <class Real>
SurfacePoint<Real> triangle_point(const TriangleSheet<Real>& triangle, Real u, Real v) {
    const Vec3<Real> ab = triangle.b - triangle.a;
    const Vec3<Real> ac = triangle.c - triangle.a;
    const Vec3<Real> normal = cross(ab, ac);
    const Vec3<Real> offset = u * ab + v * ac;
    const Real error = gamma<Real>(5) * (max_component(absolute(ab)) + max_component(absolute(ac)));
    return {triangle.a, offset, error, normal, normal, Vec2<Real>(u, v)};
}

}  // namespace lancer
