// Camera rays that begin near the scene instead of at a camera far from it.
//
// A point at distance L is known to u L, so from 10^12 sizes away a ray's origin alone puts its
// hits off by a pixel. The same ray begun on a plane just before the scene is as exact as one of a
// near camera: there its point is look_at - rest forward + ahead aside, three terms of the scene's
// own size (`forward` unit, `aside` the pixel's place in the picture at distance 1).
#pragma once

#include <algorithm>
#include <cmath>

#include "tracer/rays/camera.h"
#include "tracer/scene/world.h"

namespace lancer {

/// Rays of a camera nearer than this many times the scene's depth begin at the camera: little would
/// be gained.
inline constexpr int far_camera_ratio = 16;

/// Moves the rays' origins forward to a plane before all bounded objects, where the camera is far
/// from them. What is met before that, which only planes can be, then has a negative parameter.
template <class Real>
void begin_near_scene(const World<Real>& world, const Camera& camera,
                      CameraFrame<Real>& camera_frame) {
    if (world.bounded == 0) return;
    const Vec3<Real> look_at = world_place<Real>(camera.look_at, world.scale_exponent);
    const Vec3<Real> view = look_at - camera_frame.position;
    const Real largest = max_component(absolute(view));
    const Real distance = largest * length(view / largest);
    // How far the scene reaches from the look_at towards the camera.
    Real reach = 0;
    const Bounds<Real>& box = world.bvh.bounds;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3<Real> p((corner & 1) != 0 ? box.max.x : box.min.x,
                           (corner & 2) != 0 ? box.max.y : box.min.y,
                           (corner & 4) != 0 ? box.max.z : box.min.z);
        reach = std::max(reach, dot(look_at - p, camera_frame.forward));
    }
    if (!(reach > 0) || !(reach * far_camera_ratio < distance)) return;
    // A power of two, so that it does not follow the last digits of the box.
    using std::ilogb;
    using std::ldexp;
    const Real rest = ldexp(Real(1), ilogb(reach) + 2);
    camera_frame.origin = two_sum(look_at, camera_frame.forward * -rest);
    camera_frame.ahead = distance - rest;
}

}  // namespace lancer
