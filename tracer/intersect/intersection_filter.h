// Which crossings count for a ray. This depends on where it starts (Start) and on the bodies that
// it is in (MediaList, or NoMedia in worlds without transparent surfaces).
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <optional>

#include "tracer/rays/crossing.h"
#include "tracer/scene/geometry.h"

namespace lancer {

using SurfaceList = boost::container::small_vector<SurfaceId, 4>;
/// The bodies (primitives) that a ray is inside of, in the order in which it entered them. Their
/// number has no fixed limit.
using MediaList = boost::container::small_vector<std::uint32_t, 8>;

/// Replaces MediaList in worlds where all surfaces are opaque. There no list is needed, and the
/// code is compiled without the cost of one (docs/performance.md).
struct NoMedia {};

inline bool contains(const MediaList& media, std::uint32_t primitive) {
    return std::find(media.begin(), media.end(), primitive) != media.end();
}

/// Where a ray starts or continues.
template <class Real>
struct Start {
    Real t = 0;                 ///< hits before this parameter are behind
    SurfaceList surfaces{};     ///< of the contact that it comes from
    std::uint32_t left = none;  ///< a solid that it leaves for good: left_for_good()
    /// True: the origin lies on `surfaces`. False: the ray passed straight through them at t.
    bool fresh = true;
};

/// Decides which crossings count, for a ray with this start and these bodies around it.
///
/// The state rule holds for media: the ray can only leave a body that it is in, and only enter a
/// body that it is not in; this also holds at distance 0. So coincident and glued faces need no
/// tolerance. Any other crossing must lie ahead by more than its error bound. There is one
/// exception: a ray enters an opaque body at distance 0 if its chord in the body is longer than
/// rounding errors.
///
/// \tparam Bodies  MediaList, or NoMedia
template <class Real, class Bodies>
class IntersectionFilter {
  public:
    IntersectionFilter(const Geometry<Real>& geometry, const Start<Real>& start,
                       const Bodies& bodies)
        : geometry_(geometry), start_(start), bodies_(bodies) {
        if (start.surfaces.empty()) return;
        touched_ = start.surfaces.front().primitive;
        touches_more_ = start.surfaces.size() > 1;
    }

    IntersectionHints hints(std::uint32_t primitive) const {
        IntersectionHints k;
        if (may_touch(primitive) && start_.fresh) {
            for (const SurfaceId& s : start_.surfaces) {
                if (s.primitive == primitive) k.start_face = s.face;
            }
        }
        if constexpr (lists_media) {
            if (is_medium(geometry_.primitives[primitive])) {
                k.inside = contains(bodies_, primitive);
                k.one_way = true;
            }
        }
        return k;
    }

    /// Whether the crossing counts.
    bool operator()(std::uint32_t primitive, const Crossing<Real>& c) const {
        const Primitive<Real>& p = geometry_.primitives[primitive];
        const Real ahead = c.t - start_.t;
        if (ahead < -c.error) return false;
        const bool touched = starts_on(primitive);
        if (touched && repeats(p, primitive, c)) return false;
        if (is_medium(p)) return contains_here(primitive) != c.entering;
        if (ahead > c.error) return true;
        if (touched && p.composite() == nullptr) return false;
        return p.body && c.entering && c.chord > 4 * c.error;  // enters an opaque body
    }

    const Start<Real>& start() const { return start_; }
    /// Whether the ray is in the body; nothing if the body is not a medium.
    std::optional<bool> state_of(std::uint32_t primitive) const {
        if (!is_medium(geometry_.primitives[primitive])) return std::nullopt;
        return contains_here(primitive);
    }

    /// Whether an entry (`entering`) or an exit counts, if it lies ahead by more than its error and
    /// the ray does not start on the primitive.
    bool lets_pass(std::uint32_t primitive, bool entering) const {
        return !is_medium(geometry_.primitives[primitive]) || contains_here(primitive) != entering;
    }

    /// The parameter of a crossing that counts: the start if rounding put the crossing before it.
    Real met_at(const Crossing<Real>& c) const { return c.t < start_.t ? start_.t : c.t; }

    /// Whether the ray starts on the primitive, or passed straight through it just now.
    bool starts_on(std::uint32_t primitive) const {
        if (!may_touch(primitive)) return false;
        for (const SurfaceId& s : start_.surfaces) {
            if (s.primitive == primitive) return true;
        }
        return false;
    }

    /// The bodies that the ray is in and the boxes of which it may start outside of.
    ///
    /// A start lies on one face of its contact, in the box of what has that face. A contact is as
    /// wide as its errors: its other faces, and the box that ends with them, may lie behind the
    /// start. A ray that leads away from there never meets the box, and a search by boxes does not
    /// find the way out, which is at the start. A start on one face alone of a body that is no
    /// composite is in that body's box.
    MediaList in_beyond_boxes() const {
        MediaList found;
        if constexpr (lists_media) {
            for (const std::uint32_t body : bodies_) {
                if (body < geometry_.bounded && is_medium(geometry_.primitives[body]) &&
                    (geometry_.primitives[body].composite() != nullptr ||
                     (touches_more_ && starts_on(body))))
                    found.push_back(body);
            }
        }
        return found;
    }

  private:
    static constexpr bool lists_media = !std::is_same_v<Bodies, NoMedia>;

    /// A fast test: if false, the ray does not start on the primitive.
    bool may_touch(std::uint32_t primitive) const { return primitive == touched_ || touches_more_; }

    /// Whether a crossing with a primitive that the ray starts on is the one where it starts.
    [[gnu::noinline]] bool repeats(const Primitive<Real>& p, std::uint32_t primitive,
                                   const Crossing<Real>& c) const {
        if (p.composite() != nullptr) return false;  // CompositeWalk leaves out such crossings
        for (const SurfaceId& s : start_.surfaces) {
            if (s.primitive != primitive) continue;
            if (start_.fresh ? traits_of(p.solid).face_by_face && s.face == c.face
                             : s.face == c.face && s.entering == c.entering)
                return true;
        }
        // A ray cannot enter again, at the same place, a solid that it has just left: a convex
        // solid never, another one only farther on. Otherwise a ray would enter a slab that is
        // thinner than the error bound again and again.
        return c.entering && (p.convex || !(c.t - start_.t > c.error));
    }

    bool is_medium(const Primitive<Real>& p) const {
        return lists_media && p.medium && geometry_.has_media;
    }
    bool contains_here(std::uint32_t primitive) const {
        if constexpr (lists_media) return contains(bodies_, primitive);
        return false;
    }

    const Geometry<Real>& geometry_;
    const Start<Real>& start_;
    const Bodies& bodies_;
    std::uint32_t touched_ = none;  ///< the first primitive that the ray starts on
    bool touches_more_ = false;
};
}  // namespace lancer
