// Rays, and what a ray knows about where it starts.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "model/affine.h"
#include "model/shapes.h"
#include "tracer/rounding.h"

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
    /// Bound on what plain differences take from an edge function of a triangle: edge_noise().
    Real noise = std::numeric_limits<Real>::infinity();
};

/// A half line. World rays have unit directions; rays in an object's space keep the parameter t of
/// the world ray, so their directions have any length.
template <class Real>
struct Ray {
    Vec3<Real> origin;     ///< the start is origin + origin_lo, unevaluated
    Vec3<Real> origin_lo;  ///< what `origin` is too coarse for: at most u |origin| in a component
    Vec3<Real> dir;
    Real dir_squared;  ///< dot(dir, dir)
    Real inv_squared;  ///< 1 / dir_squared
    Real
        origin_error;  ///< bound on the start's distance from the surface it was computed to lie on
    Real plain_error;  ///< what the start adds to the error of a plain difference of places,
                       ///< origin - point, summed over the components: see plain_error_of()
    Vec3<Real> inv_dir;  ///< 1 / dir, component by component
    bool whole = false;  ///< `origin_lo` is 0
};

/// What a place adds to the error of a plain difference of places: such a difference errs by u of
/// both, and a start's by the low part that it leaves out. 16 u instead, so that it stands for the
/// place's size, too, in what is then computed from the difference. Filters use it: they decide
/// what is clear from a distance, before exact differences are formed.
template <class Real>
Real plain_error_of(const Vec3<Real>& place) {
    const Vec3<Real> size = absolute(place);
    return gamma<Real>(16) * (size.x + size.y + size.z);
}

/// A bound on the size of a place, or of several together, from their plain errors.
template <class Real>
Real size_of_place(Real plain_errors) {
    return plain_errors * (1 / gamma<Real>(16));
}

/// 1 / square. Directions of world rays are unit but for rounding, and 1 / (1 + e) is 1 - e within
/// e^2, which for an e of some roundings is less than one.
template <class Real>
Real inverse_square(Real square) {
    using std::abs;
    const Real excess = square - 1;
    return abs(excess) < gamma<Real>(16) ? 1 - excess : 1 / square;
}

/// \param origin_lo  at most u |origin| in a component: see normalized()
template <class Real>
Ray<Real> make_ray(const Vec3<Real>& origin, const Vec3<Real>& origin_lo, const Vec3<Real>& dir,
                   Real origin_error) {
    const Real square = dot(dir, dir);
    return {origin,
            origin_lo,
            dir,
            square,
            inverse_square(square),
            origin_error,
            plain_error_of(origin) + origin_error,
            Vec3<Real>(1 / dir.x, 1 / dir.y, 1 / dir.z),
            origin_lo == Vec3<Real>(0)};
}

/// The same for all triangles that the ray meets, so that neighbours agree.
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

/// How far a triangle's edge function by plain differences and that by exact ones may lie apart.
/// With S the size of start and corners from their plain errors, plain differences are off by 18 u
/// S, sheared coordinates (up to 2 S) by 43 u S, the difference of two of their products by 360 u
/// S^2; from exact differences by 72 u S^2. Where the start is one number both are the same, and
/// where exact ones cost as little about_from_start() takes them anyway.
///
/// \param reach  bound on the corners' coordinates
template <class Real>
Real edge_noise(const Ray<Real>& ray, Real reach) {
    if (ray.whole || has_fast_wider<Real>) return 0;
    const Real size = reach + size_of_place(ray.plain_error);
    return gamma<Real>(512) * size * size;
}

/// The ray's start relative to `point`.
template <class Real>
[[gnu::always_inline]] inline Vec3<Real> start_from(const Ray<Real>& ray, const Vec3<Real>& point) {
    if (ray.whole) return ray.origin - point;  // what the difference then comes to
    return difference(ray.origin, ray.origin_lo, point);
}

/// What the rounding of start_from() took from its component `axis`.
template <class Real>
Real lost_from_start(const Ray<Real>& ray, const Vec3<Real>& point, int axis) {
    const Sum<Real> d = two_sum(ray.origin[axis], -point[axis]);
    const Real rest = d.lo + ray.origin_lo[axis];
    return rest - ((d.hi + rest) - d.hi);
}

/// One of the surfaces of a contact: which face of which primitive, crossed in which sense.
struct SurfaceId {
    std::uint32_t primitive = none;
    std::uint32_t face = 0;
    bool entering = false;  ///< against the outward normal

    bool operator==(const SurfaceId&) const = default;
};

/// What is known about a ray and a solid before their crossings are computed.
struct Known {
    /// The ray starts on this face: its crossing there, at t = 0, is divided out, not computed.
    std::uint32_t start_face = none;
    /// The ray is inside the solid: it has a way out, even where rounding denies it.
    bool inside = false;
    /// The solid is one that can only be left from inside and only be entered from outside, so that
    /// other crossings need not be reported.
    bool one_way = false;

    bool asks_about(bool entering) const { return !one_way || entering != inside; }
};

/// A crossing of a ray with a surface, on the whole line: t may be negative.
template <class Real>
struct Crossing {
    Real t;
    Real error;  ///< bound on the rounding error of t
    std::uint32_t face;
    bool entering;  ///< against the outward normal; for sheets: against the front
    /// How far the ray then stays inside, where the solid is convex and its way out is known.
    Real chord = std::numeric_limits<Real>::infinity();
};

/// The stretch of a line that a query asks about. What lies outside of it, before it by more than
/// its error, need not be reported, and needs no bound either: bounds cost as much as crossings.
///
/// \tparam Last  called without arguments: the parameter beyond which nothing matters. It may
///               shrink as crossings are reported. It may have a function settles(): see there
template <class Real, class Last>
struct Stretch {
    Real first;
    const Last& last;

    /// Whether the query may do without the exact form of a crossing.
    static constexpr bool may_settle = requires(const Last& query, Real t) { query.settles(t, t); };

    /// For shapes that know, from a filter, that a crossing which they would report lies between
    /// these parameters, with eight times its error bound on either side of it. True: the query
    /// wants to hear no more of the shape.
    bool settles(Real low, Real high) const {
        if constexpr (may_settle) return last.settles(low, high);
        return false;
    }

    bool ends_before(Real t) const { return t > last(); }
    bool holds(const Crossing<Real>& c) const { return c.t + c.error >= first; }
};

/// The whole line.
template <class Real>
inline constexpr auto endless = [] { return std::numeric_limits<Real>::infinity(); };
template <class Real>
Stretch<Real, decltype(endless<Real>)> whole_line() {
    return {-std::numeric_limits<Real>::infinity(), endless<Real>};
}

/// Where a surface was hit, in the space of the ray that was given to the shape.
template <class Real>
struct SurfacePoint {
    Vec3<Real> anchor;  ///< the point is anchor + offset, unevaluated
    Vec3<Real> offset;
    Real error;            ///< bound on the point's distance from the surface
    Vec3<Real> normal;     ///< geometric, outward; any length but 0
    Vec3<Real> shading;    ///< interpolated where the shape does so, else = normal
    Vec2<Real> parameter;  ///< face-dependent: barycentrics of a triangle, parameters of a spline
    Vec3<Real> rest{0};    ///< a small third part of the point, where two do not hold it
};

/// An object's own space, for shapes that a world-space primitive cannot express.
template <class Real>
struct Frame {
    Affine<Real> to_world;
    Affine<Real> linear_inverse;  ///< the linear part's inverse; `shift` is 0
    Real norm;                    ///< largest absolute row sum of the linear part
    Real inverse_norm;            ///< the same of the inverse
    Real placed = 0;  ///< bound on how far rounding moved what stands in this space, in the world
};

/// The ray in the frame's space, with the same parameter t.
template <class Real>
Ray<Real> to_local(const Ray<Real>& ray, const Frame<Real>& frame) {
    // Both parts of the start are kept: a power of two for a map, or none, then loses nothing.
    const VectorSum<Real> start = two_sum(ray.origin, -frame.to_world.shift);
    const Vec3<Real> low = start.lo + ray.origin_lo;
    // Three products and two sums a component, on rounded entries.
    const Vec3<Real> size = absolute(start.hi);
    const Real error = frame.inverse_norm *
                       (ray.origin_error + frame.placed + gamma<Real>(6) * max_component(size));
    const VectorSum<Real> local = normalized(map_vector(frame.linear_inverse, start.hi),
                                             map_vector(frame.linear_inverse, low));
    return make_ray(local.hi, local.lo, map_vector(frame.linear_inverse, ray.dir), error);
}

}  // namespace lancer
