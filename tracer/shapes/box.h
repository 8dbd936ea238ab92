// The box along the axes of its space.
#pragma once

#include "tracer/ray.h"

namespace lancer {

template <class Real>
struct BoxSolid {
    Vec3<Real> min;
    Vec3<Real> max;
    Real placed = 0;  ///< bound on how far rounding moved it when a transform put it into the world
};

/// Faces are numbered 2 axis + (0 at min, 1 at max).
inline constexpr std::uint32_t box_face(int axis, bool at_max) {
    return static_cast<std::uint32_t>(2 * axis + (at_max ? 1 : 0));
}

/// The line inside the box is the intersection of three intervals, one between each pair of faces
/// (Kay, Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986). Which face is near is told by the
/// sign of the direction, never by comparing numbers that may be equal: so a box of no thickness
/// has two faces with the right normals.
template <class Real, class Report>
void crossings(const BoxSolid<Real>& box, const Ray<Real>& ray, const Known& known,
               Report&& report) {
    using std::abs;
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    Crossing<Real> in{-infinity, 0, 0, true};
    Crossing<Real> out{infinity, 0, 0, false};
    bool started_in = false;
    const Vec3<Real> from_min = start_from(ray, box.min);
    const Vec3<Real> from_max = start_from(ray, box.max);
    for (int axis = 0; axis < 3; ++axis) {
        const Real d = ray.dir[axis];
        const Real to_min = -from_min[axis];
        const Real to_max = -from_max[axis];
        if (d == 0) {
            if ((to_min > 0 || to_max < 0) && !known.inside) return;
            continue;
        }
        const bool forward = d > 0;
        const std::uint32_t near_face = box_face(axis, !forward);
        const std::uint32_t far_face = box_face(axis, forward);
        const Real inv = ray.inv_dir[axis];
        Real near = (forward ? to_min : to_max) * inv;
        Real far = (forward ? to_max : to_min) * inv;
        const Real place = (ray.origin_error + box.placed) * abs(inv);
        if (known.start_face == near_face) {
            near = 0;
            started_in = true;
        }
        if (known.start_face == far_face) far = 0;
        // A difference, its small part, a reciprocal and a product.
        if (near > in.t) in = {near, gamma<Real>(4) * abs(near) + place, near_face, true};
        if (far < out.t) out = {far, gamma<Real>(4) * abs(far) + place, far_face, false};
    }
    const bool certainly_inside = known.inside || started_in;
    if (in.t > out.t && !certainly_inside) return;
    in.chord = out.t - in.t;
    if (in.face != known.start_face && in.t > -infinity) report(in);
    if (out.face != known.start_face && out.t < infinity) report(out);
}

/// The crossing's point, with the face's own coordinate exact.
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
