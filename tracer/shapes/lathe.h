// Lathes: true surfaces of revolution, which rays meet without a mesh.
#pragma once

#include <limits>

#include "tracer/rays/crossing.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/traits.h"
#include "tracer/splines/revolution.h"
#include "tracer/textures/mapping.h"

namespace lancer {

/// One instance of a lathe. Its faces are the segments of its profile.
template <class Real>
struct LatheSolid {
    const splines::Revolution<Real>*
        surface;  ///< its exponent scales the curve to this solid's space

    static constexpr SolidTraits traits{.convex = false, .face_by_face = false};
    /// The measure in its own space that must not be too small; infinite if there is none.
    Real size() const { return std::numeric_limits<Real>::infinity(); }
};

template <class Real, class Last, class Report>
void crossings(const LatheSolid<Real>& lathe, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    const splines::Revolution<Real>& surface = *lathe.surface;
    const auto found =
        splines::crossings(surface, start_from(ray, Vec3<Real>(0)), ray.dir, ray.origin_error);
    std::size_t start = found.size();
    if (hints.start_face != none)
        start = splines::start_crossing(found, surface.encloses, hints.inside);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i == start) continue;
        Crossing<Real> c{found[i].t, found[i].error, found[i].segment, found[i].entering};
        if (c.entering && i + 1 < found.size()) c.chord = found[i + 1].t - c.t;
        if (interval.holds(c) && !interval.ends_before(c.t)) report(c);
    }
}

/// The point of a crossing, projected onto the surface. Its parameters: u is the angle, v goes
/// along the profile.
template <class Real>
SurfacePoint<Real> surface_point(const LatheSolid<Real>& lathe, const Ray<Real>& ray, Real t,
                                 std::uint32_t face) {
    using std::sqrt;
    const splines::Revolution<Real>& surface = *lathe.surface;
    const splines::Curve<Real>& curve = surface.curve;
    const Vec3<Real> start = start_from(ray, Vec3<Real>(0));
    const Vec3<Real> near = splines::scaled(start + t * ray.dir, -curve.exponent);
    const Real s = splines::nearest(
        splines::crossings(surface, start, ray.dir, ray.origin_error, face), t, Real(0.5));
    const Vec2<Real> on = splines::sample(curve, face, s).point;
    const Vec2<Real> tangent = splines::direction(curve, face, s) * surface.outward;

    const Real away = sqrt(near.x * near.x + near.z * near.z);
    const Real cosine = away > 0 ? near.x / away : Real(1);
    const Real sine = away > 0 ? near.z / away : Real(0);
    SurfacePoint<Real> p;
    p.anchor = Vec3<Real>(0);
    p.offset = splines::scaled(Vec3<Real>(on.x * cosine, on.y, on.x * sine), curve.exponent);
    p.error = ldexp(gamma<Real>(16), curve.exponent);
    p.normal = Vec3<Real>(tangent.y * cosine, -tangent.x, tangent.y * sine);
    // Special normals: on the axis, where all angles meet, and on a segment that is a point.
    if (!(away > 0) && tangent.x != 0) p.normal = Vec3<Real>(0, -tangent.x, 0);
    if (p.normal == Vec3<Real>(0)) p.normal = Vec3<Real>(0, 1, 0);
    p.shading = p.normal;
    p.parameter = Vec2<Real>(turn(near.z, near.x),
                             (static_cast<Real>(face) + s) / static_cast<Real>(curve.segments()));
    return p;
}

}  // namespace lancer
