// OpaqueTracer for lanes. The camera rays are the first wave, the rays that they send on are the
// second, and so on. Each wave is traced eight rays at a time. Then the light is summed from the
// last wave back to the first.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

LANCER_INLINE Vectors load(const double (*from)[Wave::room], int at) {
    return {load(from[0] + at), load(from[1] + at), load(from[2] + at)};
}
LANCER_INLINE void store(double (*to)[Wave::room], int at, const Vectors& v) {
    store(to[0] + at, v.x);
    store(to[1] + at, v.y);
    store(to[2] + at, v.z);
}
LANCER_INLINE void store_packed(double (*to)[Wave::room], int at, Mask mask, const Vectors& v) {
    store_packed(to[0] + at, mask, v.x);
    store_packed(to[1] + at, mask, v.y);
    store_packed(to[2] + at, mask, v.z);
}

/// The starts of eight rays from `at` on, but for the bodies around them.
LANCER_INLINE void load_starts(const Wave& wave, int at, Starts& starts) {
    __builtin_memcpy(starts.item, wave.item + at, sizeof starts.item);
    __builtin_memcpy(starts.left, wave.left + at, sizeof starts.left);
    __builtin_memcpy(starts.face, wave.face + at, sizeof starts.face);
    // Eight bytes that are 0 or 1: the product has byte i as bit 56 + i.
    std::uint64_t eight;
    __builtin_memcpy(&eight, wave.entering + at, sizeof eight);
    starts.entering = static_cast<Mask>(eight * 0x0102040810204080U >> 56);
}

/// Puts what new rays start on into a wave, from `at` on.
LANCER_INLINE void send_hits(const NearestHits& hits, const Starts& starts, Mask sent, Wave& wave,
                             int at) {
    store_packed(wave.item + at, sent, hits.item);
    store_packed(wave.face + at, sent, hits.face);
    store_packed(wave.left + at, sent, starts.left);
    for_each_lane(sent, [&](int i) { wave.entering[at++] = (hits.entering >> i & 1) != 0; });
}

/// Initialises the elements behind the last ray, which whole vectors read.
inline void pad(Wave& wave) {
    const Numbers zero = all(0.0);
    const Vectors zeros{zero, zero, zero};
    const int at = wave.count;
    store(wave.origin, at, zeros);
    store(wave.origin_lo, at, zeros);
    store(wave.dir, at, zeros);
    store(wave.through, at, zeros);
    store(wave.normal, at, zeros);
    store(wave.error + at, zero);
    store(wave.weight + at, zero);
    for (int i = at; i < at + lanes; ++i) {
        wave.item[i] = wave.left[i] = nothing;
        wave.face[i] = 0;
        wave.entering[i] = false;
    }
}

/// The first wave: camera_ray() of rays/camera.h for a camera near the scene, eight rays at a time.
inline void send_from_camera(const Camera& camera, const double* x, const double* y, int count,
                             Wave& wave) {
    const Numbers zero = all(0.0);
    const Vectors zeros{zero, zero, zero};
    const Vectors forward = all(camera.forward);
    const Vectors position = all(camera.position);
    for (int at = 0; at < count; at += lanes) {
        const Numbers sx = load(x + at) / all(camera.width) - all(0.5);
        const Numbers sy = all(0.5) - load(y + at) / all(camera.height);
        const Vectors aside = sx * all(camera.right) + sy * all(camera.up);
        const VectorPair origin =
            camera.orthographic ? two_sum(position, aside) : VectorPair{position, zeros};
        store(wave.origin, at, origin.hi);
        store(wave.origin_lo, at, origin.lo);
        store(wave.dir, at, camera.orthographic ? forward : normalize(forward + aside));
        store(wave.error + at, zero);
        store(wave.weight + at, all(1.0));
        for (int i = at; i < at + lanes; ++i) {
            wave.item[i] = wave.left[i] = nothing;
            wave.face[i] = 0;
            wave.entering[i] = false;
        }
    }
    wave.count = count;
}

/// Traces the rays of one depth from `at` on, eight at most.
class Packet {
  public:
    /// \param next  gets the rays that these send on; null at the last depth
    Packet(Job& job, Wave& wave, Wave* next, int depth, int at)
        : job_(job), scene_(*job.scene), wave_(wave), next_(next), depth_(depth), at_(at) {}

    void trace() {
        const int rest = wave_.count - at_;
        const Mask active = rest >= lanes ? 255U : (1U << rest) - 1;
        rays_ = make_rays(load(wave_.origin, at_), load(wave_.origin_lo, at_), load(wave_.dir, at_),
                          load(wave_.error + at_));
        Starts starts;
        load_starts(wave_, at_, starts);
        if (scene_.has_patches) {
            starts.normal = load(wave_.normal, at_);
            starts.planes = active & ~equal(starts.item, nothing);
        }
        find_nearest(job_, rays_, starts, active, hits_);
        for_each_lane(hits_.unsure, [&](int i) { trace_exactly(i, starts); });
        for_each_lane(active & ~hits_.some & ~hits_.unsure, [&](int i) { put_color_behind(i); });
        Mask met = active & hits_.some & ~hits_.unsure;
        for_each_item(hits_.item, met, [&](std::uint32_t item, Mask same) {
            if (scene_.finishes[scene_.items[item].material].plain) return;
            for_each_lane(same, [&](int i) { shade_exactly(i); });
            met &= ~same;
        });
        if (met != 0) shade(met);
    }

  private:
    void put_color(int i, const double* color) {
        for (int c = 0; c < 3; ++c) wave_.color[c][at_ + i] = color[c];
    }
    void put_color_behind(int i) {
        if (!scene_.has_sky) {
            put_color(i, scene_.background);
            return;
        }
        double color[3];
        job_.exact->behind(lane_ray(rays_, i).dir, color);
        put_color(i, color);
    }
    void trace_exactly(int i, const Starts& starts) {
        double color[3];
        job_.exact->trace(lane_ray(rays_, i), starts.lane(i), wave_.weight[at_ + i], depth_, color);
        put_color(i, color);
    }
    void shade_exactly(int i) {
        double color[3];
        job_.exact->shade(lane_ray(rays_, i), hits_.lane(i), wave_.weight[at_ + i], depth_, color);
        put_color(i, color);
    }

    void shade(Mask met) {
        Surfaces s;
        make_surfaces(job_, rays_, hits_, met, s);
        const Vectors mirror = mirrored(rays_.dir, s.normal);
        const Vectors color = local_color(job_, rays_, hits_, s, mirror, met);
        store_some(wave_.color[0] + at_, met, color.x);
        store_some(wave_.color[1] + at_, met, color.y);
        store_some(wave_.color[2] + at_, met, color.z);
        send_on(s, mirror, met);
    }

    /// Puts the mirrored rays into the next wave.
    void send_on(const Surfaces& s, const Vectors& mirror, Mask met) {
        if (next_ == nullptr) return;
        const Mask fresnel = met & less(all(0.0), s.fresnel);
        const Numbers one = all(1.0);
        const Vectors share =
            fresnel == 0
                ? s.reflection
                : mirror_of(s, rays_.dir, opaque_index(scene_, hits_, s, one, fresnel), fresnel);
        const Numbers factor = max_component(share);
        const Numbers weight = load(wave_.weight + at_) * factor;
        const Mask sent =
            met & less(all(0.0), factor) & at_most(all(scene_.min_contribution), weight);
        if (sent == 0) return;
        job_.counts.reflected += static_cast<std::uint64_t>(__builtin_popcount(sent));
        Starts starts;
        set_left(s, mirror, starts);
        Wave& next = *next_;
        const int to = next.count;
        store_packed(next.origin, to, sent, s.position);
        store_packed(next.origin_lo, to, sent, s.position_lo);
        store_packed(next.dir, to, sent, mirror);
        store_packed(next.mirror, to, sent, share);
        store_packed(next.error + to, sent, s.error);
        store_packed(next.weight + to, sent, weight);
        if (scene_.has_patches) store_packed(next.normal, to, sent, s.geometric);
        send_hits(hits_, starts, sent, next, to);
        for_each_lane(
            sent, [&](int i) { next.sender[next.count++] = static_cast<std::uint32_t>(at_ + i); });
    }

    Job& job_;
    const Scene& scene_;
    Wave& wave_;
    Wave* const next_;
    const int depth_;
    const int at_;
    Rays rays_;
    NearestHits hits_;
};

/// TraceRays, in worlds without glassy items.
inline void trace_opaque(Job& job, const Camera& camera, const double* x, const double* y,
                         int count) {
    Wave* wave = job.wave(job.waves, 0);
    send_from_camera(camera, x, y, count, *wave);
    job.counts.primary += static_cast<std::uint64_t>(count);
    const int deepest = job.scene->max_depth;
    int depth = 0;
    for (;; ++depth) {
        Wave* next = depth + 1 < deepest ? job.wave(job.waves, depth + 1) : nullptr;
        if (next != nullptr) next->count = 0;
        pad(*wave);
        for (int at = 0; at < wave->count; at += lanes) Packet(job, *wave, next, depth, at).trace();
        if (next == nullptr || next->count == 0) break;
        wave = next;
    }
    for (; depth > 0; --depth) {
        const Wave& from = *job.wave(job.waves, depth);
        Wave& to = *job.wave(job.waves, depth - 1);
        for (int c = 0; c < 3; ++c)
            for (int i = 0; i < from.count; ++i)
                to.color[c][from.sender[i]] += from.mirror[c][i] * from.color[c][i];
    }
}

}  // namespace lancer::wide::LANCER_LEVEL
