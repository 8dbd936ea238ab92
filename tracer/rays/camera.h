// From pixels to rays.
#pragma once

#include <numbers>

#include "model/scene.h"
#include "tracer/rays/ray.h"

namespace lancer {

/// A camera in the compiled world. A point of the picture is given by (sx, sy), its distance from
/// the centre as shares of the picture's width and height, sx to the right and sy up.
template <class Real>
struct CameraFrame {
    Vec3<Real> position;
    Vec3<Real> forward;  ///< unit
    Vec3<Real> right;  ///< the picture's whole width, at distance 1 (perspective) or in world units
    Vec3<Real> up;     ///< the picture's whole height
    bool orthographic;
    /// Distance of the rays' origins from the camera, along `forward`: see far_camera.h.
    Real ahead = 0;
    DoubleWordVector<Real> origin{};  ///< the origin of the central ray, if `ahead` is not 0
};

/// A point of the scene in world coordinates.
template <class Real>
Vec3<Real> world_place(const Vec3d& p, int scale_exponent) {
    using std::ldexp;
    // In long double, so that intermediate results stay in range.
    const Vec3<long double> q = convert<long double>(p);
    return {static_cast<Real>(ldexp(q.x, scale_exponent)),
            static_cast<Real>(ldexp(q.y, scale_exponent)),
            static_cast<Real>(ldexp(q.z, scale_exponent))};
}

/// \param scale_exponent  World::scale_exponent
template <class Real>
CameraFrame<Real> make_camera_frame(const Camera& camera, int width, int height,
                                    int scale_exponent) {
    CameraFrame<Real> camera_frame;
    camera_frame.position = world_place<Real>(camera.position, scale_exponent);
    const Vec3<Real> view =
        world_place<Real>(camera.look_at, scale_exponent) - camera_frame.position;
    // Divided by their largest component first, so that no length overflows or underflows.
    camera_frame.forward = normalize(view / max_component(absolute(view)));
    const Vec3<Real> sky = convert<Real>(camera.up / max_component(absolute(camera.up)));
    const Vec3<Real> side = cross(camera_frame.forward, normalize(sky));
    const Vec3<Real> right = normalize(side / max_component(absolute(side)));
    const Vec3<Real> up = cross(right, camera_frame.forward);
    const Real aspect = static_cast<Real>(width) / static_cast<Real>(height);
    const auto* perspective = std::get_if<PerspectiveProjection>(&camera.projection);
    camera_frame.orthographic = perspective == nullptr;
    const Real tall =
        camera_frame.orthographic
            ? ldexp(static_cast<Real>(std::get<OrthographicProjection>(camera.projection).height),
                    scale_exponent)
            : 2 * elementary::tan(static_cast<Real>(perspective->fov) / 2 *
                                  static_cast<Real>(std::numbers::pi_v<Wide<Real>> / 180));
    camera_frame.right = right * (tall * aspect);
    camera_frame.up = up * tall;
    return camera_frame;
}

/// The ray through a point of the picture, with its origin at the camera.
template <class Real>
Ray<Real> ray_from_camera(const CameraFrame<Real>& camera_frame, Real sx, Real sy) {
    const Vec3<Real> aside = sx * camera_frame.right + sy * camera_frame.up;
    if (camera_frame.orthographic) {
        const DoubleWordVector<Real> origin = two_sum(camera_frame.position, aside);
        return make_ray(origin.hi, origin.lo, camera_frame.forward, Real(0));
    }
    return make_ray(camera_frame.position, Vec3<Real>(0), normalize(camera_frame.forward + aside),
                    Real(0));
}

/// The ray on the same line, with its origin `ahead` of the camera.
template <class Real>
Ray<Real> camera_ray(const CameraFrame<Real>& camera_frame, Real sx, Real sy) {
    if (camera_frame.ahead == 0) return ray_from_camera(camera_frame, sx, sy);
    const Vec3<Real> aside = sx * camera_frame.right + sy * camera_frame.up;
    const Vec3<Real> dir =
        camera_frame.orthographic ? camera_frame.forward : normalize(camera_frame.forward + aside);
    DoubleWordVector<Real> origin = two_sum(
        camera_frame.origin.hi, camera_frame.orthographic ? aside : aside * camera_frame.ahead);
    origin = normalized(origin.hi, origin.lo + camera_frame.origin.lo);
    return make_ray(origin.hi, origin.lo, dir, Real(0));
}

/// The parameter of the camera on the ray of camera_ray(): negative, or 0.
template <class Real>
Real camera_parameter(const CameraFrame<Real>& camera_frame, Real sx, Real sy) {
    if (camera_frame.orthographic) return -camera_frame.ahead;
    return -camera_frame.ahead *
           length(camera_frame.forward + sx * camera_frame.right + sy * camera_frame.up);
}

}  // namespace lancer
