// What a ray may meet, and its crossings with one primitive.
#pragma once

#include "tracer/bvh/traverse.h"
#include "tracer/intersect/composite_crossings.h"
#include "tracer/intersect/intersection_filter.h"
#include "tracer/intersect/shape_crossings.h"
#include "tracer/rays/crossing.h"

namespace lancer {

/// Reports the crossings of the ray with a solid in the solid's own space.
template <class Real, class Last, class Report>
void solid_crossings(const Solid<Real>& solid, const Ray<Real>& ray, IntersectionHints hints,
                     const RayInterval<Real, Last>& interval, Report& report) {
    std::visit(
        [&](const auto& shape) {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, CompositeSolid<Real>>)
                CompositeWalk<Real>(*shape.tree, ray, {}).tell(interval, report);
            else
                shape_crossings(shape, ray, hints, interval, report);
        },
        solid);
}

/// Reports the crossings of the world ray with one primitive: report(Crossing, u, v), which returns
/// true to stop.
template <class Real, class Last, class Report>
void primitive_crossings(const Geometry<Real>& geometry, const Primitive<Real>& primitive,
                         const Ray<Real>& world_ray, IntersectionHints hints,
                         const RayInterval<Real, Last>& interval, Report&& report) {
    if (primitive.frame == none)
        solid_crossings(primitive.solid, world_ray, hints, interval, report);
    else
        solid_crossings(primitive.solid, to_local(world_ray, geometry.frames[primitive.frame]),
                        hints, interval, report);
}

/// The same for a ray with a start, which a composite needs.
///
/// \param hints  those of `accept`, or modified ones
template <class Real, class Bodies, class Last, class Report>
void crossings_from(const Geometry<Real>& geometry, std::uint32_t index, const Ray<Real>& ray,
                    const IntersectionFilter<Real, Bodies>& accept, IntersectionHints hints,
                    const RayInterval<Real, Last>& interval, Report&& report) {
    const Primitive<Real>& primitive = geometry.primitives[index];
    if (const CompositeTree<Real>* tree = primitive.composite()) {
        const CompositeStart<Real> known{&accept.start(), index, accept.state_of(index)};
        CompositeWalk<Real>(*tree, ray, known).tell(interval, report);
    } else {
        primitive_crossings(geometry, primitive, ray, hints, interval, report);
    }
}

/// The plane of a primitive in primitives[planes..].
template <class Real>
const HalfSpace<Real>& plane_of(const Geometry<Real>& geometry, std::uint32_t primitive) {
    return *std::get_if<HalfSpace<Real>>(&geometry.primitives[primitive].solid);
}

/// Visits every primitive, except for planes, that the ray may meet on the interval: visit(index)
/// returns true to stop.
template <class Real, class Last, class Visit>
void candidates(const Geometry<Real>& geometry, const Ray<Real>& ray,
                const RayInterval<Real, Last>& interval, Visit&& visit) {
    for (std::uint32_t i = geometry.bounded; i < geometry.planes; ++i) {
        if (visit(i)) return;
    }
    traverse(geometry.bvh, ray, interval.first, interval.last,
             [&](std::uint32_t first, std::uint32_t count) {
                 for (std::uint32_t i = first; i < first + count; ++i) {
                     if (visit(i)) return true;
                 }
                 return false;
             });
}

/// The same for a ray with a start: bodies whose boxes might hide them are visited first. The
/// search would come to nearly all of them, for a ray in a body is in its box.
template <class Real, class Bodies, class Last, class Visit>
void candidates_from(const Geometry<Real>& geometry, const Ray<Real>& ray,
                     const IntersectionFilter<Real, Bodies>& accept,
                     const RayInterval<Real, Last>& interval, Visit&& visit) {
    if constexpr (std::is_same_v<Bodies, NoMedia>) {
        candidates(geometry, ray, interval, visit);
    } else {
        const MediaList first = accept.in_beyond_boxes();
        for (const std::uint32_t index : first) {
            if (visit(index)) return;
        }
        candidates(geometry, ray, interval,
                   [&](std::uint32_t index) { return !contains(first, index) && visit(index); });
    }
}

}  // namespace lancer
