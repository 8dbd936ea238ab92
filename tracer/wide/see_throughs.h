// Eight shadow rays through transparent objects, by one search: shading/see_through.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The crossings of eight ways to a light with what lets light pass. A lane whose crossings are not
/// all clear of each other, of the start and of the light is unsure; so is one that SeeThrough
/// would be, as it goes by the same numbers.
class SeeThroughs {
  public:
    Mask unsure = 0;

    SeeThroughs() {
        for (int& n : count_) n = 0;
    }

    /// The lanes with at least one crossing.
    Mask some() const {
        Mask mask = 0;
        for (int i = 0; i < lanes; ++i) mask |= (count_[i] != 0 ? 1U : 0U) << i;
        return mask;
    }

    /// Adds crossings with one item, in the lanes of the mask: SeeThrough::add().
    ///
    /// \param entering  the lanes whose crossing is an entry
    LANCER_INLINE void add(Mask mask, const Numbers& t, const Numbers& error,
                           const Numbers& distance, std::uint32_t item, Mask entering) {
        const Numbers margin = all(apart) * error;
        mask &= ~less(t, -margin) & ~less(distance + margin, t);
        const Mask between = mask & less(margin, t) & less(t, distance - margin);
        unsure |= mask & ~between;
        for_each_lane(between, [&](int i) {
            if (count_[i] == most) {
                unsure |= Mask(1) << i;
                return;
            }
            crossings_[i][count_[i]++] = {lane(t, i), lane(error, i), item,
                                          (entering >> i & 1) != 0};
        });
    }

    /// Announces the lanes in which note_start() is called for the face that the ray starts on, if
    /// the line crosses it. light_by_contacts() computes all faces of a mesh alike, so these lanes
    /// may cross the mesh many times.
    void know_starts(Mask mask) { starts_known_ |= mask; }
    void note_start(Mask mask, const Numbers& t, const Numbers& error) {
        start_ends_ = select(mask, t + all(apart) * error, start_ends_);
    }

    /// The lanes that leave the body which they start on after they have passed another surface.
    /// There light_by_contacts() uses another formula.
    Mask leave_later(const std::uint32_t* start_items, Mask active) const {
        Mask mask = 0;
        for_each_lane(active & ~unsure & ~starts_known_, [&](int i) {
            double first = infinity;
            double own = -infinity;
            for (int k = 0; k < count_[i]; ++k) {
                const FilterCrossing& crossing = crossings_[i][k];
                if (crossing.t < first) first = crossing.t;
                if (crossing.item == start_items[i] && crossing.t > own) own = crossing.t;
            }
            if (first < own) mask |= Mask(1) << i;
        });
        return mask;
    }
    /// For these lanes, the crossings with a convex body by that formula.
    void put_again(Mask mask, const Numbers& in, const Numbers& in_error, const Numbers& out,
                   const Numbers& out_error) {
        starts_known_ |= mask;
        again_known_ |= mask;
        note_start(mask, in, in_error);
        again_ = select(mask, out, again_);
        again_error_ = select(mask, out_error, again_error_);
    }

    /// The share of light that passes in lane `i`, which is not unsure: SeeThrough::tells_all() and
    /// SeeThrough::transmittance().
    ///
    /// \param start     where the ray begins, and the bodies that contain its start
    /// \param distance  to the light
    /// \return false if the crossings are not enough to decide
    bool transmittance(const Scene& scene, int i, const LaneStart& start, double distance,
                       double* light) {
        sort(i);
        FilterCrossing* crossings = crossings_[i];
        if (!are_apart(i)) return false;
        if (const int own = own_later(i, start.item); own != 0) {
            if ((starts_known_ >> i & 1) == 0 ||
                !(crossings[0].t - apart * crossings[0].error > lane(start_ends_, i)))
                return false;
            if ((again_known_ >> i & 1) != 0) {
                crossings[own].t = lane(again_, i);
                crossings[own].error = lane(again_error_, i);
                if (!are_apart(i) || !(crossings[own].t < distance - apart * crossings[own].error))
                    return false;
            }
        }
        std::uint32_t bodies[most_bodies + most];
        int depth = 0;
        for (int k = 0; k < most_bodies && start.bodies[k] != nothing; ++k) {
            // A body that casts no shadow does not absorb light either.
            if (!scene.items[start.bodies[k]].casts_shadow) continue;
            bodies[depth++] = start.bodies[k];
            // The light is inside, or rounding hides the way out, unless see_again() found it.
            if (start.bodies[k] == start.item &&
                (count_[i] == 0 ||
                 (crossings[0].item != start.item && (again_known_ >> i & 1) == 0)))
                return false;
        }
        for (int c = 0; c < 3; ++c) light[c] = 1;
        double from = 0;
        const auto absorb_until = [&](double t) {
            if (depth == 0) return;
            const Finish& medium = scene.finishes[scene.items[bodies[depth - 1]].material];
            if (!medium.absorbs) return;
            double left[3];
            beer_lambert_transmittance(medium.absorption, t - from, left);
            for (int c = 0; c < 3; ++c) light[c] = light[c] * left[c];
        };
        for (int k = 0; k < count_[i]; ++k) {
            const FilterCrossing& crossing = crossings[k];
            int at = 0;
            while (at < depth && bodies[at] != crossing.item) ++at;
            if ((at < depth) == crossing.entering) continue;
            absorb_until(crossing.t);
            from = crossing.t;
            if (crossing.entering) {
                bodies[depth++] = crossing.item;
            } else {
                --depth;
                for (; at < depth; ++at) bodies[at] = bodies[at + 1];
            }
            const Finish& finish = scene.finishes[scene.items[crossing.item].material];
            for (int c = 0; c < 3; ++c) light[c] = light[c] * finish.transmittance[c];
            if (light[0] > 0 || light[1] > 0 || light[2] > 0) continue;
            for (int c = 0; c < 3; ++c) light[c] = 0;
            return true;
        }
        absorb_until(distance);
        return true;
    }

  private:
    struct FilterCrossing {
        double t, error;
        std::uint32_t item;
        bool entering;
    };

    /// SeeThrough::apart
    static constexpr double apart = 8;
    static constexpr int most = 32;

    bool are_apart(int i) const {
        const FilterCrossing* crossings = crossings_[i];
        for (int k = 1; k < count_[i]; ++k) {
            const FilterCrossing& before = crossings[k - 1];
            if (!(crossings[k].t - before.t > apart * (before.error + crossings[k].error)))
                return false;
        }
        return true;
    }

    /// The place of a crossing with the item that is not the first crossing; 0: there is none.
    int own_later(int i, std::uint32_t item) const {
        int k = count_[i] - 1;
        while (k > 0 && crossings_[i][k].item != item) --k;
        return k > 0 ? k : 0;
    }

    void sort(int i) {
        FilterCrossing* crossings = crossings_[i];
        for (int k = 1; k < count_[i]; ++k) {
            const FilterCrossing crossing = crossings[k];
            int at = k;
            for (; at > 0 && crossings[at - 1].t > crossing.t; --at)
                crossings[at] = crossings[at - 1];
            crossings[at] = crossing;
        }
    }

    Mask starts_known_ = 0;
    Mask again_known_ = 0;
    Numbers again_ = all(0.0);
    Numbers again_error_ = all(0.0);
    Numbers start_ends_ = all(-infinity);  ///< up to where the face at the start may be crossed
    FilterCrossing crossings_[lanes][most];
    int count_[lanes];
};

}  // namespace lancer::wide::LANCER_LEVEL
