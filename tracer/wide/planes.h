// Intersects eight rays with one plane: shapes/plane.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Adds the crossings of rays that do not start on the plane: crossing().
LANCER_INLINE void plane_crossings(const Plane& plane, std::uint32_t item, const Rays& r,
                                   Mask active, NearestHits& hits) {
    const Vectors normal = all(plane.normal);
    const Numbers slope = dot(normal, r.dir);
    const Numbers zero = all(0.0);
    active &= ~equal(slope, zero);
    if (active == 0) return;
    const Vectors rel = start_from(r, all(plane.point));
    const Numbers height = dot(normal, rel);
    const Numbers inv = all(1.0) / slope;
    const Numbers t = -height * inv;
    active &= ~less(hits.limit, t);
    if (active == 0) return;
    const Vectors steep = absolute(normal);
    const Numbers error =
        (r.origin_error + all(plane.transform_error) + bound<4>() * dot(steep, absolute(rel)) +
         bound<3>() * absolute(t) * dot(steep, absolute(r.dir))) *
            absolute(inv) +
        bound<4>() * absolute(t);
    hits.add_ahead(active, t, error, item, less(slope, zero));
}

/// Whether the plane hides the light from eight rays that do not start on it: PlaneGuess.
struct PlaneShadow {
    Mask blocks, unsure;

    LANCER_INLINE PlaneShadow(const Plane& plane, const Rays& r, Mask active,
                              const Numbers& distance) {
        const Vectors normal = all(plane.normal);
        const Numbers slope = dot(normal, r.dir);
        const Numbers zero = all(0.0);
        const Numbers noise = r.filter_error + all(plane.filter_error);
        const Numbers inv = all(1.0) / slope;
        const Numbers t = (all(plane.offset) - dot(normal, r.origin)) * inv;
        const Numbers slack = (all(9.0) * noise + bound<64>() * absolute(t)) * absolute(inv);
        const Numbers low = t - slack;
        const Numbers high = t + slack;
        const Mask may_meet =
            active & ~equal(slope, zero) & ~less(distance, low) & ~less(high, zero);
        blocks = may_meet & less(zero, low) & less(high, distance);
        unsure = may_meet & ~blocks;
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
