// Eight rays by one torus where it stands: which crossings count, and what hides a light.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The first root of each line, where it goes in, ahead or not.
struct TorusEntries {
    Mask found = 0;
    Mask unsure = 0;  ///< lines that scalar code must compute
    Numbers at;       ///< in the line's own parameter

    /// \param own   rays that start on the torus; each becomes unsure, or has no root ahead
    /// \param last  roots beyond this parameter may be missing
    LANCER_INLINE TorusEntries(const TorusLines& line, const TorusLines::Spans& spans, Mask active,
                               Mask own, const Numbers& last) {
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
        Mask second = left[0] & left[1];
        const Mask within = own & search.active & less(search.at, start);
        if (within != 0) {
            search.at = select(within, start, search.at);
            search.on_root = within;
            unsure |= within & ~line.climbs_clear(start);
            search.active &= ~unsure;
        }
        for (int i = 0; search.active != 0 || second != 0; ++i) {
            if (i == most_steps) {
                unsure |= search.active | second;
                break;
            }
            const Mask next = second & ~search.active;
            const Mask switched = next & ~search.found & ~unsure;
            second &= ~next;
            if (switched != 0) {
                search.at = select(switched, spans.from[1], search.at);
                search.to = select(switched, spans.to[1], search.to);
                search.active |= switched;
            }
            if (search.active != 0) line.step(search);
        }
        at = search.at;
        found = search.found & ~unsure;
        unsure |= found & own;
        found &= ~own;
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
    const TorusLines line(torus, rays_at(scene, torus, r));
    const TorusEntries entries(line, line.spans(), active, own, hits.limit);
    Mask unsure = entries.unsure;
    if (entries.found == 0) return unsure;
    const Numbers t = line.ray_parameter(entries.at);
    Mask met = entries.found & ~less(hits.limit, t);
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
        const TorusLines line(torus, rays_at(scene, torus, r));
        const TorusLines::Spans spans = line.spans();
        blocks = active & ~own & line.hold_middle(spans, distance);
        active &= ~blocks;
        if (active == 0) return;
        const TorusEntries entries(line, spans, active, own, distance);
        unsure = entries.unsure;
        if (entries.found == 0) return;
        const Numbers t = line.ray_parameter(entries.at);
        const Mask met = entries.found & ~less(distance, t);
        if (met == 0) return;
        const Numbers error = line.error(entries.at, met);
        const Mask hidden = met & less(error, t) & less(t, distance - error);
        blocks |= hidden;
        unsure |= met & ~hidden;
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
