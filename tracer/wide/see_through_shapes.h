// The crossings of eight shadow rays with glass, shape by shape.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

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

/// The crossings with a cylinder or cone of glass.
[[gnu::noinline]] inline void frustum_see_throughs(const Frustum& f, std::uint32_t item,
                                                   const Rays& r, const Starts& starts, Mask active,
                                                   const Numbers& distance, SeeThroughs& see) {
    const Mask own = active & equal(starts.item, item);
    const Mask inside = active & starts.bodies.inside(item);
    see.unsure |= own & ~inside;
    const Numbers reach = distance * all(1 + 0x1p-20);
    Mask asked = active & ~own & ~inside;
    if (asked != 0) asked = FrustumGuess(f, r, asked, reach).unsettled;
    asked |= inside;
    if (asked == 0) return;
    const FrustumCrossings c(f, r, asked, reach, FrustumStart(starts, item, inside));
    see.unsure |= c.unsure;
    const Mask enters = c.enters & ~inside;
    if (enters != 0) see.add(enters, c.in, c.in_error(), distance, item, 255);
    if (c.leaves != 0) see.add(c.leaves, c.out, c.out_error(), distance, item, 0);
}

/// The crossings with a mesh of glass.
inline void mesh_see_throughs(const Scene& scene, const Mesh& mesh, std::uint32_t item,
                              const Rays& r, const Starts& starts, Mask active,
                              const Numbers& distance, SeeThroughs& see) {
    const Numbers reach = distance * all(1 + 0x1p-20);
    const Mask own = active & equal(starts.item, item);
    see.know_starts(own);
    if (is_better_alone(scene, mesh, active)) {
        for_each_lane(active, [&](int i) {
            const Mask bit = Mask(1) << i;
            LoneMeshQuery query(mesh, r, i);
            query.crossings<Order::any>(
                nothing, [&] { return lane(reach, i); },
                [&](const LaneHit& hit) {
                    const Numbers t = all(hit.t);
                    const Numbers error = all(hit.error);
                    if ((own & bit) != 0 && hit.face == starts.face[i])
                        see.note_start(bit, t, error);
                    else
                        see.add(bit, t, error, distance, item, hit.entering ? bit : 0);
                    return false;
                });
        });
        return;
    }
    MeshQuery query(scene, mesh, item, r, starts);
    query.keep_start_faces();
    query.crossings<Order::any>(active, reach, [&](const TriangleHits& h, std::uint32_t face) {
        const Mask at_start = h.mask & own & equal(starts.face, face);
        if (at_start != 0) see.note_start(at_start, h.t, h.error);
        see.add(h.mask & ~at_start, h.t, h.error, distance, item, h.entering);
        return Mask(0);
    });
}

/// The crossings with a box of glass of rays that do not start on it, or that are inside of it.
LANCER_INLINE void box_see_throughs(const Box& box, std::uint32_t item, const Rays& r, Mask active,
                                    Mask inside, const Numbers& distance, SeeThroughs& see) {
    const BoxSpans span(box, r, active);
    see.unsure |= active & inside & ~span.met;
    if (span.met == 0) return;
    const auto offer = [&](Mask mask, const Numbers& t, const Numbers& error, Mask entering) {
        mask &= span.met & less(absolute(t), all(infinity));
        see.add(mask, t, error, distance, item, entering);
    };
    offer(~inside, span.in, span.in_error, 255);
    offer(255, span.out, span.out_error, 0);
}

/// Where rays cross the convex body that they start on and are inside of, by the formula for rays
/// that do not start on it: SeeThroughs::put_again(). They all start on one item.
[[gnu::noinline]] inline void see_again(const Scene& scene, std::uint32_t index, const Rays& r,
                                        Mask mask, const Numbers& distance, SeeThroughs& see) {
    const Item& item = scene.items[index];
    if (item.kind == Kind::ball) {
        const BallRoots roots(item.ball, r, mask);
        if (roots.met == 0) return;
        Numbers in_error, out_error;
        roots.bound_errors(item.ball, r, in_error, out_error);
        see.put_again(roots.met, roots.in, in_error, roots.out, out_error);
    } else if (item.kind == Kind::box) {
        const BoxSpans span(item.box, r, mask);
        if (span.met == 0) return;
        see.put_again(span.met, span.in, span.in_error, span.out, span.out_error);
    } else if (item.kind == Kind::frustum) {
        FrustumStart inside;
        inside.inside = mask;
        const FrustumCrossings c(scene.frustums[item.shape.index], r, mask,
                                 distance * all(1 + 0x1p-20), inside);
        const Mask both = c.enters & c.leaves;
        if (both == 0) return;
        see.put_again(both, c.in, c.in_error(), c.out, c.out_error());
    }
}

}  // namespace lancer::wide::LANCER_LEVEL
