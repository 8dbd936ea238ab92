// recursion/whitted.h for eight rays, in worlds with glass. Where a ray meets something that this
// code does not handle, or a result is unsure, the scalar recursion takes over; what it finds is
// appended to the ray's chain of terms. The waves that these rays wait in: glass_waves.h.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Where bent rays of a depth wait, and mirrored ones: apart, neighbours stay more alike.
LANCER_INLINE Wave* bent_wave(Job& job, int depth) {
    return job.wave(job.waves, 2 * depth);
}
LANCER_INLINE Wave* mirrored_wave(Job& job, int depth) {
    return job.wave(job.waves, 2 * depth + 1);
}

/// Traces at most eight rays of a wave, from `at` on.
class GlassPacket {
  public:
    GlassPacket(Job& job, Wave& wave, int depth, int at)
        : job_(job), scene_(*job.scene), ledger_(*job.ledger), wave_(wave), depth_(depth), at_(at) {
        const int rest = wave_.count - at_;
        active_ = rest >= lanes ? 255U : (1U << rest) - 1;
        rays_ = make_rays(load(wave_.origin, at_), load(wave_.origin_lo, at_), load(wave_.dir, at_),
                          load(wave_.error + at_));
        through_ = load(wave_.through, at_);
        load_starts(wave_, at_, starts_);
        take(wave_.bodies, rest, starts_.bodies);
        if (scene_.has_smooth_media) take(wave_.optical, rest, starts_.optical);
    }

    [[gnu::noinline]] void trace() {
        // Each ray begins at most one chain.
        if (ledger_.chain_count + lanes > ledger_.chain_room) return follow_exactly(active_);
        Mask exact = near_edges(scene_, rays_, starts_, active_);
        find_nearest(job_, rays_, starts_, active_ & ~exact, hits_);
        exact |= hits_.unsure;
        const Mask some_bodies = starts_.bodies.some();
        // A ray inside a body that hits nothing lost the exit.
        const Mask missed = active_ & ~hits_.some & ~exact;
        exact |= missed & some_bodies;
        const Mask leaves = missed & ~some_bodies;
        add_terms(leaves, through_ * behind(leaves));
        Mask met = active_ & hits_.some & ~exact;
        Mask glass = 0;
        for_each_item(hits_.item, met, [&](std::uint32_t index, Mask same) {
            const Item& item = scene_.items[index];
            if (item.clear) glass |= same;
            if (item.glassy ? !item.clear : !scene_.finishes[item.material].plain) exact |= same;
        });
        exact |= met & some_bodies & lost_bodies(scene_, rays_, starts_, hits_, active_);
        met &= ~exact;
        if (met != 0) exact |= media_.cross(scene_, starts_, hits_, met, glass);
        met &= ~exact;
        if (exact != 0) follow_exactly(exact);
        if (met == 0) return;
        if ((met & some_bodies) != 0)
            through_ = dimmed(scene_, starts_, hits_.t, met & some_bodies, through_);
        shade(met);
    }

  private:
    void take(const std::uint32_t (&from)[most_bodies][Wave::room], int rest, Bodies& to) const {
        to.depth = wave_.deepest;
        for (int k = 0; k < wave_.deepest; ++k)
            for (int i = 0; i < lanes; ++i)
                to.item[k][i] = i < rest ? from[k][at_ + i] : std::uint32_t(nothing);
    }

    static void send_bodies(Bodies& from, int rows, Mask sent,
                            std::uint32_t (&to)[most_bodies][Wave::room], int first) {
        for (int k = 0; k < rows; ++k) {
            if (k >= from.depth) put_some(from.item[k], 255, nothing);
            store_packed(to[k] + first, sent, from.item[k]);
        }
    }

    /// The colours of rays that hit nothing.
    Vectors behind(Mask mask) const {
        Vectors colors = all(scene_.background);
        if (!scene_.has_sky) return colors;
        for_each_lane(mask, [&](int i) {
            double color[3];
            job_.exact->behind(lane_ray(rays_, i).dir, color);
            set_lane(colors, i, color);
        });
        return colors;
    }

    void follow_exactly(Mask mask) {
        struct Sum {
            Ledger& ledger;
            std::uint32_t chain;
        };
        for_each_lane(mask, [&](int i) {
            Sum sum{ledger_, wave_.chain[at_ + i]};
            const LightSink sink{&sum, [](void* self, const double* light) {
                                     const Sum& to = *static_cast<Sum*>(self);
                                     add_term(to.ledger, to.chain, light, nothing);
                                 }};
            const double through[] = {lane(through_.x, i), lane(through_.y, i),
                                      lane(through_.z, i)};
            job_.exact->follow(lane_ray(rays_, i), starts_.lane(i), wave_.weight[at_ + i], depth_,
                               through, sink);
        });
    }

    void add_terms(Mask mask, const Vectors& light) {
        LANCER_LEVEL::add_terms(ledger_, wave_.chain + at_, mask, light, nullptr);
    }

    /// Whitted::shade() and Whitted::bend(), for the hits of the mask.
    void shade(Mask met) {
        make_surfaces(job_, rays_, hits_, met, surfaces_);
        const Surfaces& s = surfaces_;
        const Mask glass = media_.glass & met;
        const Vectors mirror = mirrored(rays_.dir, s.normal);
        const Around* around = starts_.bodies.depth != 0 || glass != 0 ? &media_.bodies : nullptr;
        add_terms(met, through_ * local_color(job_, rays_, hits_, s, mirror, met, around));

        const Numbers zero = all(0.0);
        const Numbers one = all(1.0);
        Vectors bent = mirror;
        Vectors passes{zero, zero, zero};
        Mask total = 0;
        if (glass != 0) {
            const Refracted refracted(rays_.dir, s.normal, media_.ratio);
            total = refracted.total & glass;
            bent = select(total, mirror, refracted.bent);
            for_each_lane(glass, [&](int i) {
                const Item& item = scene_.items[hits_.item[i]];
                set_lane(passes, i, scene_.finishes[item.material].transmittance);
            });
        }
        const Mask clear = glass & less(zero, max_component(passes));
        total &= clear;

        Vectors share = s.reflection;
        const Mask fresnel = met & less(zero, s.fresnel);
        if (fresnel != 0) {
            const Numbers index =
                select(glass, one / media_.ratio,
                       opaque_index(scene_, hits_, s, media_.index_before, fresnel));
            share = mirror_of(s, rays_.dir, index, fresnel);
        }
        mirror_on(share, mirror, met & ~total);
        if (clear == 0) return;
        const Vectors ones{one, one, one};
        const Vectors factor = select(fresnel, passes * (ones - share), passes);
        const Numbers weight =
            load(wave_.weight + at_) * max_component(select(total, passes, factor));
        const Mask sent = is_followed(weight, clear);
        if (sent == 0) return;
        const Vectors through = select(total, through_, through_ * factor);
        send(*bent_wave(job_, depth_ + 1), bent, weight, through, sent, total, nullptr);
    }

    /// Sends mirrored rays. The light of each is a term of its sender's chain.
    void mirror_on(const Vectors& share, const Vectors& mirror, Mask mask) {
        const Numbers factor = max_component(share);
        const Numbers weight = load(wave_.weight + at_) * factor;
        const Mask sent = is_followed(weight, mask & less(all(0.0), factor));
        if (sent == 0) return;
        const Vectors in_chain = through_ * share;
        std::uint32_t chains[lanes];
        for_each_lane(sent, [&](int i) { chains[i] = begin_chain(ledger_); });
        LANCER_LEVEL::add_terms(ledger_, wave_.chain + at_, sent, in_chain, chains);
        const Numbers one = all(1.0);
        send(*mirrored_wave(job_, depth_ + 1), mirror, weight, {one, one, one}, sent, sent, chains);
    }

    /// The rays that are within the limits.
    Mask is_followed(const Numbers& weight, Mask mask) const {
        if (depth_ + 1 >= scene_.max_depth) return 0;
        return mask & at_most(all(scene_.min_contribution), weight);
    }

    /// Puts rays that start at the surfaces into a wave, which has room for them.
    ///
    /// \param reflected  of `sent`, the mirrored rays
    /// \param chains     the rays' chains; null: each ray belongs to its sender's chain
    void send(Wave& next, const Vectors& direction, const Numbers& weight, const Vectors& through,
              Mask sent, Mask reflected, const std::uint32_t* chains) {
        job_.counts.reflected += static_cast<std::uint64_t>(__builtin_popcount(sent & reflected));
        job_.counts.transmitted +=
            static_cast<std::uint64_t>(__builtin_popcount(sent & ~reflected));
        const Surfaces& s = surfaces_;
        Starts starts;
        set_left(s, direction, starts);
        media_.bodies.put_towards(Around::back(s, rays_, direction), starts.bodies);
        if (scene_.has_smooth_media) media_.optical.put_towards(reflected, starts.optical);
        const int first = next.count;
        store_packed(next.origin, first, sent, s.position);
        store_packed(next.origin_lo, first, sent, s.position_lo);
        store_packed(next.dir, first, sent, direction);
        store_packed(next.through, first, sent, through);
        store_packed(next.error + first, sent, s.error);
        store_packed(next.weight + first, sent, weight);
        int rows = next.deepest;
        if (starts.bodies.depth > rows) rows = starts.bodies.depth;
        if (starts.optical.depth > rows) rows = starts.optical.depth;
        const bool smooth = scene_.has_smooth_media;
        for (int k = next.deepest; k < rows; ++k) {
            for (int to = 0; to < first; ++to) next.bodies[k][to] = nothing;
            for (int to = 0; smooth && to < first; ++to) next.optical[k][to] = nothing;
        }
        next.deepest = rows;
        send_hits(hits_, starts, sent, next, first);
        store_packed(next.chain + first, sent, chains == nullptr ? wave_.chain + at_ : chains);
        send_bodies(starts.bodies, rows, sent, next.bodies, first);
        if (smooth) send_bodies(starts.optical, rows, sent, next.optical, first);
        next.count = first + __builtin_popcount(sent);
    }

    Job& job_;
    const Scene& scene_;
    Ledger& ledger_;
    Wave& wave_;
    const int depth_;
    const int at_;
    Mask active_;
    Rays rays_;
    Vectors through_;
    Starts starts_;
    NearestHits hits_;
    Surfaces surfaces_;
    GlassMedia media_;
};

}  // namespace lancer::wide::LANCER_LEVEL
