// The recursion, with transparent surfaces: follow() goes along the ray, bend() refracts, shade()
// mirrors with Fresnel reflectance, transmittance_between() absorbs. The formulas are in
// shading/optics.h; shadows through glass are in shading/shadow.h; wide/glass.h has the recursion
// for eight rays. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6) 1980;
// terms in docs/shading.md.
#pragma once

#include "tracer/intersect/edge_hits.h"
#include "tracer/rays/crossing.h"
#include "tracer/recursion/opaque.h"
#include "tracer/shading/coincident_surfaces.h"

namespace lancer {

/// Surfaces that a ray may pass straight (glass of the surrounding index, sheets); they cost no
/// depth.
inline constexpr int max_surfaces_in_line = 1000;

/// Traces rays through one world that has transparent surfaces. One object per thread, because it
/// counts rays.
///
/// \tparam Recorder  Unrecorded, RayTreeRecorder or CutRecorder
template <class Real, class Recorder = Unrecorded>
class Whitted {
  public:
    Whitted(const World<Real>& world, const TraceLimits& limits, const Recorder& recorder = {})
        : world_(world), limits_(limits), lighting_(world, recorder) {}

    const RayCounts& counts() const { return lighting_.counts; }

    /// For pictures with alpha, else null. It receives the share of the background's light in the
    /// camera ray's colour, seen directly or through glass but not in mirrors. The colour then does
    /// not contain that light.
    Vec3<Real>* seen_through = nullptr;

    /// The colour of a camera ray. The camera is at parameter `at_camera` (<= 0) of the ray;
    /// `from_camera` is the same line with its origin there. `record` may be null.
    Vec3<Real> camera_ray(const Ray<Real>& ray, Real at_camera, const Ray<Real>& from_camera,
                          ProbeRecord<Real>* record) {
        ++lighting_.counts.primary;
        lighting_.record = record;
        const Real weight = 1;
        lighting_.recorder.begin_camera_ray();
        const Vec3<Real> color =
            trace(ray, {at_camera}, origins_.around(world_, from_camera), weight, 0, {});
        lighting_.recorder.end_call();
        return color;
    }

    /// The colour of a ray that the surface it starts on has refracted or mirrored. It is returned
    /// term by term: the colour is 0 plus the arguments of all calls of add(), in their order.
    ///
    /// \param weight, depth  see is_followed()
    /// \param through  what the surfaces and media before let pass
    template <class Add>
    void follow(const Ray<Real>& ray, const Start<Real>& start, const Media& media, Real weight,
                int depth, const Vec3<Real>& through, const Add& add) {
        const SurfaceId turn = start.surfaces.empty() ? SurfaceId{} : start.surfaces.front();
        follow(ray, start, media, weight, depth, turn, through, add);
    }

  private:
    using Step = Crossed<Real, Media>;

    /// \param turn  the surface that refracted or mirrored the ray into this direction
    Vec3<Real> trace(const Ray<Real>& ray, const Start<Real>& start, const Media& media,
                     Real weight, int depth, const SurfaceId& turn) {
        Vec3<Real> result(0);
        follow(ray, start, media, weight, depth, turn, Vec3<Real>(1),
               [&](const Vec3<Real>& light) { result += light; });
        return result;
    }

    template <class Add>
    void follow(Ray<Real> ray, Start<Real> start, Media media, Real weight, int depth,
                SurfaceId turn, Vec3<Real> through, const Add& add) {
        RayCounts& counts = lighting_.counts;
        int surfaces_in_line{};
        lighting_.recorder.start(ray, start.t, media, weight, depth);
        bool looks_ahead = depth == 0 && seen_through != nullptr;
        while (is_followed(limits_, weight, depth)) {
            Contact<Real> contact = adjacent_face_hit(world_, ray, turn, media.bodies);
            bool at_once = !contact.empty();
            if (!at_once) contact = nearest_contact(world_, ray, start, media.bodies);
            if (world_.has_media && find_lost(ray, turn, media.bodies, contact)) at_once = true;
            turn = {};
            if (contact.empty()) {
                lighting_.note(none);
                const Vec3<Real> arrives = through * transmittance_to_infinity(media);
                lighting_.recorder.end_in_background(arrives);
                if (looks_ahead)
                    *seen_through = arrives;
                else
                    add(arrives * color_behind(world_, ray.dir));
                return;
            }
            const Real t = contact.front().t;
            if (world_.has_media) through = through * transmittance_between(media, start.t, t);
            order_contact(world_, contact);
            SurfaceList touched;
            if (at_once) touched = start.surfaces;
            for (const Hit<Real>& hit : contact) touched.push_back(hit.surface);
            const Media after = crossed(world_, media, contact);
            Step c{ray, touched, media, after};
            if (world_.has_media) c.ratio = index_of(world_, media) / index_of(world_, after);
            lighting_.recorder.meet(t, contact, after, through);
            drop_coincident(world_, contact, c.ratio);
            const Surfaces<Real> surfaces = shown(world_, contact, ray);
            Share share;
            if (!surfaces.empty()) {
                if (lighting_.record != nullptr) lighting_.record->remember(surfaces.front(), t);
                bend(surfaces.front(), c);
                lighting_.recorder.bend(c.ratio, c.total);
                share = shade(surfaces, c, through, weight, depth, add);
            }
            if (share.ended) {
                lighting_.recorder.end_opaque();
                return;
            }
            through = through * share.light;
            weight *= share.weight;
            if (c.ratio == 1) {
                if (++surfaces_in_line > max_surfaces_in_line) {
                    lighting_.recorder.end_after_surfaces(through);
                    return;
                }
                media = after;
                start = {t, std::move(touched), start.left, false};
                continue;
            }
            if (!is_followed(limits_, weight, depth + 1)) {
                lighting_.recorder.end_at_limit(through, weight, depth + 1);
                return;
            }
            ++(c.total ? counts.reflected : counts.transmitted);
            lighting_.recorder.begin_bent(c.total);
            looks_ahead = looks_ahead && !c.total;
            const Surface<Real>& front = surfaces.front();
            Media next = leaving(front, c, c.bent, !c.total);
            ray = make_ray(front.position, front.position_lo, c.bent, front.error);
            media = std::move(next);
            start = {0, std::move(touched), left_for_good(front, ray.dir)};
            turn = front.id;
            ++depth;
            lighting_.recorder.start(ray, start.t, media, weight, depth);
        }
        lighting_.recorder.end_at_limit(through, weight, depth);
    }

    /// Drops the bodies that lost a crossing, unless that crossing is found at an edge.
    ///
    /// \param contact  becomes that crossing
    /// \return whether it was found
    bool find_lost(const Ray<Real>& ray, const SurfaceId& turn, MediaList& bodies,
                   Contact<Real>& contact) {
        MediaList lost = lost_bodies(world_, bodies, ray, contact);
        if (lost.empty()) return false;
        bool found = false;
        if (contains(lost, turn.primitive)) {
            Contact<Real> at_edge = lost_face_hit(world_, ray, turn, bodies);
            found = !at_edge.empty();
            if (found) {
                contact = std::move(at_edge);
                lost = lost_bodies(world_, bodies, ray, contact);
            }
        }
        drop(bodies, lost);
        lighting_.counts.media_lost += lost.size();
        return found;
    }

    /// The media around a ray that leaves a surface. The geometric normal decides which bodies
    /// contain it. Whether it was refracted or mirrored decides which index counts for the next
    /// refraction, as in POV-Ray. The two may differ on smooth meshes, see Media.
    Media leaving(const Surface<Real>& s, const Step& c, const Vec3<Real>& direction,
                  bool refracted) const {
        Media media{c.towards(s, direction).bodies, {}};
        if (world_.has_smooth_media) media.optical = refracted ? c.after.optical : c.before.optical;
        return media;
    }

    void bend(const Surface<Real>& front, Step& c) const {
        c.bent = c.ray.dir;
        if (c.ratio == 1) return;
        if (refracted(c.ray.dir, front.normal, c.ratio, c.bent)) return;
        c.total = true;
        c.bent = mirrored(c.ray.dir, front.normal);
    }

    /// The share of the light from behind a contact that passes it.
    struct Share {
        bool ended = false;  ///< opaque
        Vec3<Real> light{1};
        Real weight = 1;
    };

    /// Adds the local light of the contact's surfaces, and the light that they mirror.
    template <class Add>
    Share shade(const Surfaces<Real>& surfaces, const Step& c, const Vec3<Real>& through,
                Real weight, int depth, const Add& add) {
        Share share;
        // The index changes once per contact, so there is one Fresnel term.
        const auto weighted =
            std::find_if(surfaces.begin(), surfaces.end(),
                         [](const Surface<Real>& s) { return s.finish->fresnel; });
        for (const Surface<Real>& s : surfaces) {
            lighting_.note(event_of(s));
            lighting_.recorder.shade(s, through, share.light);
            add(through * share.light * lighting_.local_color(s, c));
            if (lighting_.record != nullptr) lighting_.record->settled = true;
            const bool passes = max_component(s.transmittance) > 0;
            if (passes && c.total) {
                // The totally reflected ray replaces the reflected and the transmitted one. Its
                // light is not tinted.
                return {false, share.light, share.weight * max_component(s.transmittance)};
            }
            Vec3<Real> mirror = s.finish->reflection;
            if (s.finish->fresnel)
                mirror = &s == &*weighted ? mirror * fresnel(s, c) : Vec3<Real>{};
            const Real mirror_weight = weight * share.weight * max_component(mirror);
            if (max_component(mirror) > 0 && is_followed(limits_, mirror_weight, depth + 1)) {
                ++lighting_.counts.reflected;
                lighting_.recorder.begin_mirrored(through, share.light, mirror, mirror_weight);
                const Vec3<Real> direction = mirrored(c.ray.dir, s.normal);
                const Ray<Real> ray = make_ray(s.position, s.position_lo, direction, s.error);
                add(through * share.light * mirror *
                    trace(ray, {0, c.touched, left_for_good(s, direction)},
                          leaving(s, c, direction, false), mirror_weight, depth + 1, s.id));
                lighting_.recorder.end_call();
            } else {
                lighting_.recorder.skip_mirrored(mirror, mirror_weight);
            }
            if (!passes) return {true, share.light, share.weight};
            Vec3<Real> factor = s.transmittance;
            if (s.finish->fresnel) factor = factor * (Vec3<Real>(1) - mirror);
            share.light = share.light * factor;
            share.weight *= max_component(factor);
        }
        return share;
    }

    /// Fresnel reflectance with the indices before and after the surface. A transmissive sheet has
    /// the same medium on both sides.
    Real fresnel(const Surface<Real>& s, const Step& c) const {
        const bool tracked = world_.has_media && s.primitive->medium;
        if (tracked || max_component(s.transmittance) > 0)
            return fresnel_reflectance(-dot(s.normal, c.ray.dir), 1 / c.ratio);
        return opaque_reflectance(s, c.ray.dir, index_of(world_, c.before));
    }

    Vec3<Real> transmittance_between(const Media& media, Real from, Real to) const {
        const Finish<Real>* medium = medium_of(world_, media.bodies);
        if (medium == nullptr || !medium->absorbs) return Vec3<Real>(1);
        return beer_lambert_transmittance(medium->absorption, to - from);
    }
    Vec3<Real> transmittance_to_infinity(const Media& media) const {
        return transmittance_between(media, {}, std::numeric_limits<Real>::infinity());
    }

    const World<Real>& world_;
    const TraceLimits limits_;
    CameraMedia<Real> origins_;
    Lighting<Real, Media, Recorder> lighting_;
};

}  // namespace lancer
