// POV-Ray 3.7's rules, as recursion.h asks for them: docs/export.md, "Known differences". What
// POV-Ray does was found by experiment (tests/reference/pov/rules_reference_test.cpp) and in its
// published source.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "tracer/intersect/media.h"
#include "tracer/rays/trace_limits.h"
#include "tracer/shading/lighting.h"

namespace lancer {

/// What is carried with a ray, and what follows from it.
template <class Real>
class ByPovRay {
  public:
    using Step = Crossed<Real, ByPovRay>;

    /// \param bodies  around the camera
    /// \param unit    POV-Ray's unit of length in the world's
    ByPovRay(const MediaList& bodies, Real unit) : passed_(bodies), unit_(unit) {}

    // --- Which surfaces a ray sees: absolute distances

    Real nearest_hit(const Ray<Real>& /*ray*/) const { return Real(1e-4L) * unit_; }
    /// No shadow is seen next to either end.
    Real nearest_shadow(const Ray<Real>& /*ray*/) const { return Real(1e-3L) * unit_; }
    Real farthest_hit() const { return Real(1e7L) * unit_; }

    // --- Which rays are followed

    /// A ray that passes straight through keeps its depth, but POV-Ray asks again: on the last one
    /// it brings nothing.
    static bool is_depth_asked(int depth, int max_depth, bool straight) {
        return depth + (straight ? 1 : 0) < std::min(max_depth, 256);
    }
    /// \param transmittance  with what the mirror left
    static bool passes_on(const Surface<Real>& /*s*/, const Vec3<Real>& transmittance,
                          const TraceLimits& limits) {
        const Real grey = Real(0.297L) * transmittance.x + Real(0.589L) * transmittance.y +
                          Real(0.114L) * transmittance.z;
        return std::min(grey, Real(1)) > static_cast<Real>(limits.min_contribution);
    }
    /// POV-Ray bends nothing at a smaller step of the index.
    static bool is_straight(Real ratio) { return std::abs(ratio - 1) < Real(1e-10L); }
    /// How much of a ray's weight goes on, totally reflected or not.
    static const Vec3<Real>& weight_behind(const Surface<Real>& /*s*/,
                                           const Vec3<Real>& transmittance, bool /*total*/) {
        return transmittance;
    }

    // --- What the ray is in

    /// Takes the surface into the list or from it. Returns the ratio of the indices before and
    /// after: 1 where what is left is not what was entered last. Against empty space it is formed
    /// in double, between two indices in single precision.
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

    /// What is around the shadow rays on the far side of a surface, too: what was in front of it.
    static const ByPovRay& beyond(const ByPovRay& before, const ByPovRay& /*after*/) {
        return before;
    }

    /// What is around a ray that leaves a surface, refracted or mirrored.
    static ByPovRay leaving(const Step& c, const ByPovRay& after, const Surface<Real>& /*s*/,
                            const Vec3<Real>& /*direction*/, bool refracted) {
        return refracted ? after : c.before;
    }

    // --- What dims

    /// What is left of light after a way, whatever it ends at.
    Vec3<Real> left_after(const World<Real>& /*world*/, Real /*way*/) const {
        return Vec3<Real>(1);
    }
    /// What POV-Ray multiplies by at a surface for the way that ends there: nothing, unless the
    /// surface is of a body that the ray passed into, wherever in the list it stands. So the way
    /// dims what is behind the surface alone, and nothing dims the last one.
    Vec3<Real> left_behind(const Surface<Real>& s, Real way) const {
        const bool dims =
            s.primitive->body && s.finish->absorbs && contains(passed_, s.id.primitive);
        return dims ? beer_lambert_transmittance(s.finish->absorption, way) : Vec3<Real>(1);
    }

    void begin_shadow(const World<Real>& /*world*/) {}
    void pass_in_shadow(const Surface<Real>& s) { toggle(passed_, s.id.primitive); }

    // --- Fresnel's term

    Real fresnel(const World<Real>& world, const Surface<Real>& s, const Ray<Real>& ray,
                 Real /*ratio*/) const {
        return fresnel_reflectance(-dot(s.normal, ray.dir), index_beyond(world, s));
    }

  private:
    /// An index as POV-Ray keeps it. What does not let light pass gets one for its mirror's sake.
    static float index(const World<Real>& world, std::uint32_t primitive) {
        const Primitive<Real>& p = world.primitives[primitive];
        const bool sheet = !p.body && p.transmissive;
        return sheet ? 1.0F : static_cast<float>(world.finishes[p.material].ior);
    }

    /// The index beyond the surface against that before it: out of a body it is that of the last
    /// in the list, which may be the body itself.
    Real index_beyond(const World<Real>& world, const Surface<Real>& s) const {
        const float own = index(world, s.id.primitive);
        if (passed_.empty()) return Real(own);
        const float last = index(world, passed_.back());
        if (!contains(passed_, s.id.primitive)) return Real(own / last);
        return passed_.size() == 1 ? 1 / Real(own) : Real(last / own);
    }

    /// Bodies and sheets that the ray was seen to pass and not yet to pass again, whatever the
    /// sides of surfaces.
    MediaList passed_;
    Real unit_;
};

}  // namespace lancer
