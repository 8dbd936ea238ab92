// The recursion by POV-Ray 3.7's rules, for the judge of pictures: docs/export.md, "Known
// differences". Crossings, surfaces and the terms of shading are those of our own recursion
// (whitted.h); which hits count, what a ray is taken to be in, what dims it and which branches are
// followed is POV-Ray's, as found by experiment (tests/reference/pov/rules_reference_test.cpp) and
// in its published source.
#pragma once

#include <optional>

#include "tracer/lighting.h"
#include "tracer/whitted.h"

namespace lancer {

/// What POV-Ray carries with a ray.
template <class Real>
struct PovRayAround {
    /// What the ray was seen to pass and not yet to pass again: bodies, and sheets too, in that
    /// order. The sides of surfaces take no part in it.
    MediaList passed;
    Real unit = 1;  ///< POV-Ray's unit of length in the world's

    Real nearest_hit() const { return Real(1e-4L) * unit; }
    Real nearest_shadow() const { return Real(1e-3L) * unit; }
    Real farthest_hit() const { return Real(1e7L) * unit; }
};

/// The one surface that POV-Ray sees first between two parameters of the ray; of several in one
/// place the first declared, though POV-Ray promises none.
template <class Real>
std::optional<Hit<Real>> povray_hit(const World<Real>& world, const Ray<Real>& ray, Real first,
                                    Real last, Shadows shadows) {
    std::optional<Hit<Real>> nearest;
    const auto limit = [&] { return nearest ? nearest->t : last; };
    const Stretch<Real, decltype(limit)> stretch{first, limit};
    const auto object = [&](std::uint32_t index) { return world.primitives[index].object; };
    const auto visit = [&](std::uint32_t index) {
        const Primitive<Real>& p = world.primitives[index];
        if (shadows == Shadows::cast && !p.casts_shadow) return false;
        primitive_crossings(
            world, p, ray, Known{}, stretch, [&](const Crossing<Real>& c, Real u, Real v) {
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
    for (std::uint32_t i = world.bounded; i < end; ++i) visit(i);
    candidates(world, ray, stretch, visit);
    return nearest;
}

/// The ray goes on from a surface, which a rule of distance keeps it from meeting again.
template <class Real>
Ray<Real> ray_from(const Surface<Real>& s, const Vec3<Real>& direction) {
    return make_ray(s.position, s.position_lo, direction, s.error);
}

/// What POV-Ray multiplies by at a surface for the stretch that ends there: nothing, unless the
/// surface is of a body that the ray passed into, wherever in the list it stands.
template <class Real>
Vec3<Real> povray_dimming(const PovRayAround<Real>& around, const Surface<Real>& s, Real way) {
    const bool dims =
        s.primitive->body && s.finish->absorbs && contains(around.passed, s.id.primitive);
    return dims ? absorbed(s.finish->absorption, way) : Vec3<Real>(1);
}

/// The share of light that POV-Ray lets reach the start of `ray` from `distance` away. It sees no
/// shadow next to either end, and nothing dims the last stretch.
template <class Real>
Vec3<Real> light_through(const World<Real>& world, Ray<Real> ray, Real distance,
                         const Start<Real>& /*start*/, PovRayAround<Real> around) {
    const Real gap = around.nearest_shadow();
    Vec3<Real> light(1);
    while (max_component(light) > 0) {
        const Real last = std::min(distance - gap, around.farthest_hit());
        const auto hit = povray_hit(world, ray, gap, last, Shadows::cast);
        if (!hit) break;
        const Surface<Real> s = make_surface(world, ray, *hit);
        light = light * s.passing * povray_dimming(around, s, hit->t);
        toggle(around.passed, s.id.primitive);
        distance -= hit->t;
        ray = ray_from(s, ray.dir);
    }
    return light;
}

/// Traces rays through one world by POV-Ray's rules. One object per thread.
template <class Real>
class PovRayTracer {
  public:
    /// \param unit  POV-Ray's unit of length in the world's
    PovRayTracer(const World<Real>& world, Real unit)
        : world_(world), unit_(unit), lighting_(world) {}

    const RayCounts& counts() const { return lighting_.counts; }

    /// See Whitted.
    Vec3<Real> camera_ray(const Ray<Real>& ray, Real at_camera, const Ray<Real>& from_camera,
                          Witness<Real>* witness) {
        ++lighting_.counts.primary;
        lighting_.witness = witness;
        const Around around{origins_.around(world_, from_camera).bodies, unit_};
        return trace(ray, at_camera, around, Real(1), 0);
    }

  private:
    using Around = PovRayAround<Real>;

    /// \param start  the ray's parameter there
    /// \param level  rays that led to this one
    Vec3<Real> trace(Ray<Real> ray, Real start, Around around, Real weight, int level) {
        const Settings& settings = world_.settings;
        const auto bailout = static_cast<Real>(settings.min_contribution);
        Vec3<Real> result(0);
        Vec3<Real> through(1);
        bool straight = false;
        for (int passes = 0; passes < max_straight_passes; ++passes) {
            // A ray that passes straight through keeps its level, but asks again: on the last one
            // it brings nothing.
            if (level >= std::min(settings.max_depth, 256) || weight < bailout) break;
            if (!straight) ++level;
            const auto hit = povray_hit(world_, ray, start + around.nearest_hit(),
                                        start + around.farthest_hit(), Shadows::ignore);
            if (!hit) {
                lighting_.note(none);
                return result + through * world_.background;
            }
            const Surface<Real> s = make_surface(world_, ray, *hit);
            if (lighting_.witness != nullptr) lighting_.witness->remember(s, hit->t);
            lighting_.note(event_of(s));

            Vec3<Real> mirror = s.finish->reflection;
            if (s.finish->fresnel)
                mirror = mirror * fresnel_reflectance(-dot(s.normal, ray.dir), beyond(around, s));
            Vec3<Real> passing = s.passing;
            if (s.finish->fresnel) passing = passing * (Vec3<Real>(1) - mirror);
            const bool passes_on = std::min(grey(passing), Real(1)) > bailout;
            Around after = around;
            const Real ratio = passed(after, s);
            straight = passes_on && is_one(ratio);
            const SurfaceList touched;
            Crossed<Real, Around> c{ray, touched, around, around, ratio, false, ray.dir};
            if (passes_on && !straight && !refracted(ray.dir, s.normal, ratio, c.bent)) {
                c.total = true;
                c.bent = mirrored(ray.dir, s.normal);
            }
            result += through * lighting_.local_color(s, c);
            if (lighting_.witness != nullptr) lighting_.witness->settled = true;
            if (max_component(mirror) > 0 && !c.total) {
                ++lighting_.counts.reflected;
                result += through * mirror *
                          trace(ray_from(s, mirrored(ray.dir, s.normal)), 0, around,
                                weight * max_component(mirror), level);
            }
            if (!passes_on) break;
            through = through * povray_dimming(around, s, hit->t - start);
            if (!c.total) {
                through = through * passing;
                around = std::move(after);
            }
            weight *= max_component(passing);
            if (!straight) ++(c.total ? lighting_.counts.reflected : lighting_.counts.transmitted);
            ray = ray_from(s, c.bent);
            start = 0;
        }
        return result;
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
    CameraMedia<Real> origins_;
    Lighting<Real, Around> lighting_;
};

}  // namespace lancer
