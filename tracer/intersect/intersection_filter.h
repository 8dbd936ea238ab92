// Which crossings count for a ray, by where it starts (Start) and the bodies that it is in
// (MediaList, or NoMedia where no world's ray is in any).
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <optional>

#include "tracer/rays/crossing.h"
#include "tracer/scene/world.h"

namespace lancer {

using SurfaceList = boost::container::small_vector<SurfaceId, 4>;
/// The bodies (primitives) that a ray is inside of, in the order entered. No fixed limit.
using MediaList = boost::container::small_vector<std::uint32_t, 8>;

/// Stands in its place in a world that no light passes through, where nobody asks what a ray is in:
/// code for such worlds is compiled without all that lists would cost (docs/performance.md).
struct NoMedia {};

inline bool contains(const MediaList& media, std::uint32_t primitive) {
    return std::find(media.begin(), media.end(), primitive) != media.end();
}

/// Where a ray goes on from.
template <class Real>
struct Start {
    Real t = 0;                 ///< hits before this parameter are behind
    SurfaceList surfaces{};     ///< of the contact it comes from
    std::uint32_t left = none;  ///< a convex solid that it leaves for good: left_for_good()
    /// The origin lies on `surfaces`; else the ray passed straight through them at t.
    bool fresh = true;
};

/// Which crossings count, for a ray with this start and these bodies around it.
///
/// A body that matters as a medium follows the state rule: one that the ray is in can only be left,
/// one that it is not in only entered, at zero distance too. So coincident and glued faces need no
/// tolerance. Everything else must lie ahead by more than its error bound, except that a ray enters
/// an opaque body at distance zero when it stays in it for longer than rounding could explain.
/// \tparam Bodies  MediaList, or NoMedia
template <class Real, class Bodies>
class IntersectionFilter {
  public:
    IntersectionFilter(const World<Real>& world, const Start<Real>& start, const Bodies& bodies)
        : world_(world), start_(start), bodies_(bodies) {
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
            if (is_medium(world_.primitives[primitive])) {
                k.inside = contains(bodies_, primitive);
                k.one_way = true;
            }
        }
        return k;
    }

    /// Whether the crossing counts.
    bool operator()(std::uint32_t primitive, const Crossing<Real>& c) const {
        const Primitive<Real>& p = world_.primitives[primitive];
        const Real ahead = c.t - start_.t;
        if (ahead < -c.error) return false;
        const bool touched = starts_on(primitive);
        if (touched && repeats(p, primitive, c)) return false;
        if (is_medium(p)) return contains_here(primitive) != c.entering;
        if (ahead > c.error) return true;
        if (touched && p.composite() == nullptr) return false;
        return p.body && c.entering && c.chord > 4 * c.error;  // enters a wall
    }

    const Start<Real>& start() const { return start_; }
    /// Whether the ray is in the body, where its list tells.
    std::optional<bool> state_of(std::uint32_t primitive) const {
        if (!is_medium(world_.primitives[primitive])) return std::nullopt;
        return contains_here(primitive);
    }

    /// Whether a crossing in this sense counts when it lies ahead by more than its error and the
    /// ray does not start on the primitive.
    bool lets_pass(std::uint32_t primitive, bool entering) const {
        return !is_medium(world_.primitives[primitive]) || contains_here(primitive) != entering;
    }

    /// Where a crossing that counts is met: at the start when rounding put it before.
    Real met_at(const Crossing<Real>& c) const { return c.t < start_.t ? start_.t : c.t; }

    /// Whether the ray starts on the primitive, or passed straight through it just now.
    bool starts_on(std::uint32_t primitive) const {
        if (!may_touch(primitive)) return false;
        for (const SurfaceId& s : start_.surfaces) {
            if (s.primitive == primitive) return true;
        }
        return false;
    }

  private:
    static constexpr bool lists_media = !std::is_same_v<Bodies, NoMedia>;

    /// Nearly always decides at once what starts_on() asks.
    bool may_touch(std::uint32_t primitive) const { return primitive == touched_ || touches_more_; }

    /// Whether a crossing with what the ray starts on is one that it has behind it.
    [[gnu::noinline]] bool repeats(const Primitive<Real>& p, std::uint32_t primitive,
                                   const Crossing<Real>& c) const {
        if (p.composite() != nullptr) return false;  // it leaves out what is behind itself
        for (const SurfaceId& s : start_.surfaces) {
            if (s.primitive != primitive) continue;
            if (start_.fresh ? traits_of(p.solid).face_by_face && s.face == c.face
                             : s.face == c.face && s.entering == c.entering)
                return true;
        }
        // What the ray has just left it cannot enter again at the same place: a convex solid never,
        // another only farther on. Else a slab thinner than the bound would be entered for ever.
        return c.entering && (p.convex || !(c.t - start_.t > c.error));
    }

    bool is_medium(const Primitive<Real>& p) const {
        return lists_media && p.medium && world_.has_media;
    }
    bool contains_here(std::uint32_t primitive) const {
        if constexpr (lists_media) return contains(bodies_, primitive);
        return false;
    }

    const World<Real>& world_;
    const Start<Real>& start_;
    const Bodies& bodies_;
    std::uint32_t touched_ = none;  ///< the first primitive that the ray starts on
    bool touches_more_ = false;
};
}  // namespace lancer
