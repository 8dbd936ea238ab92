// The nearest hits of eight rays. A lane is unsure if more than one hit may belong to its contact.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The nearest hits so far, by the rules of IntersectionFilter and of NearestContact.
///
/// A contact holds one hit for certain when no other lies before nearest.t + 8 nearest.error,
/// within which NearestContact keeps what it looks at once more. A lane where another does is
/// unsure; whether or not a still nearer hit comes later. A hit that was dropped because it lay
/// beyond the limit of a nearest one would not belong to a later contact, either: NearestContact
/// keeps the least limit of all.
class NearestHits {
  public:
    Numbers t = all(infinity);
    Numbers error = all(0.0);
    Numbers u = all(0.0);
    Numbers v = all(0.0);
    Numbers limit = all(infinity);  ///< nothing beyond it belongs to the contact
    alignas(32) std::uint32_t item[lanes]{};
    alignas(32) std::uint32_t face[lanes]{};
    Mask entering = 0;
    Mask some = 0;    ///< lanes with a hit
    Mask unsure = 0;  ///< lanes that are left to scalar code

    LaneHit lane(int i) const {
        return {LANCER_LEVEL::lane(t, i),
                LANCER_LEVEL::lane(error, i),
                LANCER_LEVEL::lane(u, i),
                LANCER_LEVEL::lane(v, i),
                item[i],
                face[i],
                (entering >> i & 1) != 0};
    }

    /// Adds crossings, in the lanes of the mask, of rays that do not start on the item. Lanes with
    /// a crossing that rounding cannot tell from the start become unsure.
    LANCER_INLINE Mask add_ahead(Mask mask, const Numbers& at, const Numbers& bound,
                                 std::uint32_t of, Mask is_entering) {
        const Mask behind = less(at, -bound);
        const Mask ahead = less(bound, at);
        unsure |= mask & ~behind & ~ahead;
        return add(mask & ahead, at, bound, of, is_entering);
    }

    /// Adds crossings that count.
    ///
    /// \return the lanes where the new crossing is the nearest hit
    LANCER_INLINE Mask add(Mask mask, const Numbers& at, const Numbers& bound, std::uint32_t of,
                           Mask is_entering) {
        mask &= at_most(at, limit);
        if (mask == 0) return 0;
        const Mask nearer = mask & some & less(at, t);
        const Numbers reach = at + all(8.0) * bound;
        unsure |= mask & some & ~nearer;
        unsure |= nearer & at_most(t, reach);
        const Mask taken = (mask & ~some) | nearer;
        t = select(taken, at, t);
        error = select(taken, bound, error);
        limit = select(taken, reach, limit);
        entering = (entering & ~taken) | (is_entering & taken);
        some |= taken;
        put_some(item, taken, of);
        put_some(face, taken, 0);
        return taken;
    }

    /// Sets the face and the barycentric coordinates of triangle crossings that add() has just
    /// taken.
    LANCER_INLINE void set_triangle(Mask taken, std::uint32_t of, const Numbers& at_u,
                                    const Numbers& at_v) {
        if (taken == 0) return;
        put_some(face, taken, of);
        u = select(taken, at_u, u);
        v = select(taken, at_v, v);
    }

    /// Adds one hit to one lane.
    void add(int i, const LaneHit& hit) {
        const Mask bit = Mask(1) << i;
        if (add(bit, all(hit.t), all(hit.error), hit.item, hit.entering ? bit : 0) == 0) return;
        face[i] = hit.face;
        set_lane(u, i, hit.u);
        set_lane(v, i, hit.v);
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
