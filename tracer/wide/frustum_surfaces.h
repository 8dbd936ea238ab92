// The surfaces of eight hits with cylinders and cones in world space: surface_point() of
// shapes/frustum.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The frustums that eight rays hit.
struct HitFrustums {
    Vectors end;  ///< the centre of the hit cap; for the side, the small end
    Vectors axis;
    Numbers radius, slope;
    Mask sides = 0;   ///< hits on sides
    Mask small = 0;   ///< hits on small caps
    Mask tilted = 0;  ///< hits on sides of tilted frustums

    LANCER_INLINE HitFrustums(const Scene& scene, const NearestHits& hits, Mask mask) {
        const Numbers zero = all(0.0);
        end = axis = {zero, zero, zero};
        radius = slope = zero;
        for_each_item(hits.item, mask, [&](std::uint32_t item, Mask same) {
            const Frustum& f = scene.frustums[scene.items[item].shape.index];
            const Mask large = same & equal(hits.face, large_cap);
            end = select(same, all(f.small_end), end);
            end = select(large, all(f.large_end), end);
            axis = select(same, all(f.axis), axis);
            small |= same & equal(hits.face, small_cap);
            const Mask side = same & equal(hits.face, frustum_side);
            sides |= side;
            if (f.tilted) tilted |= side;
            radius = select(side, all(f.radius), radius);
            slope = select(side, all(f.slope), slope);
        });
    }
};

LANCER_INLINE void put_caps(const HitFrustums& f, const Vectors& rel, const Vectors& way, Mask mask,
                            Surfaces& s) {
    Vectors offset = rel + way;
    offset = offset - dot(f.axis, offset) * f.axis;
    const Numbers error = bound<4>() * dot(absolute(f.axis), absolute(offset));
    Mask odd = 0;  // not used: axes are unit vectors
    const Vectors normal = unit(select(f.small, -f.axis, f.axis), odd);
    put(mask, f.end, offset, error, normal, s);
}

/// \return hits that are left to scalar code
LANCER_INLINE Mask put_sides(const HitFrustums& f, const Rays& r, const Vectors& rel,
                             const NearestHits& hits, Mask mask, Surfaces& s) {
    const Numbers start_axial = dot(f.axis, rel);
    const Vectors start_perp = rel - start_axial * f.axis;
    const Numbers dir_axial = dot(f.axis, r.dir);
    const Vectors dir_perp = r.dir - dir_axial * f.axis;
    const Numbers axial = start_axial + hits.t * dir_axial;
    Vectors radial = start_perp + hits.t * dir_perp;
    if (f.tilted != 0) {
        const Vectors once_more = radial - dot(f.axis, radial) * f.axis;
        radial = select(f.tilted, once_more, radial);
    }
    const Numbers distance = length(radial);
    const Numbers radius = f.radius + f.slope * axial;
    Mask odd = mask & ~less(all(0.0), distance);  // the apex
    const Vectors outward = radial / distance;
    const Vectors offset = axial * f.axis + radius * outward;
    const Vectors normal = unit(outward - f.slope * f.axis, odd);
    put(mask & ~odd, f.end, offset, bound<8>() * length(offset), normal, s);
    return mask & odd;
}

/// \return hits that are left to scalar code
[[gnu::noinline]] inline Mask put_frustums(const Scene& scene, const Rays& r,
                                           const NearestHits& hits, Mask mask, Surfaces& s) {
    const HitFrustums f(scene, hits, mask);
    const Vectors rel = start_from(r, f.end);
    const Mask caps = mask & ~f.sides;
    if (caps != 0) put_caps(f, rel, hits.t * r.dir, caps, s);
    return f.sides == 0 ? 0 : put_sides(f, r, rel, hits, f.sides, s);
}

}  // namespace lancer::wide::LANCER_LEVEL
