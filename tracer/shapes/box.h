// Boxes along the axes of their space.
#pragma once

#include "tracer/numerics/lanes.h"
#include "tracer/rays/crossing.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/traits.h"

namespace lancer {

template <class Real>
struct BoxSolid {
    Vec3<Real> min;
    Vec3<Real> max;
    Real transform_error =
        0;  ///< bound on how far rounding moved it when a transform put it into the world

    static constexpr SolidTraits traits{.convex = true, .face_by_face = false};
    /// The measure in its own space that must not be too small; infinite if there is none.
    Real size() const { return max_component(Vec3<Real>(max - min)); }
};

/// Faces are numbered 2 axis + (0 at min, 1 at max).
inline constexpr std::uint32_t box_face(int axis, bool at_max) {
    return static_cast<std::uint32_t>(2 * axis + (at_max ? 1 : 0));
}

/// The part of a line inside a box: its ends, and their faces.
template <class Real>
struct BoxSpan {
    static constexpr Real infinity = std::numeric_limits<Real>::infinity();
    Real in = -infinity;
    Real out = infinity;
    std::uint32_t in_face = 0;
    std::uint32_t out_face = 0;
    bool started_in = false;  ///< the line starts on the face by which it enters
};

/// The differences from the start to the box's two planes perpendicular to an axis; exact, then
/// rounded once.
template <class Real>
Two<Real> to_planes(const BoxSolid<Real>& box, const Ray<Real>& ray, int axis) {
    const Two<Real> planes(std::array<Real, 2>{box.min[axis], box.max[axis]});
    const Two<Real> origin(ray.origin[axis]);
    if (ray.whole) return planes - origin;
    const DoubleWord<Two<Real>> d = two_sum(planes, Two<Real>(Real(0)) - origin);
    return d.hi + (d.lo - Two<Real>(ray.origin_lo[axis]));
}

/// Clips the span to the slab between the two faces perpendicular to an axis. Returns false if the
/// line runs parallel to them, outside of the slab, and is not known to be inside.
template <class Real>
[[gnu::always_inline]] inline bool cut(BoxSpan<Real>& span, const BoxSolid<Real>& box,
                                       const Ray<Real>& ray, int axis,
                                       const IntersectionHints& hints) {
    const Two<Real> way = to_planes(box, ray, axis);
    const Real dir = ray.dir[axis];
    if (dir == 0) {
        const auto [to_min, to_max] = way.numbers();
        return hints.inside || !(to_min > 0 || to_max < 0);
    }
    const bool forward = dir > 0;
    const std::uint32_t near_face = box_face(axis, !forward);
    const std::uint32_t far_face = box_face(axis, forward);
    const auto [at_min, at_max] = (way * Two<Real>(ray.inv_dir[axis])).numbers();
    Real near = forward ? at_min : at_max;
    Real far = forward ? at_max : at_min;
    if (hints.start_face == near_face) {
        near = 0;
        span.started_in = true;
    }
    if (hints.start_face == far_face) far = 0;
    if (near > span.in) {
        span.in = near;
        span.in_face = near_face;
    }
    if (far < span.out) {
        span.out = far;
        span.out_face = far_face;
    }
    return true;
}

/// The part of the line inside the box is the intersection of three intervals, one between each
/// pair of faces (Kay, Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986). The sign of the
/// direction decides which face is near, never a comparison of numbers that may be equal. So a box
/// of zero thickness has two faces with the right normals.
template <class Real, class Last, class Report>
void crossings(const BoxSolid<Real>& box, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    using std::abs;
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    BoxSpan<Real> span;
    if (!cut(span, box, ray, 0, hints) || !cut(span, box, ray, 1, hints) ||
        !cut(span, box, ray, 2, hints))
        return;
    if (span.in > span.out && !hints.inside && !span.started_in) return;
    // The 4 roundings of t: a difference, its low part, a reciprocal and a product.
    const auto offer = [&](Real t, std::uint32_t face, bool entering, Real chord) {
        if (face == hints.start_face || !(abs(t) < infinity) || interval.ends_before(t) ||
            !hints.asks_about(entering))
            return;
        const Real steep = abs(ray.inv_dir[static_cast<int>(face / 2)]);
        const Real error =
            gamma<Real>(4) * abs(t) + (ray.origin_error + box.transform_error) * steep;
        const Crossing<Real> c{t, error, face, entering, chord};
        if (interval.holds(c)) report(c);
    };
    offer(span.in, span.in_face, true, span.out - span.in);
    offer(span.out, span.out_face, false, infinity);
}

/// The point of a crossing. The coordinate across the face is exact.
template <class Real>
SurfacePoint<Real> surface_point(const BoxSolid<Real>& box, const Ray<Real>& ray, Real t,
                                 std::uint32_t face) {
    const int axis = static_cast<int>(face / 2);
    const bool at_max = face % 2 == 1;
    Vec3<Real> anchor = box.min;
    anchor[axis] = at_max ? box.max[axis] : box.min[axis];
    Vec3<Real> offset = start_from(ray, anchor) + t * ray.dir;
    offset[axis] = 0;
    for (int other = 0; other < 3; ++other) {
        if (other == axis) continue;
        // Rounding may have carried the point past an edge.
        if (offset[other] < 0) offset[other] = 0;
        const Real width = box.max[other] - box.min[other];
        if (offset[other] > width) offset[other] = width;
    }
    Vec3<Real> normal(0);
    normal[axis] = at_max ? Real(1) : Real(-1);
    return {anchor, offset, 0, normal, normal, Vec2<Real>(0)};
}

}  // namespace lancer
