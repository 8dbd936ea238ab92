// POV-Ray 3.7's rules, as a policy for recursion.h: docs/export.md, "Known differences". They were
// found by experiments (tests/reference/pov/rules_reference_test.cpp) and in POV-Ray's published
// source.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "tracer/intersect/media.h"
#include "tracer/rays/trace_limits.h"
#include "tracer/shading/lighting.h"

namespace lancer {

/// The state that a ray carries, and the rules that depend on it.
template <class Real>
class ByPovRay {
  public:
    using Step = Crossed<Real, ByPovRay>;

    /// \param bodies  that contain the camera
    /// \param unit    POV-Ray's unit of length in the world's
    ByPovRay(const MediaList& bodies, Real unit) : passed_(bodies), unit_(unit) {}

    // --- Which surfaces a ray sees: absolute distances

    Real nearest_hit(const Ray<Real>& /*ray*/) const { return Real(1e-4L) * unit_; }
    /// Surfaces near either end cast no shadow.
    Real nearest_shadow(const Ray<Real>& /*ray*/) const { return Real(1e-3L) * unit_; }
    Real farthest_hit() const { return Real(1e7L) * unit_; }
    /// Nothing: the distances hold for the other faces of a thin body, too.
    static std::optional<SurfaceId> entered() { return std::nullopt; }
    void reach(const Surface<Real>& /*s*/) {}

    // --- Which rays are followed

    /// A ray that passes straight through keeps its depth, but POV-Ray asks again: on the last one
    /// it brings nothing.
    static bool is_depth_asked(int depth, int max_depth, bool straight) {
        return depth + (straight ? 1 : 0) < std::min(max_depth, 256);
    }
    /// \param transmittance  reduced by the mirrored share
    static bool passes_on(const Surface<Real>& /*s*/, const Vec3<Real>& transmittance,
                          const TraceLimits& limits) {
        const Real grey = Real(0.297L) * transmittance.x + Real(0.589L) * transmittance.y +
                          Real(0.114L) * transmittance.z;
        return std::min(grey, Real(1)) > static_cast<Real>(limits.min_contribution);
    }
    /// POV-Ray does not refract at a smaller step of the index.
    static bool is_straight(Real ratio) { return std::abs(ratio - 1) < Real(1e-10L); }
    /// The factor of a ray's weight behind the surface, totally reflected or not.
    static const Vec3<Real>& weight_behind(const Surface<Real>& /*s*/,
                                           const Vec3<Real>& transmittance, bool /*total*/) {
        return transmittance;
    }

    // --- Which objects contain the ray

    /// Adds the surface's object to the list or removes it. Returns the ratio of the index before
    /// to the index after. The ratio is 1 if the ray leaves an object that was not entered last. It
    /// is computed in double against empty space, but in single precision between two objects.
    Real cross(const World<Real>& world, const Surface<Real>& s) {
        const std::uint32_t own = s.id.primitive;
        const bool last = !passed_.empty() && passed_.back() == own;
        const auto outer = [&]() -> std::optional<float> {
            if (passed_.empty()) return std::nullopt;
            return index(world, passed_.back());
        };
        if (!contains(passed_, own)) {
            const auto from = outer();
            passed_.push_back(own);
            return from ? Real(*from / index(world, own)) : 1 / Real(index(world, own));
        }
        toggle(passed_, own);
        if (!last) return 1;
        const auto to = outer();
        return to ? Real(index(world, own) / *to) : Real(index(world, own));
    }

    /// The objects around shadow rays on the far side of a surface: the same as in front of it.
    static const ByPovRay& beyond(const ByPovRay& before, const ByPovRay& /*after*/) {
        return before;
    }

    /// The objects around a refracted or mirrored ray that leaves a surface.
    static ByPovRay leaving(const Step& c, const ByPovRay& after, const Surface<Real>& /*s*/,
                            const Vec3<Real>& /*direction*/, bool refracted) {
        return refracted ? after : c.before;
    }

    // --- Absorption

    /// 1: a path as such does not dim; left_behind() does.
    Vec3<Real> left_after(const World<Real>& /*world*/, Real /*way*/) const {
        return Vec3<Real>(1);
    }
    /// The factor by which POV-Ray multiplies at a surface for the path that ends there. It is 1
    /// unless the surface belongs to a body in the list, at any position. So the path dims only the
    /// light from behind the surface, and nothing dims the last surface.
    Vec3<Real> left_behind(const Surface<Real>& s, Real way) const {
        const bool dims =
            s.primitive->body && s.finish->absorbs && contains(passed_, s.id.primitive);
        return dims ? beer_lambert_transmittance(s.finish->absorption, way) : Vec3<Real>(1);
    }

    void begin_shadow(const World<Real>& /*world*/) {}
    void pass_in_shadow(const Surface<Real>& s) { toggle(passed_, s.id.primitive); }

    // --- Fresnel reflectance

    Real fresnel(const World<Real>& world, const Surface<Real>& s, const Ray<Real>& ray,
                 Real /*ratio*/) const {
        return fresnel_reflectance(-dot(s.normal, ray.dir), index_beyond(world, s));
    }

  private:
    /// An index as POV-Ray stores it. Opaque surfaces have one as well, for Fresnel mirrors.
    static float index(const World<Real>& world, std::uint32_t primitive) {
        const Primitive<Real>& p = world.primitives[primitive];
        const bool sheet = !p.body && p.transmissive;
        return sheet ? 1.0F : static_cast<float>(world.finishes[p.material].ior);
    }

    /// The index beyond the surface over the index before it. When the ray leaves a body, the index
    /// beyond is that of the last object in the list, which may be the body itself.
    Real index_beyond(const World<Real>& world, const Surface<Real>& s) const {
        const float own = index(world, s.id.primitive);
        if (passed_.empty()) return Real(own);
        const float last = index(world, passed_.back());
        if (!contains(passed_, s.id.primitive)) return Real(own / last);
        return passed_.size() == 1 ? 1 / Real(own) : Real(last / own);
    }

    /// Bodies and sheets that the ray has crossed an odd number of times, whatever the sides of
    /// surfaces.
    MediaList passed_;
    Real unit_;
};

}  // namespace lancer
