// The five shapes by textbook formulas. A hit of the surface on which the ray starts is recognized
// by its distance, t <= epsilon. There are no error bounds, no scaling and no exact methods.
// Glassner (ed.), An Introduction to Ray Tracing (1989), ch. 2; Moeller, Trumbore, "Fast, minimum
// storage ray-triangle intersection", JGT 2(1) 1997.
#pragma once

#include "tests/bench/kernels/textbook_rays.h"
#include "tracer/rays/crossing.h"
#include "tracer/rays/shear.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shading/surface.h"

namespace lancer {

/// Worlds have an extent near 1 (tracer/compile/scale.h).
inline constexpr double textbook_epsilon = 1e-9;

template <methods::Shapes Real, class Last, class Report>
void report_beyond_start(Real t, std::uint32_t face, bool entering, const IntersectionHints& hints,
                         const RayInterval<Real, Last>& interval, Report&& report) {
    if (hints.start_face != none && t < textbook_epsilon && t > -textbook_epsilon) return;
    if (t > interval.first && !interval.ends_before(t))
        report(Crossing<Real>{t, textbook_epsilon, face, entering});
}

template <methods::Shapes Real, class Last, class Report>
void crossings(const BallSolid<Real>& ball, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    const Vec3<Real> f = start_from(ray, ball.center);
    const Real a = ray.dir_squared;
    const Real b = dot(f, ray.dir);
    const Real c = dot(f, f) - ball.radius * ball.radius;
    const Real discriminant = b * b - a * c;
    if (discriminant < 0) return;
    const Real root = sqrt(discriminant);
    report_beyond_start((-b - root) / a, 0, true, hints, interval, report);
    report_beyond_start((-b + root) / a, 0, false, hints, interval, report);
}

template <methods::Shapes Real>
SurfacePoint<Real> textbook_point(const Ray<Real>& ray, Real t, const Vec3<Real>& normal) {
    return {ray.origin, t * ray.dir, Real(0), normal, normal, Vec2<Real>(0)};
}

template <methods::Shapes Real>
SurfacePoint<Real> surface_point(const BallSolid<Real>& ball, const Ray<Real>& ray, Real t,
                                 std::uint32_t) {
    return textbook_point(ray, t, start_from(ray, ball.center) + t * ray.dir);
}

template <methods::Shapes Real, class Last, class Report>
void crossings(const BoxSolid<Real>& box, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    const Vec3<Real> from_min = start_from(ray, box.min);
    const Vec3<Real> from_max = start_from(ray, box.max);
    Real in = -std::numeric_limits<Real>::infinity();
    Real out = std::numeric_limits<Real>::infinity();
    std::uint32_t in_face = 0;
    std::uint32_t out_face = 0;
    for (int axis = 0; axis < 3; ++axis) {
        Real near = -from_min[axis] * ray.inv_dir[axis];
        Real far = -from_max[axis] * ray.inv_dir[axis];
        bool forward = true;
        if (near > far) {
            std::swap(near, far);
            forward = false;
        }
        if (near > in) {
            in = near;
            in_face = box_face(axis, !forward);
        }
        if (far < out) {
            out = far;
            out_face = box_face(axis, forward);
        }
    }
    if (in > out) return;
    report_beyond_start(in, in_face, true, hints, interval, report);
    report_beyond_start(out, out_face, false, hints, interval, report);
}

template <methods::Shapes Real>
SurfacePoint<Real> surface_point(const BoxSolid<Real>&, const Ray<Real>& ray, Real t,
                                 std::uint32_t face) {
    Vec3<Real> normal(0);
    normal[static_cast<int>(face / 2)] = face % 2 == 1 ? 1 : -1;
    return textbook_point(ray, t, normal);
}

template <methods::Shapes Real, class Last, class Report>
void crossings(const HalfSpace<Real>& half, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    const Real slope = dot(half.normal, ray.dir);
    if (slope == 0) return;
    report_beyond_start(-dot(half.normal, start_from(ray, half.point)) / slope, 0, slope < 0, hints,
                        interval, report);
}

template <methods::Shapes Real>
SurfacePoint<Real> surface_point(const HalfSpace<Real>& half, const Ray<Real>& ray, Real t,
                                 std::uint32_t) {
    return textbook_point(ray, t, half.normal);
}

/// Four at once up to the weights, times the square of the determinant: no division.
template <methods::Shapes Real>
[[gnu::always_inline]] inline unsigned may_meet(const TriangleLeaf<Real>& leaf,
                                                const Ray<Real>& ray, const Shear<Real>&) {
    using Place = std::array<Four<Real>, 3>;
    const auto cross = [](const Place& a, const Place& b) {
        return Place{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0]};
    };
    const auto dot = [](const Place& a, const Place& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const auto from_a = [&](const std::array<std::array<Real, 4>, 3>& to) {
        const auto& a = leaf.corner[0];
        return Place{Four<Real>(to[0]) - Four<Real>(a[0]), Four<Real>(to[1]) - Four<Real>(a[1]),
                     Four<Real>(to[2]) - Four<Real>(a[2])};
    };
    const auto all = [](const Vec3<Real>& v) {
        return Place{Four<Real>(v.x), Four<Real>(v.y), Four<Real>(v.z)};
    };
    const Place ab = from_a(leaf.corner[1]);
    const Place ac = from_a(leaf.corner[2]);
    const Place dir = all(ray.dir);
    const Place p = cross(dir, ac);
    const Four<Real> det = dot(ab, p);
    const auto& a = leaf.corner[0];
    const Place start = all(ray.origin);
    const Place rel{start[0] - Four<Real>(a[0]), start[1] - Four<Real>(a[1]),
                    start[2] - Four<Real>(a[2])};
    const Four<Real> u = dot(rel, p) * det;
    const Four<Real> v = dot(dir, cross(rel, ab)) * det;
    return at_most(Four<Real>(Real(0)), smaller(smaller(u, v), det * det - u - v));
}

template <methods::Shapes Real, class Last>
bool intersect_exactly(const TriangleSheet<Real>& triangle, const Ray<Real>& ray,
                       const Shear<Real>&, const RayInterval<Real, Last>& interval,
                       TriangleHit<Real>& hit) {
    const Vec3<Real> ab = triangle.b - triangle.a;
    const Vec3<Real> ac = triangle.c - triangle.a;
    const Vec3<Real> p = cross(ray.dir, ac);
    const Real det = dot(ab, p);
    if (det == 0) return false;
    const Real inverse_det = 1 / det;
    const Vec3<Real> rel = start_from(ray, triangle.a);
    hit.u = dot(rel, p) * inverse_det;
    if (hit.u < 0 || hit.u > 1) return false;
    const Vec3<Real> q = cross(rel, ab);
    hit.v = dot(ray.dir, q) * inverse_det;
    if (hit.v < 0 || hit.u + hit.v > 1) return false;
    hit.t = dot(ac, q) * inverse_det;
    hit.error = textbook_epsilon;
    hit.entering = det > 0;
    return hit.t > interval.first && !interval.ends_before(hit.t);
}

template <methods::Shapes Real, class Last>
bool intersect(const TriangleSheet<Real>& triangle, const Ray<Real>& ray, const Shear<Real>& shear,
               const RayInterval<Real, Last>& interval, TriangleHit<Real>& hit) {
    return intersect_exactly(triangle, ray, shear, interval, hit);
}

template <methods::Shapes Real, class Last, class Report>
void crossings(const FrustumSolid<Real>& f, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const Vec3<Real> start = start_from(ray, f.small_end);
    const Real axial = dot(f.axis, start);
    const Real rate = dot(f.axis, ray.dir);
    const Vec3<Real> o = start - axial * f.axis;
    const Vec3<Real> d = ray.dir - rate * f.axis;
    const Real radius = f.radius + f.slope * axial;
    const Real widening = f.slope * rate;
    const Real a = dot(d, d) - widening * widening;
    const Real b = dot(o, d) - radius * widening;
    const Real c = dot(o, o) - radius * radius;
    const Real discriminant = b * b - a * c;
    Real small = -axial / rate;
    Real large = (f.height - axial) / rate;
    std::uint32_t in_face = frustum_face::small_cap;
    std::uint32_t out_face = frustum_face::large_cap;
    if (rate == 0) {
        if (axial < 0 || axial > f.height) return;
        small = -infinity;
        large = infinity;
    } else if (rate < 0) {
        std::swap(small, large);
        std::swap(in_face, out_face);
    }
    if (discriminant < 0) return;
    const Real root = sqrt(discriminant);
    Real near = (-b - root) / a;
    Real far = (-b + root) / a;
    if (a < 0) {  // along the side or steeper: inside beyond the roots, on the wider nappe
        near = rate > 0 ? near : -infinity;
        far = rate > 0 ? infinity : far;
    }
    if (!f.capped) {
        if (near >= small && near <= large)
            report_beyond_start(near, frustum_face::side, true, hints, interval, report);
        if (far >= small && far <= large)
            report_beyond_start(far, frustum_face::side, false, hints, interval, report);
        return;
    }
    if (near > small) {
        small = near;
        in_face = frustum_face::side;
    }
    if (far < large) {
        large = far;
        out_face = frustum_face::side;
    }
    if (small > large) return;
    report_beyond_start(small, in_face, true, hints, interval, report);
    report_beyond_start(large, out_face, false, hints, interval, report);
}

template <methods::Shapes Real>
SurfacePoint<Real> surface_point(const FrustumSolid<Real>& f, const Ray<Real>& ray, Real t,
                                 std::uint32_t face) {
    if (face == frustum_face::small_cap) return textbook_point(ray, t, -f.axis);
    if (face == frustum_face::large_cap) return textbook_point(ray, t, f.axis);
    const Vec3<Real> rel = start_from(ray, f.small_end) + t * ray.dir;
    const Vec3<Real> radial = rel - dot(f.axis, rel) * f.axis;
    return textbook_point(ray, t, radial / length(radial) - f.slope * f.axis);
}

}  // namespace lancer
