// Edges and corners of a mesh: a ray that one face refracts or mirrors may go straight through the
// adjacent face.
#pragma once

#include "tracer/intersect/contact.h"
#include "tracer/intersect/intersection_filter.h"

namespace lancer {

/// The adjacent face hit of a ray that a face of a mesh refracted or mirrored; empty if there is
/// none. If the distance between the ray's start and an edge is below the rounding error, the ray
/// may go straight through the face behind that edge: out of the body at a convex edge, into it at
/// a concave one. The search may miss both faces by rounding. So this function takes the side from
/// the ray's list of bodies.
///
/// \param turn    the face that the ray starts on
/// \param bodies  that contain the ray
/// \param wider   how many times the rounding error the start may be from the edge
template <class Real>
Contact<Real> adjacent_face_hit(const Geometry<Real>& geometry, const Ray<Real>& ray,
                                const SurfaceId& turn, const MediaList& bodies, Real wider = 1);

/// The same for a ray that a search lost in the body it starts on: the nearest adjacent face.
///
/// Where a ray meets a face at a small angle, the error of its start along the face is the error
/// of its distance over that angle, and adjacent_face_hit() does not know the angle. At less than
/// the square root of the roundings, rounding decides whether the ray meets the face at all.
template <class Real>
Contact<Real> lost_face_hit(const Geometry<Real>& geometry, const Ray<Real>& ray,
                            const SurfaceId& turn, const MediaList& bodies);

}  // namespace lancer
