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
};

/// \param scale_exponent  World::scale_exponent
template <class Real>
Lens<Real> make_lens(const Camera& camera, int width, int height, int scale_exponent) {
    using std::ldexp;
    const auto scaled = [&](const Vec3d& p) {
        const Vec3<Real> q = convert<Real>(p);
        return Vec3<Real>(ldexp(q.x, scale_exponent), ldexp(q.y, scale_exponent),
                          ldexp(q.z, scale_exponent));
    };
    Lens<Real> lens;
    lens.position = scaled(camera.position);
    const Vec3<Real> view = scaled(camera.look_at) - lens.position;
    // Divided by their largest component first, so that no length overflows or vanishes.
    lens.forward = normalize(view / max_component(absolute(view)));
    const Vec3<Real> sky = convert<Real>(camera.up / max_component(absolute(camera.up)));
    const Vec3<Real> side = cross(lens.forward, normalize(sky));
    const Vec3<Real> right = normalize(side / max_component(absolute(side)));
    const Vec3<Real> up = cross(right, lens.forward);
    const Real aspect = static_cast<Real>(width) / static_cast<Real>(height);
    Real tall = 0;
    if (const auto* perspective = std::get_if<PerspectiveProjection>(&camera.projection)) {
        lens.orthographic = false;
        tall = 2 * elementary::tan(static_cast<Real>(perspective->fov) / 2 *
                                   static_cast<Real>(std::numbers::pi_v<long double> / 180));
    } else {
        lens.orthographic = true;
        tall = ldexp(static_cast<Real>(std::get<OrthographicProjection>(camera.projection).height),
                     scale_exponent);
    }
    lens.right = right * (tall * aspect);
    lens.up = up * tall;
    return lens;
}

template <class Real>
Ray<Real> camera_ray(const Lens<Real>& lens, Real sx, Real sy) {
    const Vec3<Real> aside = sx * lens.right + sy * lens.up;
    if (lens.orthographic) {
        const VectorSum<Real> origin = two_sum(lens.position, aside);
        return make_ray(origin.hi, origin.lo, lens.forward, Real(0));
    }
    return make_ray(lens.position, Vec3<Real>(0), normalize(lens.forward + aside), Real(0));
}

}  // namespace lancer
