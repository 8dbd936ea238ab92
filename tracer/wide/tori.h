// Eight rays by one torus where it stands: which crossings count, and what hides a light.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The first root of each line, where it goes in.
struct TorusEntries {
    Mask found = 0;
    Mask unsure = 0;  ///< lines that scalar code must compute
    Mask ahead = 0;   ///< lines on which roots before the start were left out
    Numbers at;       ///< in the line's own parameter

    /// \param own   rays that start on the torus
    /// \param free  rays that start elsewhere, for which it is enough to know of roots ahead: if
    ///              none is found, there is none. One that is found may not be the scalar search's.
    /// \param last  roots beyond this parameter may be missing
    LANCER_INLINE TorusEntries(const TorusLines& line, const TorusLines::Spans& spans, Mask active,
                               Mask own, Mask free, const Numbers& last) {
        const Numbers zero = all(0.0);
        const Numbers start = line.start();
        Mask left[2];
        for (int i = 0; i < 2; ++i) {
            const Numbers& from = spans.from[i];
            const Numbers& to = spans.to[i];
            const Numbers beyond = to + (to - from);
            left[i] = active & spans.some[i] & ~less(line.ray_parameter(beyond), zero) &
                      ~less(last, line.ray_parameter(from)) & ~(own & ~less(start, to));
        }
        at = start;
        if ((left[0] | left[1]) == 0) return;
        TorusLines::Search search;
        search.active = left[0] | left[1];
        search.at = select(left[0], spans.from[0], spans.from[1]);
        search.to = select(left[0], spans.to[0], spans.to[1]);
        search.margin = zero;
        Mask second = left[0] & left[1];
        const Mask within = own & search.active & less(search.at, start);
        if (within != 0) {
            search.at = select(within, start, search.at);
            search.on_root = within;
            unsure |= within & ~line.climbs_clear(start);
            search.active &= ~unsure;
        }
        const Mask skipped = free & search.active & less(search.at, start);
        if (skipped != 0) {
            search.at = select(skipped, start, search.at);
            search.margin = select(skipped, line.clear_margin(), zero);
        }
        ahead = within | skipped;
        for (int i = 0; search.active != 0 || second != 0; ++i) {
            if (i == most_steps) {
                unsure |= search.active | second;
                break;
            }
            const Mask next = second & ~search.active;
            const Mask switched = next & ~search.found & ~unsure;
            second &= ~next;
            if (switched != 0) {
                const Mask inside = free & less(spans.from[1], start);
                search.at = select(switched, select(inside, start, spans.from[1]), search.at);
                search.to = select(switched, spans.to[1], search.to);
                search.active |= switched;
            }
            if (search.active != 0) line.step(search);
        }
        at = search.at;
        found = search.found & ~unsure;
    }

  private:
    static constexpr int most_steps = 24;
};

/// The rays in the torus' own space.
LANCER_INLINE Rays rays_at(const Scene& scene, const Torus& torus, const Rays& r) {
    return torus.frame == nothing ? r : to_local(r, scene.frames[torus.frame]);
}

/// Adds the crossings of rays with an opaque torus.
///
/// \param own  rays that start on it
///
/// \return rays that the exact method must compute; nothing is added for them
[[gnu::noinline]] inline Mask torus_crossings(const Scene& scene, const Torus& torus,
                                              std::uint32_t item, const Rays& r, Mask active,
                                              Mask own, NearestHits& hits) {
    active &= may_meet(torus.disc, r);
    if (active == 0) return 0;
    const TorusLines line(torus, rays_at(scene, torus, r));
    const TorusLines::Spans spans = line.spans();
    const TorusEntries entries(line, spans, active, own, 0, hits.limit);
    Mask unsure = entries.unsure | (entries.found & own);
    const Mask found = entries.found & ~own;
    if (found == 0) return unsure;
    const Numbers t = line.ray_parameter(entries.at);
    Mask met = found & ~less(hits.limit, t);
    const Mask behind = met & less(t, all(0.0));
    if (behind != 0) {
        const TorusEntries rest(line, spans, behind, 0, behind, hits.limit);
        unsure |= rest.unsure | rest.found;
        met &= ~behind;
    }
    if (met == 0) return unsure;
    const Numbers error = line.error(entries.at, met);
    // The entry must be clearly ahead of the start, and the exit clearly outside of the contact.
    const Numbers out = line.ray_parameter(entries.at + line.least_chord(entries.at));
    const Mask clear = less(error, t) & less(t + all(16.0) * error, out);
    unsure |= met & ~clear;
    met &= clear;
    hits.add_ahead(met, t, error, item, 255);
    return unsure;
}

/// Whether an opaque torus hides the light from eight rays.
struct TorusShadow {
    Mask blocks = 0;
    Mask unsure = 0;

    [[gnu::noinline]] TorusShadow(const Scene& scene, const Torus& torus, const Rays& r,
                                  Mask active, Mask own, const Numbers& distance) {
        active &= may_meet(torus.disc, r);
        if (active == 0) return;
        const TorusLines line(torus, rays_at(scene, torus, r));
        const TorusLines::Spans spans = line.spans();
        blocks = active & ~own & line.hold_middle(spans, distance);
        active &= ~blocks;
        if (active == 0) return;
        const TorusEntries entries(line, spans, active, own, active & ~own, distance);
        unsure = entries.unsure;
        if (entries.found == 0) return;
        const Numbers t = line.ray_parameter(entries.at);
        Mask met = entries.found & ~less(distance, t);
        const Mask ahead = met & (own | entries.ahead);
        if (ahead != 0) {
            const Mask enter = ahead & line.certainly_enter(entries.at, distance);
            blocks |= enter;
            unsure |= ahead & ~enter;
            met &= ~ahead;
        }
        if (met == 0) return;
        const Numbers error = line.error(entries.at, met);
        const Mask hidden = met & less(error, t) & less(t, distance - error);
        blocks |= hidden;
        unsure |= met & ~hidden;
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
