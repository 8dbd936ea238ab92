// Shadows through transparent objects, by one search instead of one search per contact.
//
// light_by_contacts() goes from contact to contact, because each contact changes the list of bodies
// that the ray is in. One search gives the same contacts if all crossings are far enough from each
// other, from the start and from the light: each crossing is computed from the same ray by the same
// formula, each contact holds a single crossing, and the bodies passed so far decide which
// crossings count. If a condition fails, light_through() calls light_by_contacts(). So this is a
// fast path to the same result.
#pragma once

#include "tracer/intersect/media.h"
#include "tracer/intersect/passes.h"
#include "tracer/shading/unrecorded.h"

namespace lancer {

/// The light that passes the crossings which one search has found.
template <class Real>
class SeeThrough : public Passes<Real> {
  public:
    /// \param distance  to the light
    SeeThrough(const World<Real>& world, Real distance) : Passes<Real>(distance), world_(world) {}

    /// Sorts the crossings. Returns whether they are enough for transmittance().
    ///
    /// \param start   where the search began
    /// \param bodies  that contain the first part of the ray
    bool tells_all(const Start<Real>& start, const MediaList& bodies) {
        if (!clear_ || !start.fresh || start.t != 0) return false;
        for (const std::uint32_t body : bodies) {
            const Primitive<Real>& p = world_.primitives[body];
            if (!p.casts_shadow || world_.finishes[p.material].absorbs) return false;
        }
        std::sort(all_.begin(), all_.end(), [](const Pass& a, const Pass& b) { return a.t < b.t; });
        for (std::size_t i = 1; i < all_.size(); ++i) {
            const Pass& before = all_[i - 1];
            const Pass& pass = all_[i];
            // light_by_contacts() uses another formula for a primitive that the ray starts on, once
            // the ray has passed another surface.
            if (pass.touched || !(pass.t - before.t > apart * (before.error + pass.error)))
                return false;
        }
        return !hides_a_way_out(start, bodies);
    }

    /// The product of the transmittances of all surfaces that the ray passes, in their order.
    template <class Recorder = const Unrecorded>
    Vec3<Real> transmittance(MediaList bodies, Recorder& recorder = unrecorded) const {
        Vec3<Real> light(1);
        for (const Pass& pass : all_) {
            const Primitive<Real>& p = world_.primitives[pass.primitive];
            if (p.medium) {
                if (contains(bodies, pass.primitive) == pass.entering) continue;
                toggle(bodies, pass.primitive);
            }
            const Finish<Real>& finish = world_.finishes[p.material];
            const Vec3<Real> passes =
                finish.filter * finish.color + Vec3<Real>(finish.transmission);
            recorder.filter(SurfaceId{pass.primitive, 0, pass.entering}, pass.t, passes);
            light = light * passes;
            if (!(max_component(light) > 0)) return Vec3<Real>(0);
        }
        return light;
    }

  private:
    using Passes<Real>::all_;
    using Passes<Real>::apart;
    using Passes<Real>::clear_;
    using typename Passes<Real>::Pass;

    /// Whether the ray starts on a body that it is inside of, and its first crossing is not with
    /// that body. The light may be inside, or rounding may hide the exit.
    bool hides_a_way_out(const Start<Real>& start, const MediaList& bodies) const {
        return std::any_of(start.surfaces.begin(), start.surfaces.end(),
                           [&](const SurfaceId& surface) {
                               if (!contains(bodies, surface.primitive)) return false;
                               return all_.empty() || all_.front().primitive != surface.primitive;
                           });
    }

    const World<Real>& world_;
};

}  // namespace lancer
