// All that the tracer asks of the geometry, for the one file in which a number type is
// instantiated. It is most of the tracer's code, so callers see only its declarations.
#pragma once

#include "tracer/intersect/edge_hits_build.h"
#include "tracer/intersect/local_point_build.h"
#include "tracer/intersect/nearest_contact_build.h"
#include "tracer/intersect/occlusion_build.h"
#include "tracer/intersect/starts_inside_build.h"

#define LANCER_SEARCHES(Real)                                                               \
    template Contact<Real> nearest_contact(const Geometry<Real>&, const Ray<Real>&,         \
                                           const Start<Real>&, const NoMedia&, Shadows);    \
    template Contact<Real> nearest_contact(const Geometry<Real>&, const Ray<Real>&,         \
                                           const Start<Real>&, const MediaList&, Shadows);  \
    template OnTheWay query_occlusion(const Geometry<Real>&, const Ray<Real>&, Real,        \
                                      const Start<Real>&, const NoMedia&, Passes<Real>*);   \
    template OnTheWay query_occlusion(const Geometry<Real>&, const Ray<Real>&, Real,        \
                                      const Start<Real>&, const MediaList&, Passes<Real>*); \
    template Contact<Real> adjacent_face_hit(const Geometry<Real>&, const Ray<Real>&,       \
                                             const SurfaceId&, const MediaList&, Real);     \
    template Contact<Real> lost_face_hit(const Geometry<Real>&, const Ray<Real>&,           \
                                         const SurfaceId&, const MediaList&);               \
    template bool starts_inside(const Geometry<Real>&, std::uint32_t, const Ray<Real>&);    \
    template SurfacePoint<Real> local_point(const Geometry<Real>&, const Primitive<Real>&,  \
                                            const Ray<Real>&, const Hit<Real>&)
