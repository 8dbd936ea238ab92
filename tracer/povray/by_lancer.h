// Lancer's own rules, as a policy for recursion.h: our picture, if each contact were a single
// surface.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "tracer/intersect/media.h"
#include "tracer/rays/trace_limits.h"
#include "tracer/recursion/opaque.h"
#include "tracer/shading/lighting.h"

namespace lancer {

/// The state that a ray carries, and the rules that depend on it.
template <class Real>
class ByLancer {
  public:
    using Step = Crossed<Real, ByLancer>;

    /// \param bodies  that contain the camera
    /// \param unit    POV-Ray's unit of length in the world's
    ByLancer(const MediaList& bodies, Real unit)
        : bending_(bodies), absorbing_(bodies), unit_(unit) {}

    // --- Which surfaces a ray sees: all except the one that it leaves

    Real nearest_hit(const Ray<Real>& ray) const { return off_the_surface(ray); }
    Real nearest_shadow(const Ray<Real>& ray) const { return off_the_surface(ray); }
    Real farthest_hit() const { return std::numeric_limits<Real>::infinity(); }
    /// See first_hit().
    const std::optional<SurfaceId>& entered() const { return entered_; }

    /// The ray reaches the surface. What starts there on the ray's own side is inside of a body
    /// that the ray would leave.
    void reach(const Surface<Real>& s) { stand_on(s, !s.id.entering); }

    // --- Which rays are followed

    static bool is_depth_asked(int depth, int max_depth, bool /*straight*/) {
        return depth < max_depth;
    }
    static bool passes_on(const Surface<Real>& s, const Vec3<Real>& /*transmittance*/,
                          const TraceLimits& /*limits*/) {
        return max_component(s.transmittance) > 0;
    }
    static bool is_straight(Real ratio) { return ratio == 1; }
    /// The factor of a ray's weight behind the surface. A totally reflected ray replaces the
    /// transmitted and the mirrored one.
    static const Vec3<Real>& weight_behind(const Surface<Real>& s, const Vec3<Real>& transmittance,
                                           bool total) {
        return total ? s.transmittance : transmittance;
    }

    // --- Which bodies contain the ray

    /// Adds the surface's body to the lists or removes it. Returns the ratio of the index before to
    /// the index after.
    Real cross(const World<Real>& world, const Surface<Real>& s) {
        const Real before = index(world);
        if (s.primitive->medium) {
            toggle(bending_, s.id.primitive);
            toggle(absorbing_, s.id.primitive);
        }
        stand_on(s, s.id.entering);
        return before / index(world);
    }

    /// The bodies around shadow rays on the far side of a surface.
    static const ByLancer& beyond(const ByLancer& /*before*/, const ByLancer& after) {
        return after;
    }

    /// The bodies around a refracted or mirrored ray that leaves a surface. The side to which it
    /// leaves decides what absorbs it.
    static ByLancer leaving(const Step& c, const ByLancer& after, const Surface<Real>& s,
                            const Vec3<Real>& direction, bool refracted) {
        ByLancer next = c.towards(s, direction);
        next.bending_ = refracted ? after.bending_ : c.before.bending_;
        return next;
    }

    // --- Absorption

    /// The transmittance of a path of this length through the body that was entered last.
    Vec3<Real> left_after(const World<Real>& world, Real way) const {
        const Finish<Real>* medium = medium_of(world, absorbing_);
        return medium != nullptr && medium->absorbs
                   ? beer_lambert_transmittance(medium->absorption, way)
                   : Vec3<Real>(1);
    }
    /// 1, because left_after() already dims the surface at the end of the path and all behind it.
    Vec3<Real> left_behind(const Surface<Real>& /*s*/, Real /*way*/) const { return Vec3<Real>(1); }

    /// A body that casts no shadow does not absorb a shadow ray.
    void begin_shadow(const World<Real>& world) {
        const auto casts_none = [&](std::uint32_t body) {
            return !world.primitives[body].casts_shadow;
        };
        absorbing_.erase(std::remove_if(absorbing_.begin(), absorbing_.end(), casts_none),
                         absorbing_.end());
    }
    void pass_in_shadow(const Surface<Real>& s) {
        if (s.primitive->medium) toggle(absorbing_, s.id.primitive);
        stand_on(s, s.id.entering);
    }

    // --- Fresnel reflectance

    Real fresnel(const World<Real>& world, const Surface<Real>& s, const Ray<Real>& ray,
                 Real ratio) const {
        if (s.primitive->medium || max_component(s.transmittance) > 0)
            return fresnel_reflectance(-dot(s.normal, ray.dir), 1 / ratio);
        return opaque_reflectance(s, ray.dir, index(world));
    }

  private:
    Real off_the_surface(const Ray<Real>& ray) const {
        return Real(1e-8L) * unit_ + 1000 * ray.origin_error;
    }
    void stand_on(const Surface<Real>& s, bool inside) {
        entered_ = s.primitive->body && inside ? std::optional(s.id) : std::nullopt;
    }
    /// The refractive index of the body that was entered last.
    Real index(const World<Real>& world) const {
        const Finish<Real>* medium = medium_of(world, bending_);
        return medium == nullptr ? Real(1) : medium->ior;
    }

    MediaList bending_;    ///< bodies that the ray has entered and not yet left, for refraction
    MediaList absorbing_;  ///< bodies that contain it by the sides of surfaces, for absorption
    std::optional<SurfaceId> entered_;  ///< the surface that it starts on, inside of its body
    Real unit_;
};

}  // namespace lancer
