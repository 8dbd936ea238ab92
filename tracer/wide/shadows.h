// The share of a light that reaches eight points: light_through() for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// A ray is blocked as soon as one item certainly blocks it. If none does, but some item may, the
/// exact methods compute the whole shadow ray. Crossings with transmissive items are collected
/// meanwhile.
class ShadowQuery {
  public:
    /// \param last  in: an item that recently blocked this light, or `nothing`; out: the last item
    ///              that blocked it
    ShadowQuery(const Job& job, const Rays& r, const Starts& starts, const Numbers& distance,
                std::uint32_t& last)
        : job_(job),
          scene_(*job.scene),
          rays_(r),
          starts_(starts),
          distance_(distance),
          last_(last) {}

    /// \param share  receives the share of the light per channel, for the rays of `active`
    ///
    /// \return the rays that receive light
    Mask lit(Mask active, Vectors& share) {
        ask_planes(active);
        Mask open = active & ~blocked_;
        // Neighbours are often in the same shadow, so the last blocker is tested before the tree.
        if (last_ != nothing && open != 0) {
            ask(last_, open);
            open &= ~(blocked_ | unsure_);
        }
        if (open != 0) {
            traverse<Order::any>(scene_.tree, scene_.meshes_of_items, rays_, open, distance_,
                                 [&](std::uint32_t first, std::uint32_t count, Mask met) {
                                     for (std::uint32_t i = first; i < first + count; ++i) {
                                         const Mask before = blocked_;
                                         ask(i, met & open);
                                         open &= ~(blocked_ | unsure_);
                                         if (__builtin_popcount(blocked_ ^ before) > 2 &&
                                             scene_.items[i].kind != Kind::mesh)
                                             last_ = i;
                                     }
                                 });
        }
        const Numbers one = all(1.0);
        share = {one, one, one};
        look_again(active & ~blocked_ & ~unsure_);
        const Mask dimmed = see_throughs_.some() | in_absorbing_bodies();
        for_each_lane(active & (unsure_ | dimmed) & ~blocked_, [&](int i) {
            double of_lane[3];
            put_share(i, of_lane);
            set_lane(share, i, of_lane);
            if (of_lane[0] == 0 && of_lane[1] == 0 && of_lane[2] == 0) blocked_ |= Mask(1) << i;
        });
        return active & ~blocked_;
    }

  private:
    void look_again(Mask active) {
        if (see_throughs_.some() == 0 || starts_.bodies.depth == 0) return;
        Mask later = see_throughs_.leave_later(starts_.item, active);
        while (later != 0) {
            const std::uint32_t item = starts_.item[__builtin_ctz(later)];
            const Mask same = later & equal(starts_.item, item);
            const Mask inside = same & starts_.bodies.inside(item);
            if (inside != 0) see_again(scene_, item, rays_, inside, distance_, see_throughs_);
            later &= ~same;
        }
    }

    void put_share(int i, double* share) {
        const LaneStart start = starts_.lane(i);
        const double distance = lane(distance_, i);
        if ((unsure_ >> i & 1) == 0 &&
            see_throughs_.transmittance(scene_, i, start, distance, share))
            return;
        job_.exact->light_share(lane_ray(rays_, i), start, distance, share);
    }

    /// The rays that start in a body which absorbs, or in another one inside of such a body.
    Mask in_absorbing_bodies() const {
        if (!scene_.has_absorption) return 0;
        Mask mask = 0;
        const Bodies& bodies = starts_.bodies;
        for (int k = 0; k < bodies.depth; ++k) {
            for_each_lane(255 & ~equal(bodies.item[k], nothing), [&](int i) {
                const Item& body = scene_.items[bodies.item[k][i]];
                if (scene_.finishes[body.material].absorbs) mask |= Mask(1) << i;
            });
        }
        return mask;
    }

    /// Tests all planes. Unsure rays are tested as well, because another plane may block them.
    void ask_planes(Mask active) {
        for (std::uint32_t i = scene_.bounded; i < scene_.item_count; ++i) {
            if (!scene_.items[i].casts_shadow) continue;
            const Mask mask =
                active & ~blocked_ & ~equal(starts_.item, i) & ~equal(starts_.left, i);
            if (mask == 0) continue;
            note(PlaneShadow(scene_.planes[i - scene_.bounded], rays_, mask, distance_),
                 scene_.items[i].glassy);
        }
    }

    void ask(std::uint32_t index, Mask mask) {
        mask &= ~equal(starts_.left, index);
        if (mask == 0) return;
        if (const Mesh* mesh = mesh_of(scene_, index)) {
            if (mesh->casts_shadow) ask_mesh(*mesh, index, mask);
            return;
        }
        const Item& item = scene_.items[index];
        if (!item.casts_shadow) return;
        const Mask own = mask & equal(starts_.item, index);
        if (item.clear && item.kind == Kind::ball) {
            ball_see_throughs(item.ball, index, rays_, mask, own, starts_.bodies.inside(index),
                              distance_, see_throughs_);
            unsure_ |= see_throughs_.unsure;
            return;
        }
        const Mask others = mask & ~own;
        if (item.clear && item.kind == Kind::box) {
            const Mask inside = starts_.bodies.inside(index);
            box_see_throughs(item.box, index, rays_, others | (own & inside), inside, distance_,
                             see_throughs_);
            unsure_ |= (own & ~inside) | see_throughs_.unsure;
            return;
        }
        if (item.kind == Kind::ball) {
            note(BallShadow(item.ball, rays_, others, distance_), item.glassy);
        } else if (item.kind == Kind::box) {
            note(BoxShadow(item.box, rays_, others, distance_), item.glassy);
        } else if (item.kind == Kind::frustum) {
            const Frustum& frustum = scene_.frustums[item.shape.index];
            if (item.clear) {
                frustum_see_throughs(frustum, index, rays_, starts_, mask, distance_,
                                     see_throughs_);
                unsure_ |= see_throughs_.unsure;
                return;
            }
            if (item.glassy) {  // the exact methods compute rays that may meet it
                unsure_ |= own | FrustumGuess(frustum, rays_, others, distance_).unsettled;
                return;
            }
            const FrustumShadow shadow(item.shape.around, frustum, rays_, others, distance_);
            blocked_ |= shadow.blocks;
            ask_exactly(index, own | shadow.unsure);
            return;
        } else if (item.kind == Kind::torus && !item.glassy) {
            const TorusShadow shadow(scene_, scene_.tori[item.shape.index], rays_, mask, own,
                                     distance_);
            blocked_ |= shadow.blocks;
            ask_exactly(index, shadow.unsure);
            return;
        } else if (item.kind == Kind::patch && !item.glassy) {
            const PatchRays& local =
                patches_.rays_in(scene_, scene_.patches[item.shape.index], rays_, starts_);
            const PatchShadow shadow(job_, index, local, starts_, mask, distance_);
            blocked_ |= shadow.blocks;
            ask_exactly(index, shadow.unsure & ~shadow.blocks);
            return;
        } else {
            if (item.glassy)
                unsure_ |= mask;
            else
                ask_exactly(index, mask);
            return;
        }
        unsure_ |= own;
    }

    void ask_mesh(const Mesh& mesh, std::uint32_t index, Mask mask) {
        if (mesh.clear) {
            mesh_see_throughs(scene_, mesh, index, rays_, starts_, mask, distance_, see_throughs_);
            unsure_ |= see_throughs_.unsure;
        } else if (is_better_alone(scene_, mesh, mask)) {
            for_each_lane(mask, [&](int i) {
                note(lone_mesh_shadow(mesh, index, rays_, starts_, i, lane(distance_, i)),
                     mesh.glassy);
            });
        } else {
            note(MeshShadow(scene_, mesh, index, rays_, starts_, mask, distance_), mesh.glassy);
        }
    }

    /// Notes the result of a test. A glassy item blocks no ray for certain.
    template <class Shadow>
    LANCER_INLINE void note(const Shadow& shadow, bool glassy) {
        (glassy ? unsure_ : blocked_) |= shadow.blocks;
        unsure_ |= shadow.unsure;
    }

    void ask_exactly(std::uint32_t index, Mask mask) {
        for_each_lane(mask, [&](int i) {
            if (job_.exact->blocks(index, lane_ray(rays_, i), starts_.lane(i), lane(distance_, i)))
                blocked_ |= Mask(1) << i;
        });
    }

    const Job& job_;
    const Scene& scene_;
    const Rays& rays_;
    const Starts& starts_;
    const Numbers& distance_;
    std::uint32_t& last_;
    Mask blocked_ = 0;
    Mask unsure_ = 0;
    SeeThroughs see_throughs_;
    PatchSpaces patches_;
};

}  // namespace lancer::wide::LANCER_LEVEL
