// What the lights bring out of eight surfaces: shading/lighting.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// LightSample<double>
struct LightSamples {
    Vectors direction, color;
    Numbers distance;
};

/// sample_light()
LANCER_INLINE LightSamples sample_light(const Job& job, std::size_t index, const Surfaces& s,
                                        Mask mask) {
    const Light& light = job.scene->lights[index];
    LightSamples at;
    at.color = all(light.color);
    Mask odd = mask;
    if (light.kind == Light::Kind::directional) {
        at.direction = all(light.place);
        at.distance = all(infinity);
        return at;
    }
    const Vectors way = -difference(s.position, s.position_lo, all(light.place));
    const Numbers square = dot(way, way);
    at.distance = root(square);
    at.direction = way / at.distance;
    if (light.kind == Light::Kind::point) odd &= ~is_sound_square(square);
    for_each_lane(odd, [&](int i) {
        const double position[] = {lane(s.position.x, i), lane(s.position.y, i),
                                   lane(s.position.z, i)};
        const double low[] = {lane(s.position_lo.x, i), lane(s.position_lo.y, i),
                              lane(s.position_lo.z, i)};
        LaneLight one;
        job.exact->light(index, position, low, one);
        set_lane(at.direction, i, one.direction);
        set_lane(at.color, i, one.color);
        set_lane(at.distance, i, one.distance);
    });
    return at;
}

/// Phong's and Blinn's highlights, by their strength.
LANCER_INLINE Numbers highlight(const Surfaces& s, const Vectors& ray_dir, const Vectors& mirror,
                                const Vectors& to_light, Mask mask) {
    const Numbers zero = all(0.0);
    const Numbers one = all(1.0);
    Numbers strength = zero;
    const Mask phong = mask & less(zero, s.phong);
    if (phong != 0) {
        const Numbers along = dot(mirror, to_light);
        const Mask shines = phong & less(zero, along);
        const Numbers x = power(select(shines, along, one), select(shines, s.shininess, one));
        strength = select(shines, strength + s.phong * x, strength);
    }
    const Mask blinn = mask & less(zero, s.blinn);
    if (blinn != 0) {
        const Vectors half = to_light - ray_dir;
        const Numbers along = dot(s.normal, half) / length(half);
        const Mask shines = blinn & less(zero, along);
        const Numbers x =
            power(select(shines, along, one), select(shines, s.inverse_roughness, one));
        strength = select(shines, strength + s.blinn * x, strength);
    }
    return strength;
}

/// Items that rays in these directions leave for good: left_for_good().
LANCER_INLINE void set_left(const Scene& scene, const NearestHits& hits, const Surfaces& s,
                            const Vectors& direction, Mask mask, Starts& starts) {
    const Mask outward = less(all(0.0), dot(s.geometric, direction));
    for (int i = 0; i < lanes; ++i) starts.left[i] = nothing;
    for_each_lane(mask & outward, [&](int i) {
        if (scene.items[hits.item[i]].convex) starts.left[i] = hits.item[i];
    });
}

/// The surfaces' own light: Lighting::local_color().
///
/// \param mirror  the rays' directions mirrored at the surfaces
inline Vectors local_color(Job& job, const Rays& r, const NearestHits& hits, const Surfaces& s,
                           const Vectors& mirror, Mask mask) {
    const Scene& scene = *job.scene;
    const Numbers zero = all(0.0);
    Vectors sum = s.opacity * s.color * s.own;
    const Mask glossy = less(zero, s.phong) | less(zero, s.blinn);
    const Mask matt = less(zero, s.diffuse) & less(zero, s.opacity);
    Starts starts;
    for (int i = 0; i < lanes; ++i) {
        starts.item[i] = (mask >> i & 1) != 0 ? hits.item[i] : nothing;
        starts.face[i] = hits.face[i];
    }
    starts.entering = hits.entering;
    for (std::size_t i = 0; i < scene.light_count; ++i) {
        const Light& light = scene.lights[i];
        const LightSamples at = sample_light(job, i, s, mask);
        const Numbers cosine = dot(s.normal, at.direction);
        Mask lit = mask & less(zero, cosine) & (glossy | matt) &
                   less(zero, max_component(absolute(at.color)));
        if (lit == 0) continue;
        Vectors share{all(1.0), all(1.0), all(1.0)};
        if (light.shadows) {
            job.counts.shadow += static_cast<std::uint64_t>(__builtin_popcount(lit));
            const Rays to_light = make_rays(s.position, s.position_lo, at.direction, s.error);
            set_left(scene, hits, s, at.direction, lit, starts);
            lit = ShadowQuery(job, to_light, starts, at.distance).lit(lit, share);
            if (lit == 0) continue;
        }
        const Vectors color = at.color * share;
        lit &= less(zero, max_component(absolute(color)));
        if (lit == 0) continue;
        Vectors more = sum + s.opacity * s.color * color * (s.diffuse * cosine);
        if ((glossy & lit) != 0 && !light.fill) {
            const Numbers strength = highlight(s, r.dir, mirror, at.direction, lit);
            more = select(glossy, more + color * strength, more);
        }
        sum = select(lit, more, sum);
    }
    return sum;
}

}  // namespace lancer::wide::LANCER_LEVEL
