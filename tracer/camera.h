// Pixels to rays.
#pragma once

#include <numbers>

#include "model/scene.h"
#include "tracer/ray.h"

namespace lancer {

/// A camera in the compiled world. A pixel's place is given as shares (sx, sy) of the picture's
/// width and height from its centre, sx to the right, sy up.
template <class Real>
struct Lens {
    Vec3<Real> position;
    Vec3<Real> forward;  ///< unit
    Vec3<Real>
        right;      ///< of the picture's whole width, at distance 1 (perspective) or in world units
    Vec3<Real> up;  ///< of its whole height
    bool orthographic;
    /// How far before the camera, along `forward`, rays have their origin: see far_camera.h.
    Real ahead = 0;
    VectorSum<Real> origin{};  ///< that of the middle ray, where `ahead` is not 0
};

/// A place of the scene in world coordinates.
template <class Real>
Vec3<Real> world_place(const Vec3d& p, int scale_exponent) {
    using std::ldexp;
    // Widened first: neither a float's range nor a double's may be left on the way.
    const Vec3<long double> q = convert<long double>(p);
    return {static_cast<Real>(ldexp(q.x, scale_exponent)),
            static_cast<Real>(ldexp(q.y, scale_exponent)),
            static_cast<Real>(ldexp(q.z, scale_exponent))};
}

/// \param scale_exponent  World::scale_exponent
template <class Real>
Lens<Real> make_lens(const Camera& camera, int width, int height, int scale_exponent) {
    Lens<Real> lens;
    lens.position = world_place<Real>(camera.position, scale_exponent);
    const Vec3<Real> view = world_place<Real>(camera.look_at, scale_exponent) - lens.position;
    // Divided by their largest component first, so that no length overflows or vanishes.
    lens.forward = normalize(view / max_component(absolute(view)));
    const Vec3<Real> sky = convert<Real>(camera.up / max_component(absolute(camera.up)));
    const Vec3<Real> side = cross(lens.forward, normalize(sky));
    const Vec3<Real> right = normalize(side / max_component(absolute(side)));
    const Vec3<Real> up = cross(right, lens.forward);
    const Real aspect = static_cast<Real>(width) / static_cast<Real>(height);
    const auto* perspective = std::get_if<PerspectiveProjection>(&camera.projection);
    lens.orthographic = perspective == nullptr;
    const Real tall =
        lens.orthographic
            ? ldexp(static_cast<Real>(std::get<OrthographicProjection>(camera.projection).height),
                    scale_exponent)
            : 2 * elementary::tan(static_cast<Real>(perspective->fov) / 2 *
                                  static_cast<Real>(std::numbers::pi_v<Wide<Real>> / 180));
    lens.right = right * (tall * aspect);
    lens.up = up * tall;
    return lens;
}

/// The ray through a place of the picture, with its origin at the camera.
template <class Real>
Ray<Real> ray_from_camera(const Lens<Real>& lens, Real sx, Real sy) {
    const Vec3<Real> aside = sx * lens.right + sy * lens.up;
    if (lens.orthographic) {
        const VectorSum<Real> origin = two_sum(lens.position, aside);
        return make_ray(origin.hi, origin.lo, lens.forward, Real(0));
    }
    return make_ray(lens.position, Vec3<Real>(0), normalize(lens.forward + aside), Real(0));
}

/// The same line, with its origin where the lens has it.
template <class Real>
Ray<Real> camera_ray(const Lens<Real>& lens, Real sx, Real sy) {
    if (lens.ahead == 0) return ray_from_camera(lens, sx, sy);
    const Vec3<Real> aside = sx * lens.right + sy * lens.up;
    const Vec3<Real> dir = lens.orthographic ? lens.forward : normalize(lens.forward + aside);
    VectorSum<Real> origin =
        two_sum(lens.origin.hi, lens.orthographic ? aside : aside * lens.ahead);
    origin = normalized(origin.hi, origin.lo + lens.origin.lo);
    return make_ray(origin.hi, origin.lo, dir, Real(0));
}

/// The camera's parameter on a ray that has its origin ahead of it: negative.
template <class Real>
Real camera_parameter(const Lens<Real>& lens, Real sx, Real sy) {
    if (lens.orthographic) return -lens.ahead;
    return -lens.ahead * length(lens.forward + sx * lens.right + sy * lens.up);
}

}  // namespace lancer
