// The surfaces of eight hits with one torus: surface_point() of shapes/torus.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// \return hits that are left to scalar code
[[gnu::noinline]] inline Mask put_torus(const Scene& scene, const Torus& torus, const Rays& world,
                                        const NearestHits& hits, Mask mask, Surfaces& s) {
    const Numbers zero = all(0.0);
    const Rays r = rays_at(scene, torus, world);
    const Vectors near = (start_from(r, {zero, zero, zero}) + hits.t * r.dir) * all(torus.shrink);
    const Numbers away = root(near.x * near.x + near.z * near.z);
    const Numbers cosine = near.x / away;
    const Numbers sine = near.z / away;
    const Numbers out = away - all(torus.ring);
    const Numbers distance = root(out * out + near.y * near.y);
    // Points on the axis, or on the ring's centre line.
    Mask odd = mask & ~(less(zero, away) & less(zero, distance));
    const Numbers outwards = out / distance;
    const Numbers up = near.y / distance;
    const Numbers grow = all(torus.grow);
    const Numbers ring = all(torus.ring);
    const Vectors anchor = Vectors{ring * cosine, zero, ring * sine} * grow;
    const Vectors outward{outwards * cosine, up, outwards * sine};
    const Vectors offset = outward * all(torus.tube * torus.grow);
    const Vectors normal = outward * all(1.5);
    put_some(s.convex, mask & less(zero, outwards), hits.item[__builtin_ctz(mask)]);
    const Numbers error = all(gamma<double, 8> * ((torus.ring + torus.tube) * torus.grow));
    s.note(mask, anchor, offset, error);
    if (torus.frame == nothing) {
        const Vectors turned = unit(normal, odd);
        put(mask & ~odd, two_sum(anchor, offset), error, turned, s);
    } else {
        const Frame& frame = scene.frames[torus.frame];
        const Moved moved(frame, anchor, offset, error);
        const Vectors turned = unit(map_transposed(frame.linear_inverse, normal), odd);
        put(mask & ~odd, moved.place, moved.error, turned, s);
    }
    return mask & odd;
}

}  // namespace lancer::wide::LANCER_LEVEL
