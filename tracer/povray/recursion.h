// A second recursion, for the judge of pictures. It goes by POV-Ray 3.7's rules or, without them,
// by our own: docs/export.md, "Known differences". Crossings, surfaces and the terms of
// shading are those of whitted.h; which hits count, what a ray is taken to be in, what dims it and
// which branches are followed is said here once more, and more simply: a ray starts a small way off
// the surface that it leaves, and of what lies in one place it meets one surface. What POV-Ray does
// was found by experiment (tests/reference/pov/rules_reference_test.cpp) and in its published
// source.
#pragma once

#include <optional>

#include "tracer/rays/crossing.h"
#include "tracer/recursion/whitted.h"
#include "tracer/shading/lighting.h"

namespace lancer {

/// What is carried with a ray.
template <class Real>
struct PovRayAround {
    /// What the ray was seen to pass and not yet to pass again, whatever the sides of surfaces: by
    /// POV-Ray's rules bodies and sheets, without them the bodies that bend it.
    MediaList passed;
    /// Without the rules: the bodies that it is in by the sides of surfaces, which absorb.
    MediaList inside;
    Real unit = 1;         ///< POV-Ray's unit of length in the world's
    bool by_rules = true;  ///< else as Lancer has it

    Real nearest_hit(const Ray<Real>& ray) const {
        return by_rules ? Real(1e-4L) * unit : off_the_surface(ray);
    }
    Real nearest_shadow(const Ray<Real>& ray) const {
        return by_rules ? Real(1e-3L) * unit : off_the_surface(ray);
    }
    Real off_the_surface(const Ray<Real>& ray) const {
        return Real(1e-8L) * unit + 1000 * ray.origin_error;
    }
    Real farthest_hit() const {
        return by_rules ? Real(1e7L) * unit : std::numeric_limits<Real>::infinity();
    }
};

/// The one surface that is seen first between two parameters of the ray; of several in one place
/// the first declared, though POV-Ray promises none.
template <class Real>
std::optional<Hit<Real>> povray_hit(const World<Real>& world, const Ray<Real>& ray, Real first,
                                    Real last, Shadows shadows) {
    std::optional<Hit<Real>> nearest;
    const auto limit = [&] { return nearest ? nearest->t : last; };
    const RayInterval<Real, decltype(limit)> interval{first, limit};
    const auto object = [&](std::uint32_t index) { return world.primitives[index].object; };
    const auto visit = [&](std::uint32_t index) {
        const Primitive<Real>& p = world.primitives[index];
        if (shadows == Shadows::cast && !p.casts_shadow) return false;
        primitive_crossings(
            world, p, ray, IntersectionHints{}, interval,
            [&](const Crossing<Real>& c, Real u, Real v) {
                if (!(c.t >= first) || !(c.t <= limit())) return false;
                if (nearest && c.t == nearest->t &&
                    object(index) > object(nearest->surface.primitive))
                    return false;
                nearest = Hit<Real>{c.t, c.error, {index, c.face, c.entering}, u, v};
                return false;
            });
        return false;
    };
    const auto end = static_cast<std::uint32_t>(world.primitives.size());
    for (std::uint32_t i = world.planes; i < end; ++i) visit(i);
    candidates(world, ray, interval, visit);
    return nearest;
}

/// The ray goes on from a surface, which a rule of distance keeps it from meeting again.
template <class Real>
Ray<Real> ray_from(const Surface<Real>& s, const Vec3<Real>& direction) {
    return make_ray(s.position, s.position_lo, direction, s.error);
}

/// What POV-Ray multiplies by at a surface for the interval that ends there: nothing, unless the
/// surface is of a body that the ray passed into, wherever in the list it stands.
template <class Real>
Vec3<Real> povray_dimming(const PovRayAround<Real>& around, const Surface<Real>& s, Real way) {
    const bool dims =
        s.primitive->body && s.finish->absorbs && contains(around.passed, s.id.primitive);
    return dims ? beer_lambert_transmittance(s.finish->absorption, way) : Vec3<Real>(1);
}

/// What is left of light after a way through the body that was entered last.
template <class Real>
Vec3<Real> dimmed_inside(const World<Real>& world, const MediaList& inside, Real way) {
    const Finish<Real>* medium = medium_of(world, inside);
    return medium != nullptr && medium->absorbs
               ? beer_lambert_transmittance(medium->absorption, way)
               : Vec3<Real>(1);
}

/// The share of light that reaches the start of `ray` from `distance` away. POV-Ray sees no shadow
/// next to either end, and nothing dims the last interval.
template <class Real>
Vec3<Real> light_through(const World<Real>& world, Ray<Real> ray, Real distance,
                         const Start<Real>& /*start*/, PovRayAround<Real> around,
                         const Unrecorded& = unrecorded) {
    const auto casts_none = [&](std::uint32_t body) {
        return !world.primitives[body].casts_shadow;
    };
    MediaList& inside = around.inside;
    inside.erase(std::remove_if(inside.begin(), inside.end(), casts_none), inside.end());
    Vec3<Real> light(1);
    while (max_component(light) > 0) {
        const Real gap = around.nearest_shadow(ray);
        const Real last = std::min(distance - gap, around.farthest_hit());
        const auto hit = povray_hit(world, ray, gap, last, Shadows::cast);
        if (!hit) break;
        const Surface<Real> s = make_surface(world, ray, *hit);
        light = light * s.transmittance;
        if (around.by_rules) {
            light = light * povray_dimming(around, s, hit->t);
            toggle(around.passed, s.id.primitive);
        } else {
            light = light * dimmed_inside(world, inside, hit->t);
            if (s.primitive->medium) toggle(inside, s.id.primitive);
        }
        distance -= hit->t;
        ray = ray_from(s, ray.dir);
    }
    return around.by_rules ? light : light * dimmed_inside(world, inside, distance);
}

/// Traces rays through one world a second way. One object per thread.
template <class Real>
class PovRayTracer {
  public:
    /// \param unit      POV-Ray's unit of length in the world's
    /// \param by_rules  by POV-Ray's, else by Lancer's own
    PovRayTracer(const World<Real>& world, Real unit, bool by_rules)
        : world_(world), unit_(unit), by_rules_(by_rules), lighting_(world) {}

    const RayCounts& counts() const { return lighting_.counts; }

    /// See Whitted.
    Vec3<Real> camera_ray(const Ray<Real>& ray, Real at_camera, const Ray<Real>& from_camera,
                          ProbeRecord<Real>* record) {
        ++lighting_.counts.primary;
        lighting_.record = record;
        const MediaList bodies = origins_.around(world_, from_camera).bodies;
        return trace(ray, at_camera, {bodies, bodies, unit_, by_rules_}, Real(1), 0);
    }

  private:
    using Around = PovRayAround<Real>;
    using Step = Crossed<Real, Around>;

    /// \param start  the ray's parameter there
    /// \param level  rays that led to this one
    Vec3<Real> trace(Ray<Real> ray, Real start, Around around, Real weight, int level) {
        Vec3<Real> result(0);
        Vec3<Real> through(1);
        bool straight = false;
        for (int passes = 0; passes < max_straight_passes; ++passes) {
            if (!is_asked(weight, level, straight)) break;
            const auto hit = povray_hit(world_, ray, start + around.nearest_hit(ray),
                                        start + around.farthest_hit(), Shadows::ignore);
            if (!hit) {
                lighting_.note(none);
                return result +
                       through * dimmed_before(around, unbounded) * color_behind(world_, ray.dir);
            }
            const Surface<Real> s = make_surface(world_, ray, *hit);
            if (lighting_.record != nullptr) lighting_.record->remember(s, hit->t);
            lighting_.note(event_of(s));
            through = through * dimmed_before(around, hit->t - start);

            Around after = around;
            const Real ratio = by_rules_ ? passed(after, s) : crossed_into(after, s);
            Vec3<Real> mirror = s.finish->reflection;
            if (s.finish->fresnel) mirror = mirror * fresnel(s, ray, around, ratio);
            Vec3<Real> transmittance = s.transmittance;
            if (s.finish->fresnel) transmittance = transmittance * (Vec3<Real>(1) - mirror);
            const bool passes_on = by_rules_ ? std::min(grey(transmittance), Real(1)) > bailout()
                                             : max_component(s.transmittance) > 0;
            straight = passes_on && (by_rules_ ? is_one(ratio) : ratio == 1);
            const SurfaceList touched;
            Step c{ray, touched, around, by_rules_ ? around : after, ratio, false, ray.dir};
            if (passes_on && !straight && !refracted(ray.dir, s.normal, ratio, c.bent)) {
                c.total = true;
                c.bent = mirrored(ray.dir, s.normal);
            }
            result += through * lighting_.local_color(s, c);
            if (lighting_.record != nullptr) lighting_.record->settled = true;
            if (max_component(mirror) > 0 && !c.total) {
                ++lighting_.counts.reflected;
                const Vec3<Real> direction = mirrored(ray.dir, s.normal);
                result += through * mirror *
                          trace(ray_from(s, direction), 0, leaving(c, after, s, direction, false),
                                weight * max_component(mirror), level + 1);
            }
            if (!passes_on) break;
            if (by_rules_) through = through * povray_dimming(around, s, hit->t - start);
            if (!c.total) through = through * transmittance;
            weight *= max_component(c.total && !by_rules_ ? s.transmittance : transmittance);
            if (!straight) ++(c.total ? lighting_.counts.reflected : lighting_.counts.transmitted);
            if (!straight) ++level;
            around = leaving(c, after, s, c.bent, !c.total);
            ray = ray_from(s, c.bent);
            start = 0;
        }
        return result;
    }

    /// A ray that passes straight through keeps its level, but POV-Ray asks again: on the last one
    /// it brings nothing.
    bool is_asked(Real weight, int level, bool straight) const {
        const int levels = world_.settings.max_depth;
        if (weight < bailout()) return false;
        if (!by_rules_) return level < levels;
        return level + (straight ? 1 : 0) < std::min(levels, 256);
    }
    Real bailout() const { return static_cast<Real>(world_.settings.min_contribution); }

    static constexpr Real unbounded = std::numeric_limits<Real>::infinity();

    /// By Lancer's rules a interval dims all that lies behind it.
    Vec3<Real> dimmed_before(const Around& around, Real way) const {
        return by_rules_ ? Vec3<Real>(1) : dimmed_inside(world_, around.inside, way);
    }

    /// What is around a ray that leaves a surface, refracted or mirrored.
    Around leaving(const Step& c, const Around& after, const Surface<Real>& s,
                   const Vec3<Real>& direction, bool refracted) const {
        const Around& optical = refracted ? after : c.before;
        if (by_rules_) return optical;
        Around next = c.towards(s, direction);
        next.passed = optical.passed;
        return next;
    }

    Real fresnel(const Surface<Real>& s, const Ray<Real>& ray, const Around& around,
                 Real ratio) const {
        const Real cosine = -dot(s.normal, ray.dir);
        if (by_rules_) return fresnel_reflectance(cosine, beyond(around, s));
        if (s.primitive->medium || max_component(s.transmittance) > 0)
            return fresnel_reflectance(cosine, 1 / ratio);
        return opaque_reflectance(s, ray.dir, index_in(around.passed));
    }

    /// By Lancer's rules: takes the surface into the lists or from them. Returns the ratio of the
    /// indices before and after.
    Real crossed_into(Around& around, const Surface<Real>& s) const {
        const Real before = index_in(around.passed);
        if (s.primitive->medium) {
            toggle(around.passed, s.id.primitive);
            toggle(around.inside, s.id.primitive);
        }
        return before / index_in(around.passed);
    }
    Real index_in(const MediaList& bodies) const {
        const Finish<Real>* medium = medium_of(world_, bodies);
        return medium == nullptr ? Real(1) : medium->ior;
    }

    static Real grey(const Vec3<Real>& c) {
        return Real(0.297L) * c.x + Real(0.589L) * c.y + Real(0.114L) * c.z;
    }
    /// POV-Ray bends nothing at a smaller step of the index.
    static bool is_one(Real ratio) { return std::abs(ratio - 1) < Real(1e-10L); }

    /// An index as POV-Ray keeps it. What does not let light pass gets one for its mirror's sake.
    float index(std::uint32_t primitive) const {
        const Primitive<Real>& p = world_.primitives[primitive];
        const bool sheet = !p.body && p.transmissive;
        return sheet ? 1.0F : static_cast<float>(world_.finishes[p.material].ior);
    }

    /// Takes the surface into the list or from it. Returns the ratio of the indices before and
    /// after: 1 where what is left is not what was entered last. Against empty space it is formed
    /// in double, between two indices in single precision.
    Real passed(Around& around, const Surface<Real>& s) const {
        MediaList& list = around.passed;
        const std::uint32_t own = s.id.primitive;
        const bool last = !list.empty() && list.back() == own;
        const bool known = contains(list, own);
        const auto outer = [&]() -> std::optional<float> {
            if (list.empty()) return std::nullopt;
            return index(list.back());
        };
        if (!known) {
            const auto from = outer();
            list.push_back(own);
            return from ? Real(*from / index(own)) : 1 / Real(index(own));
        }
        toggle(list, own);
        if (!last) return 1;
        const auto to = outer();
        return to ? Real(index(own) / *to) : Real(index(own));
    }

    /// The index beyond the surface against that before it, as Fresnel's term takes it: out of a
    /// body it is that of the last in the list, which may be the body itself.
    Real beyond(const Around& around, const Surface<Real>& s) const {
        const float own = index(s.id.primitive);
        if (around.passed.empty()) return Real(own);
        const float last = index(around.passed.back());
        if (!contains(around.passed, s.id.primitive)) return Real(own / last);
        return around.passed.size() == 1 ? 1 / Real(own) : Real(last / own);
    }

    const World<Real>& world_;
    Real unit_;
    bool by_rules_;
    CameraMedia<Real> origins_;
    Lighting<Real, Around> lighting_;
};

}  // namespace lancer
