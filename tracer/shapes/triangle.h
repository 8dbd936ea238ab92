// Triangles, both single ones and those of meshes.
#pragma once

#include <limits>

#include "tracer/rays/crossing.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/shear.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/traits.h"

namespace lancer {

template <class Real>
struct TriangleSheet {
    Vec3<Real> a;
    Vec3<Real> b;
    Vec3<Real> c;
    Real transform_error =
        0;  ///< bound on how far rounding moved it when a transform put it into the world

    /// The largest absolute coordinate.
    Real reach() const {
        Vec3<Real> most = absolute(a);
        for (const Vec3<Real>& corner : {absolute(b), absolute(c)}) {
            for (int i = 0; i < 3; ++i) most[i] = corner[i] > most[i] ? corner[i] : most[i];
        }
        return max_component(most);
    }

    static constexpr SolidTraits traits{.convex = false, .face_by_face = true};
    /// The measure in its own space that must not be too small; infinite if there is none.
    Real size() const { return std::numeric_limits<Real>::infinity(); }
};

template <class Real>
struct TriangleHit {
    Real t;
    Real error;
    Real u;         ///< barycentric coordinate of b
    Real v;         ///< barycentric coordinate of c
    bool entering;  ///< the ray goes against the normal (b - a) x (c - a)
};

/// A bound on the error of t, the sum of three errors:
/// - The corners relative to the start are rounded once, and then by the shear. This acts as if
/// each
///   corner moved by E. The plane then moves at the hit by at most |n|.E, and t by this over |n.d|,
///   where n.d = det / d_z because the shear keeps volumes.
/// - The two products of an edge value have errors of 2u of their sizes. This changes the weights,
///   and t by the corners' distances in z from the hit.
/// - The weighted mean of the corners' z has an error of a few u of its terms.
template <class Real>
Real triangle_error(const Ray<Real>& ray, const Shear<Real>& s, Real transform_error,
                    const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c, Real det, Real t,
                    const Vec3<Real>& products, const Vec3<Real>& z) {
    using std::abs;
    const Vec3<Real> n = absolute(cross(b - a, c - a));
    Vec3<Real> size = absolute(a);
    for (const Vec3<Real>& corner : {absolute(b), absolute(c)}) {
        for (int i = 0; i < 3; ++i) size[i] = corner[i] > size[i] ? corner[i] : size[i];
    }
    // Relative to the start: one rounding. Sheared: a reciprocal, two products and a difference;
    // the first two count twice, because they also act as errors of the ray's direction.
    const Real along = size[s.z];
    const Real moved = n[s.x] * (2 * size[s.x] + 6 * abs(s.sx) * along) +
                       n[s.y] * (2 * size[s.y] + 6 * abs(s.sy) * along) + n[s.z] * along;
    const Real by_start = (ray.origin_error + transform_error) * (n.x + n.y + n.z);
    const Real weights = products.x * (abs(z.x - t) + abs(z.x)) +
                         products.y * (abs(z.y - t) + abs(z.y)) +
                         products.z * (abs(z.z - t) + abs(z.z));
    return ((unit_roundoff<Real> * moved + by_start) * abs(s.sz) + gamma<Real>(4) * weights) /
               abs(det) +
           gamma<Real>(3) * abs(t);
}

/// A triangle after the shear: the coordinates of its corners across the ray.
template <class Real>
struct Sheared {
    Real ax, ay, bx, by, cx, cy;

    /// \param a, b, c  the corners relative to the ray's start
    Sheared(const Shear<Real>& s, const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c)
        : ax(a[s.x] - s.sx * a[s.z]),
          ay(a[s.y] - s.sy * a[s.z]),
          bx(b[s.x] - s.sx * b[s.z]),
          by(b[s.y] - s.sy * b[s.z]),
          cx(c[s.x] - s.sx * c[s.z]),
          cy(c[s.y] - s.sy * c[s.z]) {}

    /// Whether the ray misses: the edge functions have both signs, by more than `noise`.
    bool passes_by(Real noise) const {
        const Real u = cx * by - cy * bx;
        const Real v = ax * cy - ay * cx;
        const Real w = bx * ay - by * ax;
        const Real uv_least = u < v ? u : v;
        const Real uv_most = u < v ? v : u;
        const Real least = uv_least < w ? uv_least : w;
        const Real most = uv_most > w ? uv_most : w;
        return least < -noise && most > noise;
    }
};

/// The watertight intersection. If two triangles share an edge, a line that passes between their
/// other corners hits at least one of them, because both compute the same products at the shared
/// edge, and 0 counts as inside. Source: Woop, Benthin, Wald, "Watertight Ray/Triangle
/// Intersection", JCGT 2(1) 2013. If the products of an edge value are equal, its exact sign
/// follows from their rounding errors; the paper uses a wider type there.
///
/// Also returns false for a hit outside of the interval.
template <class Real, class Last>
[[gnu::noinline]] bool intersect_exactly(const TriangleSheet<Real>& triangle, const Ray<Real>& ray,
                                         const Shear<Real>& s,
                                         const RayInterval<Real, Last>& interval,
                                         TriangleHit<Real>& hit) {
    using std::abs;
    const Vec3<Real> a = -start_from(ray, triangle.a);
    const Vec3<Real> b = -start_from(ray, triangle.b);
    const Vec3<Real> c = -start_from(ray, triangle.c);
    const Sheared<Real> p(s, a, b, c);
    const Real u = signed_difference_of_products(p.cx, p.by, p.cy, p.bx);
    const Real v = signed_difference_of_products(p.ax, p.cy, p.ay, p.cx);
    const Real w = signed_difference_of_products(p.bx, p.ay, p.by, p.ax);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const Real det = u + v + w;
    if (det == 0) return false;
    const Real az = s.sz * a[s.z];
    const Real bz = s.sz * b[s.z];
    const Real cz = s.sz * c[s.z];
    const Real t = (u * az + v * bz + w * cz) / det;

    if (interval.ends_before(t)) return false;

    hit.t = t;
    hit.error =
        triangle_error(ray, s, triangle.transform_error, a, b, c, det, t,
                       {abs(p.cx * p.by) + abs(p.cy * p.bx), abs(p.ax * p.cy) + abs(p.ay * p.cx),
                        abs(p.bx * p.ay) + abs(p.by * p.ax)},
                       {az, bz, cz});
    hit.u = v / det;
    hit.v = w / det;
    hit.entering = det > 0;
    return t + hit.error >= interval.first;
}

/// A corner relative to the ray's start, for filters: the plain difference, or the exact one if it
/// is as cheap.
template <class Real>
[[gnu::always_inline]] inline Vec3<Real> about_from_start(const Ray<Real>& ray,
                                                          const Vec3<Real>& corner) {
    if constexpr (has_fast_wider<Real>) return -start_from(ray, corner);
    return corner - ray.origin;
}

/// The filter: false if the ray certainly misses the triangle. See edge_noise().
template <class Real>
[[gnu::always_inline]] inline bool may_meet(const TriangleSheet<Real>& triangle,
                                            const Ray<Real>& ray, const Shear<Real>& s) {
    return !Sheared<Real>(s, about_from_start(ray, triangle.a), about_from_start(ray, triangle.b),
                          about_from_start(ray, triangle.c))
                .passes_by(s.noise);
}

/// The same as intersect_exactly(), after the filter.
template <class Real, class Last>
bool intersect(const TriangleSheet<Real>& triangle, const Ray<Real>& ray, const Shear<Real>& s,
               const RayInterval<Real, Last>& interval, TriangleHit<Real>& hit) {
    return may_meet(triangle, ray, s) && intersect_exactly(triangle, ray, s, interval, hit);
}

/// A bound on the distance of a point, computed as u ab + v ac, from the plane of the edges `ab`
/// and `ac`. Each component has an error of a few u of its terms, including the rounding of the
/// edges. Only the part of this error along the normal counts; for a face along the axes it is 0.
/// The rounding error of the normal is included. If it is as large as the normal, as for a needle,
/// a bound without the normal is used.
template <class Real>
Real weighted_point_error(const Vec3<Real>& ab, const Vec3<Real>& ac, const Vec3<Real>& normal,
                          Real u, Real v) {
    using std::abs;
    const Vec3<Real> b = absolute(ab);
    const Vec3<Real> c = absolute(ac);
    const Real anyhow = gamma<Real>(5) * (max_component(b) + max_component(c));
    const Vec3<Real> off(b.y * c.z + b.z * c.y, b.z * c.x + b.x * c.z, b.x * c.y + b.y * c.x);
    const Vec3<Real> n = absolute(normal);
    const Real least = max_component(n) - gamma<Real>(4) * max_component(off);
    if (!(least > 0)) return anyhow;
    const Vec3<Real> terms = abs(u) * b + abs(v) * c;
    const Real along = gamma<Real>(6) * dot(n + gamma<Real>(4) * off, terms) / least;
    return along < anyhow ? along : anyhow;
}

/// The point of the triangle at these barycentric coordinates. It does not depend on the ray, so it
/// is exact however far away the ray started.
template <class Real>
SurfacePoint<Real> triangle_point(const TriangleSheet<Real>& triangle, Real u, Real v) {
    const Vec3<Real> ab = triangle.b - triangle.a;
    const Vec3<Real> ac = triangle.c - triangle.a;
    const Vec3<Real> normal = cross(ab, ac);
    const Vec3<Real> offset = u * ab + v * ac;
    const Real error = weighted_point_error(ab, ac, normal, u, v);
    return {triangle.a, offset, error, normal, normal, Vec2<Real>(u, v)};
}

}  // namespace lancer
