// If the camera is far from the scene, its rays begin near the scene.
//
// A point at distance L is known only up to u L. So at a distance of 10^12 scene sizes, the
// rounding of the ray's origin alone moves hits by a pixel. A ray that begins on a plane just
// before the scene is as exact as that of a near camera. Its origin there is look_at - rest forward
// + ahead aside, three terms of the scene's own size (`forward` is a unit vector, `aside` the
// pixel's place in the picture at distance 1).
#pragma once

#include <algorithm>
#include <cmath>

#include "tracer/rays/camera.h"
#include "tracer/scene/world.h"

namespace lancer {

/// A camera that is nearer than this multiple of the scene's depth is not far: its rays begin at
/// the camera, because little would be gained.
inline constexpr int far_camera_ratio = 16;

/// If the camera is far, moves the rays' origins forward to a plane before all bounded objects.
/// Crossings before that plane, which only unbounded objects can have, get negative parameters.
template <class Real>
void begin_near_scene(const World<Real>& world, const Camera& camera,
                      CameraFrame<Real>& camera_frame) {
    if (world.bounded == 0) return;
    const Vec3<Real> look_at = world_place<Real>(camera.look_at, world.scale_exponent);
    const Vec3<Real> view = look_at - camera_frame.position;
    const Real largest = max_component(absolute(view));
    const Real distance = largest * length(view / largest);
    // How far the scene extends from the look_at point towards the camera.
    Real reach = 0;
    const Bounds<Real>& box = world.bvh.bounds;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3<Real> p((corner & 1) != 0 ? box.max.x : box.min.x,
                           (corner & 2) != 0 ? box.max.y : box.min.y,
                           (corner & 4) != 0 ? box.max.z : box.min.z);
        reach = std::max(reach, dot(look_at - p, camera_frame.forward));
    }
    if (!(reach > 0) || !(reach * far_camera_ratio < distance)) return;
    // A power of two, so that it does not depend on the last digits of the box.
    using std::ilogb;
    using std::ldexp;
    const Real rest = ldexp(Real(1), ilogb(reach) + 2);
    camera_frame.origin = two_sum(look_at, camera_frame.forward * -rest);
    camera_frame.ahead = distance - rest;
}

}  // namespace lancer
