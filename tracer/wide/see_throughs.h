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

    /// The share of light that passes in lane `i`, which is not unsure: SeeThrough::tells_all() and
    /// SeeThrough::transmittance().
    ///
    /// \param start  where the ray begins, and the bodies that contain its start
    /// \return false if the crossings are not enough to decide
    bool transmittance(const Scene& scene, int i, const LaneStart& start, double* light) {
        sort(i);
        const FilterCrossing* crossings = crossings_[i];
        for (int k = 1; k < count_[i]; ++k) {
            const FilterCrossing& before = crossings[k - 1];
            if (crossings[k].item == start.item ||
                !(crossings[k].t - before.t > apart * (before.error + crossings[k].error)))
                return false;
        }
        std::uint32_t bodies[most_bodies + most];
        int depth = 0;
        while (depth < most_bodies && start.bodies[depth] != nothing) {
            bodies[depth] = start.bodies[depth];
            // The light is inside, or rounding hides the way out.
            if (bodies[depth] == start.item && (count_[i] == 0 || crossings[0].item != start.item))
                return false;
            ++depth;
        }
        for (int c = 0; c < 3; ++c) light[c] = 1;
        for (int k = 0; k < count_[i]; ++k) {
            const FilterCrossing& crossing = crossings[k];
            int at = 0;
            while (at < depth && bodies[at] != crossing.item) ++at;
            if ((at < depth) == crossing.entering) continue;
            if (crossing.entering)
                bodies[depth++] = crossing.item;
            else
                bodies[at] = bodies[--depth];
            const Finish& finish = scene.finishes[scene.items[crossing.item].material];
            for (int c = 0; c < 3; ++c) light[c] = light[c] * finish.transmittance[c];
            if (light[0] > 0 || light[1] > 0 || light[2] > 0) continue;
            for (int c = 0; c < 3; ++c) light[c] = 0;
            break;
        }
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

    FilterCrossing crossings_[lanes][most];
    int count_[lanes];
};

/// Adds the crossings with a transmissive ball.
///
/// \param own     of `active`, the rays that start on it
/// \param inside  rays that start inside
LANCER_INLINE void ball_see_throughs(const Ball& ball, std::uint32_t item, const Rays& r,
                                     Mask active, Mask own, Mask inside, const Numbers& distance,
                                     SeeThroughs& see) {
    if ((active & own) != 0) {
        const BallFromSurface other(ball, r);
        see.add(active & own, other.t, other.error, distance, item, less(other.t, all(0.0)));
    }
    const Mask others = active & ~own;
    BallGuess guess(ball, r, others);
    // As far as SeeThrough::reach().
    guess.cut(r, distance * all(1 + 0x1p-20));
    const Mask asked = guess.may_meet | (others & inside);
    if (asked == 0) return;
    const BallRoots roots(ball, r, asked);
    see.unsure |= others & inside & ~roots.met;
    if (roots.met == 0) return;
    Numbers in_error, out_error;
    roots.bound_errors(ball, r, in_error, out_error);
    see.add(roots.met, roots.in, in_error, distance, item, 255);
    see.add(roots.met, roots.out, out_error, distance, item, 0);
}

/// The crossings with a box of glass of rays that do not start on it.
LANCER_INLINE void box_see_throughs(const Box& box, std::uint32_t item, const Rays& r, Mask active,
                                    Mask inside, const Numbers& distance, SeeThroughs& see) {
    const BoxSpans span(box, r, active);
    see.unsure |= active & inside & ~span.met;
    if (span.met == 0) return;
    const auto offer = [&](const Numbers& t, const Numbers& error, Mask entering) {
        see.add(span.met & less(absolute(t), all(infinity)), t, error, distance, item, entering);
    };
    offer(span.in, span.in_error, 255);
    offer(span.out, span.out_error, 0);
}

}  // namespace lancer::wide::LANCER_LEVEL
