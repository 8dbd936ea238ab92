// The bodies around rays through glass: intersect/media.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Rays whose hit lies outside the bounds of a body in their list: lost_bodies() of
/// intersect/media.h.
inline Mask lost_bodies(const Scene& scene, const Rays& r, const Starts& starts,
                        const NearestHits& hits, Mask active) {
    const Vectors way = hits.t * r.dir;
    const Vectors point = (r.origin + way) + r.origin_lo;
    const Numbers far = absolute(hits.t);
    const Numbers error = r.origin_error;
    const Vectors slack =
        bound<16>() * (absolute(r.origin) + Vectors{far, far, far}) + Vectors{error, error, error};
    Vectors min = point;
    Vectors max = point;
    Mask outside = 0;
    for (int k = 0; k < starts.bodies.depth; ++k) {
        const std::uint32_t* body = starts.bodies.item[k];
        Mask mask = active & ~equal(body, nothing);
        for_each_lane(mask, [&](int i) {
            const double* bounds = scene.medium_bounds[scene.medium_slots[body[i]]];
            set_lane(min, i, bounds);
            set_lane(max, i, bounds + 3);
        });
        const Vectors low = min - slack;
        const Vectors high = max + slack;
        mask &= at_most(low.x, point.x) & at_most(low.y, point.y) & at_most(low.z, point.z) &
                at_most(point.x, high.x) & at_most(point.y, high.y) & at_most(point.z, high.z);
        outside |= active & ~equal(body, nothing) & ~mask;
    }
    return outside;
}

/// What is left of light, where it goes this far through bodies: Whitted::transmittance_between().
inline Vectors dimmed(const Scene& scene, const Starts& starts, const Numbers& way, Mask mask,
                      const Vectors& light) {
    if (!scene.has_absorption) return light;
    const Numbers zero = all(0.0);
    Vectors absorption{zero, zero, zero};
    Mask absorbs = 0;
    for_each_lane(mask, [&](int i) {
        const Finish& body = scene.finishes[scene.items[starts.bodies.last(i)].material];
        if (!body.absorbs) return;
        set_lane(absorption, i, body.absorption);
        absorbs |= Mask(1) << i;
    });
    if (absorbs == 0) return light;
    return select(absorbs, light * beer_lambert_transmittance(absorption, way), light);
}

inline double index_of(const Scene& scene, const Bodies& bodies, int i) {
    const std::uint32_t body = bodies.last(i);
    return body == nothing ? 1 : scene.finishes[scene.items[body].material].ior;
}

/// Media before and behind hits.
struct GlassMedia {
    Around bodies;
    Around optical;               ///< in worlds with smooth media: Media::optical
    Numbers ratio, index_before;  ///< ratio: index before over index behind
    Mask glass = 0;               ///< hits with bodies that are media

    /// Crosses the surfaces of the hits: crossed().
    ///
    /// \param clear  hits with bodies that are media
    /// \return hits that are left to scalar code: those with more bodies than there is room for,
    ///         and those where light goes straight on
    Mask cross(const Scene& scene, const Starts& starts, const NearestHits& hits, Mask met,
               Mask clear) {
        bodies.before = bodies.after = starts.bodies;
        const bool smooth = scene.has_smooth_media;
        if (smooth) optical.before = optical.after = starts.optical;
        const Around& indices = smooth ? optical : bodies;
        ratio = index_before = all(1.0);
        glass = clear & met;
        Mask exact = 0;
        const bool some_bodies = indices.before.depth != 0;
        for_each_lane(some_bodies ? met : glass, [&](int i) {
            const double before = some_bodies ? index_of(scene, indices.before, i) : 1;
            set_lane(index_before, i, before);
            const std::uint32_t item = hits.item[i];
            const Mask bit = Mask(1) << i;
            if ((glass & bit) == 0) return;
            bool has_room = true;
            if ((hits.entering & bit) == 0)
                bodies.after.remove(i, item);
            else
                has_room = bodies.after.add(i, item);
            if (smooth) has_room = optical.after.toggle(i, item) && has_room;
            if (!has_room) {
                exact |= bit;
                return;
            }
            const double one = before / index_of(scene, indices.after, i);
            if (one == 1) exact |= bit;
            set_lane(ratio, i, one);
        });
        return exact;
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
