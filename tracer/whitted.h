// The recursion: what a ray brings back.
// Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6) 1980; terms in
// docs/shading.md.
#pragma once

#include "tracer/lights.h"
#include "tracer/render.h"
#include "tracer/seams.h"
#include "tracer/shadow.h"

namespace lancer {

/// Straight passes (glass of the surrounding index, sheets) that one ray may make; they cost no
/// depth.
inline constexpr int max_straight_passes = 1000;

/// What a caller may want to know beside the colour. Members that are null are not collected.
template <class Real>
struct Witness {
    bool met = false;        ///< the ray met something
    bool settled = false;    ///< the first surface's lights are known
    Surface<Real> surface;   ///< the first surface met
    Real distance = 0;       ///< to it
    std::uint64_t lit = 0;   ///< Probe::lit
    std::uint64_t path = 0;  ///< Probe::path

    void note(std::uint64_t event) { path = (path ^ event) * 0x9E3779B97F4A7C15u + (path >> 29); }
};

/// Traces rays through one world. One object per thread: it counts what it does.
template <class Real>
class Whitted {
  public:
    explicit Whitted(const World<Real>& world, bool absorption_by_povray = false)
        : world_(world), absorption_by_povray_(absorption_by_povray) {}

    RayCounts counts;

    /// The colour that a camera ray brings. `witness` may be null.
    Vec3<Real> camera_ray(const Ray<Real>& ray, Witness<Real>* witness) {
        ++counts.primary;
        witness_ = witness;
        return trace(ray, {}, origins_.around(world_, ray), Real(1), 0);
    }

  private:
    /// A contact as the terms of shading see it.
    struct Crossed {
        const Ray<Real>& ray;
        const SurfaceList& touched;
        const MediaList& before;
        const MediaList& after;
        Real ratio = 1;      ///< of the indices before and after
        bool total = false;  ///< total internal reflection
        Vec3<Real> bent{0};  ///< the refracted direction, or the mirrored one when `total`
    };

    /// \param weight  product along the way of the largest channel of each factor
    /// \param level   reflections and bends so far
    Vec3<Real> trace(Ray<Real> ray, Start<Real> start, MediaList media, Real weight, int level) {
        Vec3<Real> result(0);
        Vec3<Real> through(1);  // what the surfaces and media on the way let pass
        int straight_passes = 0;
        while (is_followed(weight, level)) {
            Contact<Real> contact = nearest_contact(world_, ray, start, media);
            if (contact.empty()) {
                note(none);
                counts.media_lost += drop_bounded(world_, media);
                return result + through * passed_forever(media) * world_.background;
            }
            const Real t = contact.front().t;
            Vec3<Real> dimmed(1);
            if (world_.has_media) {
                counts.media_lost += drop_lost(world_, media, ray, t);
                dimmed = absorbed_between(media, start.t, t);
                if (!absorption_by_povray_) through = through * dimmed;
            }
            order_contact(world_, contact);
            SurfaceList touched;
            for (const Hit<Real>& hit : contact) touched.push_back(hit.surface);
            const MediaList after = crossed(world_, media, contact);
            Crossed c{ray, touched, media, after};
            if (world_.has_media) c.ratio = index_of(world_, media) / index_of(world_, after);
            if (contact.size() > 1) drop_seams(world_, contact, c.ratio);
            const Surfaces surfaces = resolve(contact, ray);
            Share share;
            if (!surfaces.empty()) {
                remember(surfaces.front(), t);
                bend(surfaces.front(), c);
                share = shade(surfaces, c, through, weight, level, result);
            }
            if (share.ended) return result;
            through = through * share.light;
            if (absorption_by_povray_ && is_dimmed_by_povray(surfaces, media, c.total))
                through = through * dimmed;
            weight *= share.weight;
            if (c.ratio == 1) {
                if (++straight_passes > max_straight_passes) return result;
                media = after;
                start = {t, false, std::move(touched)};
                continue;
            }
            if (!is_followed(weight, level + 1)) return result;
            ++(c.total ? counts.reflected : counts.transmitted);
            const Surface<Real>& front = surfaces.front();
            MediaList next = side(front, c, c.bent) ? media : after;
            ray = make_ray(front.position, front.position_lo, c.bent, front.error);
            media = std::move(next);
            start = {0, true, std::move(touched)};
            ++level;
        }
        return result;
    }

    using Surfaces = boost::container::small_vector<Surface<Real>, 2>;

    /// Whether POV-Ray dims what passes: when the stretch ends on the medium's own body. A total
    /// reflection that Fresnel's equations give is to POV-Ray a mirror's, which it does not dim.
    bool is_dimmed_by_povray(const Surfaces& surfaces, const MediaList& media, bool total) const {
        if (surfaces.empty()) return true;
        const Finish<Real>* finish = surfaces.front().finish;
        return finish == medium_of(world_, media) && !(total && finish->fresnel);
    }

    /// Beyond the limits a ray brings black, so it need not be cast.
    bool is_followed(Real weight, int level) const {
        return level < world_.settings.max_depth &&
               weight >= static_cast<Real>(world_.settings.min_contribution);
    }

    /// The surfaces of an ordered contact that show: an opaque one hides all others.
    Surfaces resolve(const Contact<Real>& contact, const Ray<Real>& ray) const {
        Surfaces surfaces;
        for (const Hit<Real>& hit : contact) surfaces.push_back(make_surface(world_, ray, hit));
        const Surface<Real>* opaque = nullptr;
        for (const Surface<Real>& s : surfaces) {
            const bool earlier =
                opaque == nullptr || s.primitive->object < opaque->primitive->object;
            if (!(max_component(s.passing) > 0) && earlier) opaque = &s;
        }
        if (opaque != nullptr) {
            const Surface<Real> only = *opaque;
            surfaces.assign(1, only);
        }
        return surfaces;
    }

    void bend(const Surface<Real>& front, Crossed& c) const {
        c.bent = c.ray.dir;
        if (c.ratio == 1) return;
        if (refracted(c.ray.dir, front.normal, c.ratio, c.bent)) return;
        c.total = true;
        c.bent = mirrored(c.ray.dir, front.normal);
    }

    /// What a contact leaves of the light from behind it.
    struct Share {
        bool ended = false;  ///< opaque
        Vec3<Real> light{1};
        Real weight = 1;
    };

    /// Adds what the contact itself sends, and what it mirrors, to `result`.
    Share shade(const Surfaces& surfaces, const Crossed& c, const Vec3<Real>& through, Real weight,
                int level, Vec3<Real>& result) {
        Share share;
        bool fresnel_done = false;  // one optical step in a contact, so one Fresnel term
        for (const Surface<Real>& s : surfaces) {
            note(s.id.primitive * std::uint64_t(31) + s.id.face);
            result += through * share.light * local_color(s, c);
            if (witness_ != nullptr) witness_->settled = true;
            const bool passes = max_component(s.passing) > 0;
            if (passes && c.total) {
                // The mirror ray takes the place of the reflected and of the transmitted one; what
                // it brings is not tinted.
                return {false, share.light, share.weight * max_component(s.passing)};
            }
            Vec3<Real> mirror = s.finish->reflection;
            if (s.finish->fresnel) {
                mirror = fresnel_done ? Vec3<Real>(0) : mirror * fresnel(s, c);
                fresnel_done = true;
            }
            const Real mirror_weight = max_component(mirror);
            if (mirror_weight > 0) {
                const Vec3<Real> direction = mirrored(c.ray.dir, s.normal);
                const Ray<Real> ray = make_ray(s.position, s.position_lo, direction, s.error);
                if (is_followed(weight * share.weight * mirror_weight, level + 1))
                    ++counts.reflected;
                result +=
                    through * share.light * mirror *
                    trace(ray, {0, true, c.touched}, side(s, c, direction) ? c.before : c.after,
                          weight * share.weight * mirror_weight, level + 1);
            }
            if (!passes) return {true, share.light, share.weight};
            Vec3<Real> factor = s.passing;
            if (s.finish->fresnel) factor = factor * (Vec3<Real>(1) - mirror);
            share.light = share.light * factor;
            share.weight *= max_component(factor);
        }
        return share;
    }

    /// Fresnel's reflectance with the indices before and after the surface. An opaque body, which
    /// no list tracks, uses its own index; a sheet that light passes has the same medium on both
    /// sides.
    Real fresnel(const Surface<Real>& s, const Crossed& c) const {
        const Real cosine = -dot(s.normal, c.ray.dir);
        const bool tracked = world_.has_media && s.primitive->medium;
        if (tracked || max_component(s.passing) > 0)
            return fresnel_reflectance(cosine, 1 / c.ratio);
        const Real outside = index_of(world_, c.before);
        const Real index = s.finish->ior / outside;
        const bool out_of_body = s.primitive->body && !s.id.entering;
        return fresnel_reflectance(cosine, out_of_body ? 1 / index : index);
    }

    /// Whether `direction` leads to the side of the true surface that the ray came from.
    bool side(const Surface<Real>& s, const Crossed& c, const Vec3<Real>& direction) const {
        return (dot(s.geometric, direction) > 0) != (dot(s.geometric, c.ray.dir) > 0);
    }

    /// The surface's own light: ambient, emitted, and what the lights bring out of it.
    Vec3<Real> local_color(const Surface<Real>& s, const Crossed& c) {
        const Finish<Real>& f = *s.finish;
        Vec3<Real> sum = s.opacity * s.color * (f.ambient * world_.ambient + f.emission);
        const bool glossy = f.phong > 0 || f.blinn > 0;
        const bool matt_in_front = f.diffuse > 0 && s.opacity > 0;
        const Vec3<Real> mirror = f.phong > 0 ? mirrored(c.ray.dir, s.normal) : Vec3<Real>(0);
        for (std::size_t i = 0; i < world_.lights.size(); ++i) {
            const LightSource<Real>& light = world_.lights[i];
            const Illumination<Real> at = illuminate(light, s.position, s.position_lo);
            const Real cosine = dot(s.normal, at.direction);
            const bool front = cosine > 0;
            if (front ? !(matt_in_front || glossy) : !(cosine < 0 && f.lit_from_behind)) continue;
            const Vec3<Real> color = at.color * reaching(i, light, s, c, at);
            if (!(max_component(color) > 0)) continue;
            const Vec3<Real> matt = s.opacity * s.color * color;
            if (front) {
                sum += matt * (f.diffuse * cosine);
                if (glossy && light.shadows)
                    sum += highlight(s, c, mirror, at.direction, cosine, color);
            } else {
                sum += matt * (f.diffuse_transmission * -cosine);
                const Real toward = dot(c.bent, at.direction);
                if (f.phong_transmission > 0 && light.shadows && !c.total && toward > 0)
                    sum += tinted(s, cosine, color) *
                           (f.phong_transmission * elementary::pow(toward, f.shininess));
            }
        }
        return sum;
    }

    Vec3<Real> highlight(const Surface<Real>& s, const Crossed& c, const Vec3<Real>& mirror,
                         const Vec3<Real>& to_light, Real cosine, const Vec3<Real>& color) const {
        const Finish<Real>& f = *s.finish;
        Real strength = 0;
        if (f.phong > 0) {
            const Real along = dot(mirror, to_light);
            if (along > 0) strength += f.phong * elementary::pow(along, f.shininess);
        }
        if (f.blinn > 0) {
            const Vec3<Real> half = to_light - c.ray.dir;
            const Real size = length(half);
            const Real along = size > 0 ? dot(s.normal, half) / size : Real(0);
            if (along > 0) strength += f.blinn * elementary::pow(along, f.inverse_roughness);
        }
        return tinted(s, cosine, color) * strength;
    }

    /// The colour of a highlight: the light's, drawn to the surface's by `metallic`.
    Vec3<Real> tinted(const Surface<Real>& s, Real cosine, const Vec3<Real>& color) const {
        const Real metallic = s.finish->metallic;
        if (metallic == 0) return color;
        const Real amount = metallic * (1 - metallic_share(cosine));
        return color * (Vec3<Real>(1) + amount * (s.color - Vec3<Real>(1)));
    }

    /// The share of light `i` that shadows leave.
    Vec3<Real> reaching(std::size_t i, const LightSource<Real>& light, const Surface<Real>& s,
                        const Crossed& c, const Illumination<Real>& at) {
        Vec3<Real> share(1);
        if (world_.settings.shadows && light.shadows && max_component(at.color) > 0) {
            ++counts.shadow;
            const Ray<Real> ray = make_ray(s.position, s.position_lo, at.direction, s.error);
            share = light_through(world_, ray, at.distance, c.touched,
                                  side(s, c, at.direction) ? c.before : c.after);
        }
        const bool arrives = max_component(share) > 0;
        note((std::uint64_t(i) << 1) + (arrives ? 1 : 0));
        if (witness_ != nullptr && !witness_->settled && arrives && i < 64)
            witness_->lit |= std::uint64_t(1) << i;
        return share;
    }

    Vec3<Real> absorbed_between(const MediaList& media, Real from, Real to) const {
        const Finish<Real>* medium = medium_of(world_, media);
        if (medium == nullptr || !medium->absorbs) return Vec3<Real>(1);
        return absorbed(medium->absorption, to - from);
    }
    Vec3<Real> passed_forever(const MediaList& media) const {
        return absorbed_between(media, 0, std::numeric_limits<Real>::infinity());
    }

    void note(std::uint64_t event) {
        if (witness_ != nullptr) witness_->note(event);
    }
    void remember(const Surface<Real>& s, Real t) {
        if (witness_ == nullptr || witness_->met) return;
        witness_->met = true;
        witness_->surface = s;
        witness_->distance = t;
    }

    const World<Real>& world_;
    bool absorption_by_povray_;
    CameraMedia<Real> origins_;
    Witness<Real>* witness_ = nullptr;
};

}  // namespace lancer
