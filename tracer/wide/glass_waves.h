// In which order the waves of rays through glass are traced, and the light of their chains summed.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

[[gnu::noinline]] inline void trace_packet(Job& job, Wave& wave, int depth, int at) {
    GlassPacket(job, wave, depth, at).trace();
}

/// Traces all rays of one depth. New rays wait in the waves of the next depth. When one of these is
/// full, it is traced first.
///
/// \param deepest  the largest depth so far that had rays
inline void trace_depth(Job& job, int depth, int& deepest) {
    if (bent_wave(job, depth)->count + mirrored_wave(job, depth)->count == 0) return;
    if (depth > deepest) deepest = depth;
    const bool last = depth + 1 >= job.scene->max_depth;
    Wave* const waves[] = {bent_wave(job, depth), mirrored_wave(job, depth)};
    for (Wave* wave : waves) {
        pad(*wave);
        for (int at = 0; at < wave->count; at += lanes) {
            if (!last && (bent_wave(job, depth + 1)->count + lanes > Wave::most ||
                          mirrored_wave(job, depth + 1)->count + lanes > Wave::most))
                trace_depth(job, depth + 1, deepest);
            trace_packet(job, *wave, depth, at);
        }
        wave->count = wave->deepest = 0;
    }
}

/// TraceRays, in worlds with glassy items, from outside of all bodies.
inline void trace_through(Job& job, const Camera& camera, const double* x, const double* y,
                          int count) {
    Wave* wave = bent_wave(job, 0);
    send_from_camera(camera, x, y, count, *wave);
    job.counts.primary += static_cast<std::uint64_t>(count);
    Ledger& ledger = *job.ledger;
    ledger.chain_count = ledger.term_count = 0;
    const Numbers one = all(1.0);
    for (int at = 0; at < count; at += lanes) store(wave->through, at, {one, one, one});
    for (int i = 0; i < count; ++i) wave->chain[i] = begin_chain(ledger);
    wave->deepest = 0;
    int deepest = 0;
    for (int depth = 0; depth <= deepest + 1 && depth < job.scene->max_depth; ++depth)
        trace_depth(job, depth, deepest);
    sum_chains(ledger);
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < count; ++i) wave->color[c][i] = ledger.chains[i].light[c];
}

/// TraceRays
inline void trace_rays(Job& job, const Camera& camera, const double* x, const double* y,
                       int count) {
    (job.scene->has_glassy ? trace_through : trace_opaque)(job, camera, x, y, count);
}

}  // namespace lancer::wide::LANCER_LEVEL
