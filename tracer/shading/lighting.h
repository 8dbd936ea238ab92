// A surface's local light: ambient, emitted, and reflected from the lamps. Terms in
// docs/shading.md.
#pragma once

#include "tracer/rays/ray_counts.h"
#include "tracer/shading/light_sample.h"
#include "tracer/shading/probe_record.h"
#include "tracer/shading/shadow.h"

namespace lancer {

/// The data of a contact that the terms of shading use.
template <class Real, class Media>
struct Crossed {
    const Ray<Real>& ray;
    const SurfaceList& touched;
    const Media& before;
    const Media& after;
    Real ratio = 1;      ///< index before over index after
    bool total = false;  ///< total internal reflection
    Vec3<Real> bent{};   ///< the refracted direction, or the mirrored one when `total`

    /// The media around a new ray that starts here in `direction`: those before the contact if the
    /// direction leads back to the side that the ray came from, else those after it. Only the
    /// geometric normal decides.
    const Media& towards(const Surface<Real>& s, const Vec3<Real>& direction) const {
        const bool back = (dot(s.geometric, direction) > 0) != (dot(s.geometric, ray.dir) > 0);
        return back ? before : after;
    }
};

/// The colour of a highlight: the light's, tinted by the surface's colour as far as `metallic`
/// says.
template <class Real>
Vec3<Real> tinted(const Surface<Real>& s, Real cosine, const Vec3<Real>& color) {
    const Real metallic = s.finish->metallic;
    if (metallic == 0) return color;
    const Real amount = metallic * (1 - metallic_share(cosine));
    return color * (Vec3<Real>(1) + amount * (s.color - Vec3<Real>(1)));
}

/// The sum of Phong's and Blinn's highlights for a light of this colour.
///
/// \param mirror  the ray's direction mirrored at the surface; only Phong's highlight uses it
/// \param cosine  cosine of the angle between the normal and `to_light`
template <class Real>
Vec3<Real> highlight(const Surface<Real>& s, const Vec3<Real>& ray_dir, const Vec3<Real>& mirror,
                     const Vec3<Real>& to_light, Real cosine, const Vec3<Real>& color) {
    const Finish<Real>& f = *s.finish;
    Real strength = 0;
    if (f.phong > 0) {
        const Real along = dot(mirror, to_light);
        if (along > 0) strength += f.phong * elementary::pow(along, f.shininess);
    }
    if (f.blinn > 0) {
        const Vec3<Real> half = to_light - ray_dir;
        const Real size = length(half);
        const Real along = dot(s.normal, half) / size;  // NaN if half is 0
        if (along > 0) strength += f.blinn * elementary::pow(along, f.inverse_roughness);
    }
    return tinted(s, cosine, color) * strength;
}

/// Computes the local light of surfaces of one world, and counts the shadow rays.
///
/// \tparam Around    Media, or NoMedia in worlds where rays carry no list of bodies
/// \tparam Recorder  Unrecorded, RayTreeRecorder or CutRecorder
template <class Real, class Around, class Recorder = Unrecorded>
class Lighting {
  public:
    explicit Lighting(const World<Real>& world, const Recorder& tells = {})
        : recorder(tells), world_(world) {}

    RayCounts counts;
    ProbeRecord<Real>* record = nullptr;  ///< may be null
    [[no_unique_address]] Recorder recorder;

    Vec3<Real> local_color(const Surface<Real>& s, const Crossed<Real, Around>& c) {
        if constexpr (!Recorder::wants_light) return {};
        const Finish<Real>& f = *s.finish;
        Vec3<Real> sum = s.opacity * s.color * (f.ambient * world_.ambient + f.emission);
        const bool glossy = f.phong > 0 || f.blinn > 0;
        const bool matt_in_front = f.diffuse > 0 && s.opacity > 0;
        recorder.glow(sum);
        const Vec3<Real> mirror = f.phong > 0 ? mirrored(c.ray.dir, s.normal) : Vec3<Real>{};
        for (std::size_t i = 0; i < world_.lights.size(); ++i) {
            const LightSource<Real>& light = world_.lights[i];
            const LightSample<Real> at = sample_light(light, s.position, s.position_lo);
            const Real cosine = dot(s.normal, at.direction);
            const bool front = cosine > 0;
            const bool asked = front ? matt_in_front || glossy : f.lit_from_behind;
            recorder.ask_light(i, at, cosine, asked);
            if (!asked) continue;
            const Vec3<Real> color = at.color * reaching(i, light, s, c, at);
            if (!(max_component(absolute(color)) > 0)) continue;
            const Vec3<Real> matt = s.opacity * s.color * color;
            if (front) {
                sum += matt * (f.diffuse * cosine);
                if (glossy && light.shadows)
                    sum += highlight(s, c.ray.dir, mirror, at.direction, cosine, color);
            } else {
                sum += matt * (f.diffuse_transmission * -cosine);
                const Real toward = dot(c.bent, at.direction);
                if (f.phong_transmission > 0 && light.shadows && !c.total && toward > 0)
                    sum += tinted(s, cosine, color) *
                           (f.phong_transmission * elementary::pow(toward, f.shininess));
            }
            recorder.end_light(sum);
        }
        return sum;
    }

    void note(std::uint64_t event) {
        if (record != nullptr) record->note(event);
    }

  private:
    /// The share of light `i` that reaches the surface.
    Vec3<Real> reaching(std::size_t i, const LightSource<Real>& light, const Surface<Real>& s,
                        const Crossed<Real, Around>& c, const LightSample<Real>& at) {
        Vec3<Real> share(1);
        if (world_.settings.shadows && light.shadows && max_component(absolute(at.color)) > 0) {
            ++counts.shadow;
            const Ray<Real> ray = make_ray(s.position, s.position_lo, at.direction, s.error);
            const Start<Real> start{0, c.touched, left_for_good(s, at.direction)};
            share = light_through(world_, ray, at.distance, start, c.towards(s, at.direction),
                                  recorder);
        }
        recorder.arrive(share);
        const bool arrives = record != nullptr && max_component(share) > 0;
        note((std::uint64_t(i) << 1) + (arrives ? 1 : 0));
        if (arrives && !record->settled && i < 64) record->lit |= std::uint64_t(1) << i;
        return share;
    }

    const World<Real>& world_;
};

}  // namespace lancer
