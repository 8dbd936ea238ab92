// What a ray meets next: the nearest contact, or the way to a light.
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>

#include "tracer/world.h"

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

template <class Real>
struct Hit {
    Real t;
    Real error;
    SurfaceId surface;
    Real u = 0;  ///< weights of the second and third corner, triangles only
    Real v = 0;
};

template <class Real>
using Contact = boost::container::small_vector<Hit<Real>, 4>;

/// Which crossings count, for a ray with this start and these bodies around it.
///
/// A body that matters as a medium follows the state rule: one that the ray is in can only be left,
/// one that it is not in only entered, at zero distance too. So coincident and glued faces need no
/// tolerance. Everything else must lie ahead by more than its error bound, except that a ray enters
/// an opaque body at distance zero when it stays in it for longer than rounding could explain.
/// \tparam Bodies  MediaList, or NoMedia
template <class Real, class Bodies>
class Acceptance {
  public:
    Acceptance(const World<Real>& world, const Start<Real>& start, const Bodies& bodies)
        : world_(world), start_(start), bodies_(bodies) {
        if (start.surfaces.empty()) return;
        touched_ = start.surfaces.front().primitive;
        touches_more_ = start.surfaces.size() > 1;
    }

    Known known(std::uint32_t primitive) const {
        Known k;
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
        return p.body && c.entering && !touched && c.chord > 4 * c.error;  // enters a wall
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
        for (const SurfaceId& s : start_.surfaces) {
            if (s.primitive != primitive) continue;
            if (start_.fresh ? is_face_by_face(p) && s.face == c.face
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

    /// Shapes that do not divide their start out themselves, because a line meets each face once.
    static bool is_face_by_face(const Primitive<Real>& p) {
        return std::holds_alternative<MeshInstance<Real>>(p.solid) ||
               std::holds_alternative<PatchSolid<Real>>(p.solid) ||
               std::holds_alternative<TriangleSheet<Real>>(p.solid);
    }

    const World<Real>& world_;
    const Start<Real>& start_;
    const Bodies& bodies_;
    std::uint32_t touched_ = none;  ///< the first primitive that the ray starts on
    bool touches_more_ = false;
};

/// Reports the crossings of the ray with a solid in the solid's own space.
template <class Real, class Last, class Report>
void solid_crossings(const Solid<Real>& solid, const Ray<Real>& ray, Known known,
                     const Stretch<Real, Last>& stretch, Report& report) {
    std::visit(
        [&](const auto& shape) {
            using S = std::decay_t<decltype(shape)>;
            if constexpr (std::is_same_v<S, MeshInstance<Real>> ||
                          std::is_same_v<S, PatchSolid<Real>> ||
                          std::is_same_v<S, BicubicSolid<Real>> ||
                          std::is_same_v<S, FacetSolid<Real>>) {
                crossings(shape, ray, known, stretch, report);
            } else if constexpr (std::is_same_v<S, TriangleSheet<Real>>) {
                TriangleHit<Real> hit;
                Shear<Real> shear = shear_of(ray);
                shear.noise = edge_noise(ray, shape.reach());
                if (intersect(shape, ray, shear, stretch, hit))
                    report(Crossing<Real>{hit.t, hit.error, 0, hit.entering}, hit.u, hit.v);
            } else {
                crossings(shape, ray, known, stretch,
                          [&](const Crossing<Real>& c) { report(c, Real(0), Real(0)); });
            }
        },
        solid);
}

/// Reports the crossings of the world ray with one primitive: report(Crossing, u, v), which returns
/// true to stop.
template <class Real, class Last, class Report>
void primitive_crossings(const World<Real>& world, const Primitive<Real>& primitive,
                         const Ray<Real>& world_ray, Known known,
                         const Stretch<Real, Last>& stretch, Report&& report) {
    if (primitive.frame == none)
        solid_crossings(primitive.solid, world_ray, known, stretch, report);
    else
        solid_crossings(primitive.solid, to_local(world_ray, world.frames[primitive.frame]), known,
                        stretch, report);
}

/// What is in no tree: primitives[bounded..].
template <class Real>
const HalfSpace<Real>& plane_of(const World<Real>& world, std::uint32_t primitive) {
    return *std::get_if<HalfSpace<Real>>(&world.primitives[primitive].solid);
}

/// Visits every primitive of the tree that the ray may meet on the stretch: visit(index) returns
/// true to stop.
template <class Real, class Last, class Visit>
void candidates(const World<Real>& world, const Ray<Real>& ray, const Stretch<Real, Last>& stretch,
                Visit&& visit) {
    traverse(world.bvh, ray, stretch.first, stretch.last,
             [&](std::uint32_t first, std::uint32_t count) {
                 for (std::uint32_t i = first; i < first + count; ++i) {
                     if (visit(i)) return true;
                 }
                 return false;
             });
}

/// Collects the hits nearest to the start that are one contact: those whose distances differ by
/// less than their error bounds together. A hit's own bound counts up to seven times the nearest
/// one's, so that what belongs to the contact follows from the nearest hit and not from the order
/// of the search.
template <class Real>
class NearestContact {
  public:
    /// \param contact  empty; will have the nearest hit in front, for the caller to reorder
    explicit NearestContact(Contact<Real>& contact) : contact_(contact) {}

    Real limit() const { return limit_; }

    /// Something will be added later, beyond which nothing belongs to the contact.
    void expect(Real limit) {
        if (limit < limit_) limit_ = limit;
    }

    [[gnu::always_inline]] void add(const Hit<Real>& hit) {
        if (!(hit.t <= limit_)) return;
        if (!contact_.empty()) return add_to_others(hit);
        contact_.push_back(hit);
        limit_ = hit.t + 8 * hit.error;
    }

    /// Nothing will be added any more: drops what is not in the contact after all.
    void settle() {
        if (contact_.size() < 2) return;
        const Hit<Real> nearest = contact_.front();
        const auto apart = [&](const Hit<Real>& h) {
            const Real own = std::min(h.error, 7 * nearest.error);
            return !(h.t - nearest.t <= nearest.error + own);
        };
        contact_.erase(std::remove_if(contact_.begin() + 1, contact_.end(), apart), contact_.end());
    }

  private:
    [[gnu::noinline]] void add_to_others(const Hit<Real>& hit) {
        Hit<Real>& nearest = contact_.front();
        if (!before(hit, nearest)) {
            contact_.push_back(hit);
            return;
        }
        const Hit<Real> second = nearest;
        nearest = hit;
        limit_ = hit.t + 8 * hit.error;
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
    Contact<Real>& contact_;  ///< others than the first may be too far by now
    Real limit_ = std::numeric_limits<Real>::infinity();
};

/// Sorts a contact as it is crossed: entries before exits, each in the order of declaration.
template <class Real>
void order_contact(const World<Real>& world, Contact<Real>& contact) {
    if (contact.size() < 2) return;
    std::sort(contact.begin(), contact.end(), [&](const Hit<Real>& a, const Hit<Real>& b) {
        if (a.surface.entering != b.surface.entering) return a.surface.entering;
        const std::uint32_t object_a = world.primitives[a.surface.primitive].object;
        const std::uint32_t object_b = world.primitives[b.surface.primitive].object;
        if (object_a != object_b) return object_a < object_b;
        return a.surface.face < b.surface.face;
    });
}

/// Which objects a query sees: all, or those that cast shadows.
enum class Shadows { ignore, cast };

/// The planes that may be the nearest.
///
/// Plain numbers tell which come first before any crossing is formed: of a room's walls three lie
/// ahead, and most of what stands in it is met before them. A plane bounds how far the contact
/// reaches where its crossing is sure to count.
template <class Real>
class NearestPlanes {
  public:
    /// Beyond it nothing belongs to the contact.
    Real limit() const { return limit_; }

    /// Looks at all planes. Those beyond the eighth that must wait are formed at once.
    ///
    /// \param sees    whether the query sees a primitive
    /// \param report  report(primitive, crossing)
    template <class Bodies, class Last, class Sees, class Report>
    [[gnu::always_inline]] void find(const World<Real>& world, const Ray<Real>& ray,
                                     const Start<Real>& start,
                                     const Acceptance<Real, Bodies>& accept,
                                     const Stretch<Real, Last>& stretch, const Sees& sees,
                                     const Report& report) {
        const auto end = static_cast<std::uint32_t>(world.primitives.size());
        for (std::uint32_t i = world.bounded; i < end; ++i) {
            const PlaneGuess<Real> guess(plane_of(world, i), ray);
            if (guess.low > limit_ || guess.high < stretch.first || guess.slope == 0) continue;
            const bool touched = accept.starts_on(i);
            if (!sees(i) || (touched && start.fresh)) continue;  // a line meets a plane once
            if (guess.high < limit_ && guess.low > start.t && !touched &&
                accept.lets_pass(i, guess.slope < 0))
                limit_ = guess.high;
            if (count_ == waiting_.size()) form_now(world, ray, stretch, report);
            waiting_[count_++] = {i, guess.slope, guess.low};
        }
    }

    /// Whether there are any to form().
    bool wait() const { return count_ != 0; }

    /// Forms the crossings that are still needed after what was found meanwhile.
    template <class Last, class Report>
    [[gnu::always_inline]] void form(const World<Real>& world, const Ray<Real>& ray,
                                     const Stretch<Real, Last>& stretch, const Report& report) {
        for (std::size_t k = 0; k < count_; ++k) {
            const Waiting& w = waiting_[k];
            if (stretch.ends_before(w.low)) continue;
            const auto report_it = [&](const Crossing<Real>& c) { report(w.primitive, c); };
            crossing(plane_of(world, w.primitive), ray, w.slope, stretch, report_it);
        }
        count_ = 0;
    }

  private:
    template <class Last, class Report>
    [[gnu::noinline]] void form_now(const World<Real>& world, const Ray<Real>& ray,
                                    const Stretch<Real, Last>& stretch, const Report& report) {
        form(world, ray, stretch, report);
    }

    struct Waiting {
        std::uint32_t primitive;
        Real slope;
        Real low;
    };
    std::array<Waiting, 8> waiting_;
    std::size_t count_ = 0;
    Real limit_ = std::numeric_limits<Real>::infinity();
};

/// Everything that the ray meets first, the nearest hit in front. Empty: it leaves the scene.
template <class Real, class Bodies>
Contact<Real> nearest_contact(const World<Real>& world, const Ray<Real>& ray,
                              const Start<Real>& start, const Bodies& bodies,
                              Shadows shadows = Shadows::ignore) {
    using std::abs;
    const Acceptance<Real, Bodies> accept(world, start, bodies);
    Contact<Real> contact;
    NearestContact<Real> found(contact);
    NearestPlanes<Real> planes;
    const auto limit = [&] { return found.limit(); };
    // A body that the ray is in may be left a rounding before the start.
    const Real first = start.t - abs(start.t) * gamma<Real>(32);
    const Stretch<Real, decltype(limit)> stretch{first, limit};
    const auto sees = [&](std::uint32_t index) {
        return index != start.left &&
               (shadows == Shadows::ignore || world.primitives[index].casts_shadow);
    };
    const auto report_plane = [&](std::uint32_t index, const Crossing<Real>& c) {
        if (accept(index, c)) found.add({accept.met_at(c), c.error, {index, c.face, c.entering}});
    };
    planes.find(world, ray, start, accept, stretch, sees, report_plane);
    found.expect(planes.limit());
    candidates(world, ray, stretch, [&](std::uint32_t index) {
        if (!sees(index)) return false;
        primitive_crossings(
            world, world.primitives[index], ray, accept.known(index), stretch,
            [&](const Crossing<Real>& c, Real u, Real v) {
                if (accept(index, c))
                    found.add({accept.met_at(c), c.error, {index, c.face, c.entering}, u, v});
                return false;
            });
        return false;
    });
    if (planes.wait()) planes.form(world, ray, stretch, report_plane);
    found.settle();
    return contact;
}

}  // namespace lancer
