// The recursion in worlds where all surfaces are opaque: local light and mirrors. It is whitted.h
// without transmission and media.
#pragma once

#include "tracer/rays/trace_limits.h"
#include "tracer/shading/lighting.h"

namespace lancer {

/// Whether a ray is within the limits. Beyond them its colour is black.
///
/// \param weight  product along the way of the largest channel of each factor
/// \param depth   reflections and bends so far
template <class Real>
bool is_followed(const TraceLimits& limits, Real weight, int depth) {
    return depth < limits.max_depth && weight >= static_cast<Real>(limits.min_contribution);
}

/// Fresnel reflectance of an opaque surface. Its body is in no list of media, so the indices are
/// its own and `outside`, that of the medium around the ray.
template <class Real>
Real opaque_reflectance(const Surface<Real>& s, const Vec3<Real>& ray_dir, Real outside) {
    const Real index = s.finish->ior / outside;
    const bool out_of_body = s.primitive->body && !s.id.entering;
    return fresnel_reflectance(-dot(s.normal, ray_dir), out_of_body ? 1 / index : index);
}

/// Whether OpaqueTracer can render the world.
template <class Real>
bool is_all_opaque(const World<Real>& world) {
    return !world.has_media && !world.has_transmission;
}

/// Traces rays through one world in which everything is opaque. One object per thread, because it
/// counts rays.
///
/// \tparam Recorder  Unrecorded, RayTreeRecorder or CutRecorder
template <class Real, class Recorder = Unrecorded>
class OpaqueTracer {
  public:
    OpaqueTracer(const World<Real>& world, const TraceLimits& limits, const Recorder& recorder = {})
        : world_(world), limits_(limits), lighting_(world, recorder) {}

    const RayCounts& counts() const { return lighting_.counts; }

    /// See Whitted.
    Vec3<Real>* seen_through = nullptr;

    /// The colour of a camera ray: see Whitted. The camera's position (third parameter) matters
    /// only with media.
    Vec3<Real> camera_ray(const Ray<Real>& ray, Real at_camera, const Ray<Real>&,
                          ProbeRecord<Real>* record) {
        ++lighting_.counts.primary;
        lighting_.record = record;
        const Real weight = 1;
        lighting_.recorder.begin_camera_ray();
        const Vec3<Real> color = trace(ray, {at_camera}, weight, 0);
        lighting_.recorder.end_call();
        return color;
    }

    /// The colour that any ray brings.
    Vec3<Real> trace(const Ray<Real>& ray, const Start<Real>& start, Real weight, int depth) {
        const NoMedia nowhere;
        lighting_.recorder.start(ray, start.t, nowhere, weight, depth);
        if (!is_followed(limits_, weight, depth)) {
            lighting_.recorder.end_at_limit(Vec3<Real>(1), weight, depth);
            return Vec3<Real>{};
        }
        Contact<Real> contact = nearest_contact(world_, ray, start, nowhere);
        if (contact.empty()) {
            lighting_.note(none);
            lighting_.recorder.end_in_background(Vec3<Real>(1));
            if (depth > 0 || seen_through == nullptr) return color_behind(world_, ray.dir);
            *seen_through = Vec3<Real>(1);
            return Vec3<Real>(0);
        }
        return shade(ray, contact, weight, depth);
    }

    /// The same for a ray that meets this first; not empty.
    Vec3<Real> shade(const Ray<Real>& ray, Contact<Real>& contact, Real weight, int depth) {
        const NoMedia nowhere;
        const Real t = contact.front().t;
        order_contact(world_, contact);
        lighting_.recorder.meet(t, contact, nowhere, Vec3<Real>(1));
        SurfaceList touched;
        for (const Hit<Real>& hit : contact) touched.push_back(hit.surface);
        const Surface<Real> s = make_surface(world_, ray, declared_first(contact));
        if (lighting_.record != nullptr) lighting_.record->remember(s, t);
        Crossed<Real, NoMedia> c{ray, touched, nowhere, nowhere};
        c.bent = ray.dir;
        lighting_.note(event_of(s));
        lighting_.recorder.shade(s, Vec3<Real>(1), Vec3<Real>(1));
        lighting_.recorder.end_opaque();
        Vec3<Real> result = lighting_.local_color(s, c);
        if (lighting_.record != nullptr) lighting_.record->settled = true;

        const Vec3<Real> mirror = mirror_of(s, ray);
        const Real mirror_weight = max_component(mirror);
        if (mirror_weight > 0 && is_followed(limits_, weight * mirror_weight, depth + 1)) {
            ++lighting_.counts.reflected;
            lighting_.recorder.begin_mirrored(Vec3<Real>(1), Vec3<Real>(1), mirror,
                                              weight * mirror_weight);
            const Ray<Real> reflected =
                make_ray(s.position, s.position_lo, mirrored(ray.dir, s.normal), s.error);
            result +=
                mirror * trace(reflected, {0, std::move(touched), left_for_good(s, reflected.dir)},
                               weight * mirror_weight, depth + 1);
            lighting_.recorder.end_call();
        } else {
            lighting_.recorder.skip_mirrored(mirror, weight * mirror_weight);
        }
        return result;
    }

  private:
    /// Of several surfaces in one contact, the one that the scene declares first is visible.
    const Hit<Real>& declared_first(const Contact<Real>& contact) const {
        const auto object = [&](const Hit<Real>& hit) {
            return world_.primitives[hit.surface.primitive].object;
        };
        return *std::min_element(contact.begin(), contact.end(), [&](const auto& a, const auto& b) {
            return object(a) < object(b);
        });
    }

    /// The share of light that the surface mirrors.
    Vec3<Real> mirror_of(const Surface<Real>& s, const Ray<Real>& ray) const {
        if (!s.finish->fresnel) return s.finish->reflection;
        return s.finish->reflection * opaque_reflectance(s, ray.dir, Real(1));
    }

    const World<Real>& world_;
    const TraceLimits limits_;
    Lighting<Real, NoMedia, Recorder> lighting_;
};

}  // namespace lancer
