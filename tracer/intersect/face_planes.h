// The planes of flat faces across a coordinate axis: they are in order where no distance along a
// ray shows it.
#pragma once

#include <optional>

#include "tracer/scene/geometry.h"

namespace lancer {

/// A plane perpendicular to a coordinate axis.
template <class Real>
struct FacePlane {
    int axis;
    Real at;  ///< the solid's own number: no distance along a ray is in it
};

template <class Real>
std::optional<FacePlane<Real>> plane_of_face(const BoxSolid<Real>& box, std::uint32_t face) {
    if (box.transform_error != 0) return std::nullopt;
    const int axis = static_cast<int>(face / 2);
    return FacePlane<Real>{axis, face == box_face(axis, true) ? box.max[axis] : box.min[axis]};
}

template <class Real>
std::optional<FacePlane<Real>> plane_of_face(const FrustumSolid<Real>& f, std::uint32_t face) {
    if (f.tilted || f.transform_error != 0 || face == frustum_face::side) return std::nullopt;
    const Vec3<Real>& end = face == frustum_face::small_cap ? f.small_end : f.large_end;
    for (int axis = 0; axis < 3; ++axis) {
        if (f.axis[axis] != 0) return FacePlane<Real>{axis, end[axis]};
    }
    return std::nullopt;
}

template <class Real>
std::optional<FacePlane<Real>> plane_of_face(const HalfSpace<Real>& half, std::uint32_t /*face*/) {
    if (half.transform_error != 0) return std::nullopt;
    for (int axis = 0; axis < 3; ++axis) {
        using std::abs;
        if (abs(half.normal[axis]) == 1) return FacePlane<Real>{axis, half.point[axis]};
    }
    return std::nullopt;
}

/// The face's plane in world space, if it is flat, across an axis, and not moved by rounding. Only
/// of these three shapes; faces of others, and of what stands in a frame, are not ordered.
template <class Real>
std::optional<FacePlane<Real>> plane_of_face(const Primitive<Real>& leaf, std::uint32_t face) {
    if (leaf.frame != none) return std::nullopt;
    if (const auto* box = std::get_if<BoxSolid<Real>>(&leaf.solid))
        return plane_of_face(*box, face);
    if (const auto* f = std::get_if<FrustumSolid<Real>>(&leaf.solid))
        return plane_of_face(*f, face);
    if (const auto* half = std::get_if<HalfSpace<Real>>(&leaf.solid))
        return plane_of_face(*half, face);
    return std::nullopt;
}

}  // namespace lancer
