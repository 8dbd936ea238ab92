// Prisms: a curved outline extruded along y, which rays meet without a mesh.
#pragma once

#include <limits>

#include "tracer/rays/crossing.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/traits.h"
#include "tracer/splines/extrusion.h"

namespace lancer {

/// One instance of a prism. Its faces are the segments of its outline, then bottom and top.
template <class Real>
struct PrismSolid {
    const splines::Extrusion<Real>*
        surface;   ///< its exponent scales the curve to this solid's space
    int unit = 0;  ///< this solid's space is the shape's own times 2^unit

    static constexpr SolidTraits traits{.convex = false, .face_by_face = false};
    /// The measure in its own space that must not be too small; infinite if there is none.
    Real size() const { return std::numeric_limits<Real>::infinity(); }
};

template <class Real, class Last, class Report>
void crossings(const PrismSolid<Real>& prism, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    const splines::KnownStart start{hints.start_face, hints.inside};
    const auto found = splines::crossings(*prism.surface, start_from(ray, Vec3<Real>(0)), ray.dir,
                                          ray.origin_error, start);
    for (std::size_t i = 0; i < found.size(); ++i) {
        Crossing<Real> c{found[i].t, found[i].error, found[i].segment, found[i].entering};
        if (c.entering && i + 1 < found.size()) c.chord = found[i + 1].t - c.t;
        if (interval.holds(c) && !interval.ends_before(c.t)) report(c);
    }
}

/// The point of a crossing, projected onto its face. Its parameters on sides: u goes along the
/// outline, v from bottom to top; on caps: (x, z).
template <class Real>
SurfacePoint<Real> surface_point(const PrismSolid<Real>& prism, const Ray<Real>& ray, Real t,
                                 std::uint32_t face) {
    const splines::Extrusion<Real>& surface = *prism.surface;
    const splines::Curve<Real>& curve = surface.curve;
    const Vec3<Real> start = start_from(ray, Vec3<Real>(0));
    const Vec3<Real> near = splines::scaled(start + t * ray.dir, -curve.exponent);
    SurfacePoint<Real> p;
    p.anchor = Vec3<Real>(0);
    p.error = ldexp(gamma<Real>(16), curve.exponent);
    if (face >= curve.segments()) {
        const bool top = face == surface.top_face();
        p.offset = splines::scaled(Vec3<Real>(near.x, top ? surface.top : surface.bottom, near.z),
                                   curve.exponent);
        p.normal = Vec3<Real>(0, top ? 1 : -1, 0);
        p.parameter = Vec2<Real>(ldexp(p.offset.x, -prism.unit), ldexp(p.offset.z, -prism.unit));
    } else {
        const Real s = splines::nearest(
            splines::side_crossings(surface, start, ray.dir, ray.origin_error, face), t, Real(0.5));
        const Vec2<Real> on = splines::sample(curve, face, s).point;
        const Vec2<Real> tangent = splines::direction(curve, face, s) * surface.outward;
        p.offset = splines::scaled(Vec3<Real>(on.x, near.y, on.y), curve.exponent);
        p.normal =
            tangent == Vec2<Real>(0) ? Vec3<Real>(1, 0, 0) : Vec3<Real>(tangent.y, 0, -tangent.x);
        p.parameter =
            Vec2<Real>((static_cast<Real>(face) + s) / static_cast<Real>(curve.segments()),
                       (near.y - surface.bottom) / (surface.top - surface.bottom));
    }
    p.shading = p.normal;
    return p;
}

}  // namespace lancer
