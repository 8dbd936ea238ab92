// The hits that are one contact: what a ray meets first, all in one place. What is decided with it:
// which hits belong to it (NearestContact, here; of a composite's parts: make_contacts() in
// composite_crossings.h; of the two faces at a mesh's edge: adjacent_face_hit() in edge_hits.h),
// their order (order_contact()), the bodies behind it
// (crossed() in media.h), what of it is a surface (shading/coincident_surfaces.h), refraction
// (recursion/whitted.h), shadows (light_by_contacts() in shading/shadow.h). Why: docs/shading.md.
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>

#include "tracer/rays/crossing.h"
#include "tracer/scene/geometry.h"

namespace lancer {

template <class Real>
struct Hit {
    Real t;
    Real error;
    SurfaceId surface;
    Real u = 0;  ///< barycentric coordinates of the second and third corner; triangles only
    Real v = 0;
};

template <class Real>
using Contact = boost::container::small_vector<Hit<Real>, 4>;

/// Collects the hits that are one contact: the nearest, n, and each h that cannot be told apart
/// from it, t_h - t_n <= e_n + min(e_h, 7 e_n), unless h lies beyond t + 8 e of any hit.
///
/// The order of the search cannot change the contact: the limit is the least t + 8 e of all hits,
/// and a hit that is dropped beyond it has a larger one, so all orders end with the same limit, and
/// only hits beyond that one are dropped.
template <class Real>
class NearestContact {
  public:
    /// \param contact  empty; receives the hits, the nearest first
    explicit NearestContact(Contact<Real>& contact) : contact_(contact) {}

    Real limit() const { return limit_; }

    /// Announces a hit that will be added later, so that nothing beyond `limit` can belong to the
    /// contact.
    void expect(Real limit) {
        if (limit < limit_) limit_ = limit;
    }

    [[gnu::always_inline]] void add(const Hit<Real>& hit) {
        if (!(hit.t <= limit_)) return;
        if (!contact_.empty()) return add_to_others(hit);
        contact_.push_back(hit);
        expect(hit.t + 8 * hit.error);
    }

    /// Call after the last add(): drops the hits that do not belong to the contact.
    void settle() {
        if (contact_.size() < 2) return;
        const Hit<Real> nearest = contact_.front();
        const auto apart = [&](const Hit<Real>& h) {
            const Real own = std::min(h.error, 7 * nearest.error);
            return !(h.t <= limit_ && h.t - nearest.t <= nearest.error + own);
        };
        contact_.erase(std::remove_if(contact_.begin() + 1, contact_.end(), apart), contact_.end());
    }

  private:
    [[gnu::noinline]] void add_to_others(const Hit<Real>& hit) {
        expect(hit.t + 8 * hit.error);
        Hit<Real>& nearest = contact_.front();
        if (!before(hit, nearest)) {
            contact_.push_back(hit);
            return;
        }
        const Hit<Real> second = nearest;
        nearest = hit;
        // The others lie beyond the second, so they are out of reach when it is.
        if (second.t > limit_)
            contact_.resize(1);
        else
            contact_.push_back(second);
    }
    static bool before(const Hit<Real>& a, const Hit<Real>& b) {
        if (a.t != b.t) return a.t < b.t;
        return a.surface.primitive < b.surface.primitive;
    }
    Contact<Real>& contact_;  ///< hits after the first may lie beyond the present limit
    Real limit_ = std::numeric_limits<Real>::infinity();
};

/// Sorts a contact: entries before exits, each in the order of declaration.
template <class Real>
void order_contact(const Geometry<Real>& geometry, Contact<Real>& contact) {
    if (contact.size() < 2) return;
    std::sort(contact.begin(), contact.end(), [&](const Hit<Real>& a, const Hit<Real>& b) {
        if (a.surface.entering != b.surface.entering) return a.surface.entering;
        const std::uint32_t object_a = geometry.primitives[a.surface.primitive].object;
        const std::uint32_t object_b = geometry.primitives[b.surface.primitive].object;
        if (object_a != object_b) return object_a < object_b;
        return a.surface.face < b.surface.face;
    });
}
}  // namespace lancer
