// A second recursion, for the judge. It follows one of two policies: by_povray.h or by_lancer.h.
// Crossings, surfaces and the terms of shading are those of whitted.h. This file and the policies
// implement the rest a second time, and more simply: which hits count, which bodies contain a ray,
// what absorbs it, and which branches are followed. A policy object is the state that a ray
// carries.
#pragma once

#include "tracer/povray/by_lancer.h"
#include "tracer/povray/by_povray.h"
#include "tracer/povray/first_hit.h"
#include "tracer/recursion/whitted.h"

namespace lancer {

/// The ray that continues from a surface. The smallest distance of hits keeps it from meeting the
/// surface again.
template <class Real>
Ray<Real> ray_from(const Surface<Real>& s, const Vec3<Real>& direction) {
    return make_ray(s.position, s.position_lo, direction, s.error);
}

/// The share of light that reaches the start of `ray` from `distance` away.
template <class Real, class Rules>
requires requires(const Rules& rules, const Ray<Real>& ray) {
    rules.nearest_shadow(ray);
}
Vec3<Real> light_through(const World<Real>& world, Ray<Real> ray, Real distance,
                         const Start<Real>& /*start*/, Rules around,
                         const Unrecorded& = unrecorded) {
    around.begin_shadow(world);
    Vec3<Real> light(1);
    while (max_component(light) > 0) {
        const Real gap = around.nearest_shadow(ray);
        const Real last = std::min(distance - gap, around.farthest_hit());
        const auto hit = first_hit(world, ray, gap, last, Shadows::cast, around.entered());
        if (!hit) break;
        const Surface<Real> s = make_surface(world, ray, *hit);
        light = light * s.transmittance * around.left_after(world, hit->t) *
                around.left_behind(s, hit->t);
        around.pass_in_shadow(s);
        distance -= hit->t;
        ray = ray_from(s, ray.dir);
    }
    return light * around.left_after(world, distance);
}

/// Traces rays through one world a second way. One object per thread.
///
/// \tparam Rules  ByPovRay<Real> or ByLancer<Real>
template <class Real, class Rules>
class SecondTracer {
  public:
    /// \param unit  POV-Ray's unit of length in the world's
    SecondTracer(const World<Real>& world, Real unit)
        : world_(world),
          unit_(unit),
          limits_{world.settings.max_depth, world.settings.min_contribution},
          lighting_(world) {}

    const RayCounts& counts() const { return lighting_.counts; }

    /// See Whitted.
    Vec3<Real> camera_ray(const Ray<Real>& ray, Real at_camera, const Ray<Real>& from_camera,
                          ProbeRecord<Real>* record) {
        ++lighting_.counts.primary;
        lighting_.record = record;
        const Rules around(origins_.around(world_, from_camera).bodies, unit_);
        return trace(ray, at_camera, around, Real(1), 0);
    }

  private:
    using Step = Crossed<Real, Rules>;

    /// \param start  the ray's parameter there
    /// \param depth  rays that led to this one
    Vec3<Real> trace(Ray<Real> ray, Real start, Rules around, Real weight, int depth) {
        Vec3<Real> result(0);
        Vec3<Real> through(1);
        bool straight = false;
        for (int in_line = 0; in_line < max_surfaces_in_line; ++in_line) {
            if (weight < static_cast<Real>(limits_.min_contribution)) break;
            if (!Rules::is_depth_asked(depth, limits_.max_depth, straight)) break;
            const auto hit =
                first_hit(world_, ray, start + around.nearest_hit(ray),
                          start + around.farthest_hit(), Shadows::ignore, around.entered());
            if (!hit) {
                lighting_.note(none);
                return result + through * around.left_after(world_, unbounded) *
                                    color_behind(world_, ray.dir);
            }
            const Real way = hit->t - start;
            const Surface<Real> s = make_surface(world_, ray, *hit);
            if (lighting_.record != nullptr) lighting_.record->remember(s, hit->t);
            lighting_.note(event_of(s));
            through = through * around.left_after(world_, way);

            around.reach(s);
            Rules after = around;
            const Real ratio = after.cross(world_, s);
            Vec3<Real> mirror = s.finish->reflection;
            Vec3<Real> transmittance = s.transmittance;
            if (s.finish->fresnel) {
                mirror = mirror * around.fresnel(world_, s, ray, ratio);
                transmittance = transmittance * (Vec3<Real>(1) - mirror);
            }
            const bool passes_on = Rules::passes_on(s, transmittance, limits_);
            straight = passes_on && Rules::is_straight(ratio);
            const SurfaceList touched;
            Step c{ray, touched, around, Rules::beyond(around, after), ratio, false, ray.dir};
            if (passes_on && !straight && !refracted(ray.dir, s.normal, ratio, c.bent)) {
                c.total = true;
                c.bent = mirrored(ray.dir, s.normal);
            }
            result += through * lighting_.local_color(s, c);
            if (lighting_.record != nullptr) lighting_.record->settled = true;
            if (max_component(mirror) > 0 && !c.total) {
                ++lighting_.counts.reflected;
                const Vec3<Real> direction = mirrored(ray.dir, s.normal);
                result +=
                    through * mirror *
                    trace(ray_from(s, direction), 0, Rules::leaving(c, after, s, direction, false),
                          weight * max_component(mirror), depth + 1);
            }
            if (!passes_on) break;
            through = through * around.left_behind(s, way);
            if (!c.total) through = through * transmittance;
            weight *= max_component(Rules::weight_behind(s, transmittance, c.total));
            if (!straight) ++(c.total ? lighting_.counts.reflected : lighting_.counts.transmitted);
            if (!straight) ++depth;
            around = Rules::leaving(c, after, s, c.bent, !c.total);
            ray = ray_from(s, c.bent);
            start = 0;
        }
        return result;
    }

    static constexpr Real unbounded = std::numeric_limits<Real>::infinity();

    const World<Real>& world_;
    const Real unit_;
    const TraceLimits limits_;
    CameraMedia<Real> origins_;
    Lighting<Real, Rules> lighting_;
};

/// Calls work(tracer) with a tracer that follows POV-Ray's rules, or ours.
template <class Real, class Work>
void with_second_tracer(const World<Real>& world, Real unit, bool by_povray, Work& work) {
    if (by_povray) {
        SecondTracer<Real, ByPovRay<Real>> tracer(world, unit);
        work(tracer);
    } else {
        SecondTracer<Real, ByLancer<Real>> tracer(world, unit);
        work(tracer);
    }
}

}  // namespace lancer
