// Eight rays by one patch where it stands: shapes/bicubic.h for lanes, the same numbers.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Crossings of eight rays with a piece of a patch.
struct PieceHits {
    Numbers t, error, u, v;
    Mask entering;
};

class PatchQuery {
  public:
    PatchQuery(ExactMethods& exact, std::uint32_t item, const PatchRays& local,
               const Starts& starts)
        : exact_(exact),
          local_(local),
          rays_(local.rays),
          starts_(starts),
          own_(equal(starts.item, item)),
          along_(max_component(absolute(local.rays.dir))) {
        exact.patch(item, shape_);
    }

    /// The rays that start on the patch.
    Mask own() const { return own_; }

    /// Calls met(mask, hits, piece) for the crossings of rays of the mask from 0 to `last`, some
    /// before and beyond it among them. It returns rays that want to hear no more.
    ///
    /// \param foreseen  where the order is `any`: called, in place of `met`, with rays that cross a
    ///                  piece for certain, who hear no more; not with those that start on the patch
    template <Order order, class Met, class Foreseen>
    void crossings(Mask mask, const Numbers& last, const Met& met, const Foreseen& foreseen) {
        if (const Mask own = mask & own_ & local_.steep; own != 0 && shape_.home_count == 1) {
            const PatchHome& home = *shape_.homes;
            const auto& points = home.points;
            const Heights heights(local_, PieceStarts(home, rays_),
                                  [&](int i) { return all(points[i]); });
            mask &= ~(own & heights.bends_away());
            if (mask == 0) return;
        }
        traverse<order>(shape_.tree, nullptr, rays_, mask, last,
                        [&](std::uint32_t first, std::uint32_t count, Mask some) {
                            for (std::uint32_t i = first; i < first + count; ++i) {
                                some &= mask;
                                if (some == 0) return;
                                mask &= ~piece<order>(shape_.order[i], some, last, met, foreseen);
                            }
                        });
    }

  private:
    /// foresee(), then piece_crossings()
    template <Order order, class Met, class Foreseen>
    LANCER_INLINE Mask piece(std::uint32_t index, Mask mask, const Numbers& last, const Met& met,
                             const Foreseen& foreseen) {
        const PieceStarts start(shape_.homes[shape_.home[index]], rays_);
        const PieceViews view(shape_.frames[index], start.at, rays_.dir, along_, start.noise);
        Mask clear = mask & view.clear();
        Mask done = 0;
        if (clear != 0) {
            const Mask passes = view.passes_by() | (own_ & equal(starts_.face, index));
            mask &= ~(clear & passes);
            clear &= mask;
        }
        if (clear != 0) {
            const Numbers zero = all(0.0);
            const auto [from, to] = view.stretch();
            mask &= ~(clear & (less(last, from) | less(to, zero)));
            if constexpr (order == Order::any) {
                const Mask certain = clear & mask & ~own_ & less(zero, from) & less(to, last);
                if (certain != 0) done = view.meets(shape_.pieces[index], certain);
                if (done != 0) foreseen(done);
                mask &= ~done;
            }
        }
        if (const Mask own = mask & local_.steep & own_ & equal(starts_.face, index); own != 0) {
            const auto& c = shape_.pieces[index].c;
            const Heights heights(local_, start, [&](int i) {
                return Vectors{all(c[0][i]), all(c[1][i]), all(c[2][i])};
            });
            mask &= ~(own & heights.bends_away());
        }
        if (mask != 0) done |= search(index, mask, start, met);
        return done;
    }

    template <class Met>
    [[gnu::noinline]] Mask search(std::uint32_t index, Mask mask, const PieceStarts& start,
                                  const Met& met) {
        if (shears_.count == 0) shears_.set(rays_, 0, 255);
        Mask done = 0;
        for (int k = 0; k < shears_.count; ++k) {
            const Shears::Group& g = shears_.groups[k];
            const Mask some = mask & g.mask;
            if (some == 0) continue;
            const PatchPiece& piece = shape_.pieces[index];
            const auto alone = [&](int i, const PlanePart* part) {
                const PieceLine line{
                    {lane(start.at.x, i), lane(start.at.y, i), lane(start.at.z, i)},
                    lane(start.noise, i),
                    lane(shears_.sx, i),
                    lane(shears_.sy, i),
                    lane(shears_.sz, i),
                    g.x,
                    g.y,
                    g.z};
                Alone<Met> own{met, i, index, 0};
                exact_.piece_crossings(piece, line, part, {&own, nullptr, Alone<Met>::add});
                done |= own.done;
            };
            if (__builtin_popcount(some) < least_lanes) {
                for_each_lane(some, [&](int i) { alone(i, nullptr); });
                continue;
            }
            const double(&along)[16] = piece.c[g.z];
            const Numbers& height = component(start.at, g.z);
            PlaneNets net;
            const Numbers x0 = component(start.at, g.x) - shears_.sx * height;
            const Numbers y0 = component(start.at, g.y) - shears_.sy * height;
            for (int i = 0; i < 16; ++i) {
                net.c[i][0] = (all(piece.c[g.x][i]) - shears_.sx * all(along[i])) - x0;
                net.c[i][1] = (all(piece.c[g.y][i]) - shears_.sy * all(along[i])) - y0;
            }
            const auto found = [&](Mask at, const PlaneZeroPlaces& zero) {
                const CubicBases bu(zero.u);
                const CubicBases bv(zero.v);
                const BicubicValues z(along, bu, bv);
                const PlaneValues across(net, bu, bv);
                PieceHits hits;
                hits.t = (z.value - height) * shears_.sz;
                hits.error = absolute(shears_.sz) * (start.noise + absolute(z.du) * zero.slack_u +
                                                     absolute(z.dv) * zero.slack_v) +
                             bound<3>() * absolute(hits.t);
                hits.u = zero.u;
                hits.v = zero.v;
                hits.entering =
                    less(all(0.0), across.du[0] * across.dv[1] - across.dv[0] * across.du[1]);
                done |= met(at & ~done, hits, index);
            };
            const auto rest = [&](Mask left, const PlaneNets& c, const Squares& square) {
                for_each_lane(left & ~done, [&](int i) {
                    PlanePart part;
                    for (int p = 0; p < 16; ++p) {
                        part.net[p][0] = lane(c.c[p][0], i);
                        part.net[p][1] = lane(c.c[p][1], i);
                    }
                    part.u = lane(square.u, i);
                    part.v = lane(square.v, i);
                    part.du = lane(square.du, i);
                    part.dv = lane(square.dv, i);
                    alone(i, &part);
                });
            };
            const Numbers zero = all(0.0);
            const Numbers one = all(1.0);
            PlaneZeroSearch<decltype(found), decltype(rest)>(start.noise, found, rest)
                .search(net, some, {zero, zero, one, one});
        }
        return done;
    }

    /// No fewer rays are computed with side by side.
    static constexpr int least_lanes = 2;

    /// Crossings of one ray, from scalar code.
    template <class Met>
    struct Alone {
        const Met& met;
        int i;
        std::uint32_t index;
        Mask done;

        static void add(void* self, const LaneHit& hit) {
            Alone& to = *static_cast<Alone*>(self);
            const Mask bit = Mask(1) << to.i;
            if ((to.done & bit) != 0) return;
            to.done |= to.met(bit,
                              PieceHits{all(hit.t), all(hit.error), all(hit.u), all(hit.v),
                                        hit.entering ? bit : 0},
                              to.index);
        }
    };

    ExactMethods& exact_;
    const PatchRays& local_;
    const Rays& rays_;
    const Starts& starts_;
    const Mask own_;
    const Numbers along_;
    PatchShape shape_;
    Shears shears_;
};

[[gnu::noinline]] inline void patch_crossings(const Job& job, std::uint32_t item,
                                              const PatchRays& local, const Starts& starts,
                                              Mask active, NearestHits& hits) {
    PatchQuery query(*job.exact, item, local, starts);
    query.crossings<Order::nearest_first>(
        active, hits.limit,
        [&](Mask mask, const PieceHits& h, std::uint32_t piece) {
            // Where it starts a ray meets no patch of what it starts on (IntersectionFilter).
            const Mask own = mask & query.own();
            const Mask taken = hits.add(own & less(h.error, h.t), h.t, h.error, item, h.entering) |
                               hits.add_ahead(mask & ~own, h.t, h.error, item, h.entering);
            hits.set_triangle(taken, piece, h.u, h.v);
            return Mask(0);
        },
        [](Mask) {});
}

/// Whether the patch hides the light from eight rays.
struct PatchShadow {
    Mask blocks = 0;
    Mask unsure = 0;

    [[gnu::noinline]] PatchShadow(const Job& job, std::uint32_t item, const PatchRays& local,
                                  const Starts& starts, Mask active, const Numbers& distance) {
        PatchQuery query(*job.exact, item, local, starts);
        query.crossings<Order::any>(
            active, distance,
            [&](Mask mask, const PieceHits& h, std::uint32_t) {
                const Mask ahead = less(h.error, h.t);
                const Mask behind = less(h.t, -h.error);
                unsure |= mask & ~query.own() & ~ahead & ~behind;
                blocks |= mask & ahead & less(h.t, distance - h.error);
                return blocks;
            },
            [&](Mask mask) { blocks |= mask; });
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
