// The local light of eight surfaces: shading/lighting.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// LightSample<double>
struct LightSamples {
    Vectors direction, color;
    Numbers distance;
};

/// The factor of a light by its fade and its spot cone.
LANCER_INLINE Numbers light_factor(const Light& light, const LightSamples& at, Mask mask) {
    const Numbers zero = all(0.0);
    const Numbers one = all(1.0);
    Numbers factor = one;
    if (light.fades) {
        const Numbers far = select(mask, at.distance / all(light.fade_distance), one);
        factor = all(2.0) / (one + power(far, all(light.fade_power)));
    }
    switch (light.kind) {
        case Light::Kind::point:
        case Light::Kind::directional:
            return factor;
        case Light::Kind::spot:
            break;
    }
    const Numbers cosine = -dot(at.direction, all(light.axis));
    const Mask front = mask & ~at_most(cosine, zero);
    factor = factor * power(select(front, cosine, one), all(light.tightness));
    const Numbers width = all(light.cos_radius) - all(light.cos_falloff);
    const Numbers x = larger((cosine - all(light.cos_falloff)) / width, zero);
    const Numbers soft = factor * (x * x * (all(3.0) - all(2.0) * x));
    factor = select(less(cosine, all(light.cos_radius)), soft, factor);
    return select(front, factor, zero);
}

/// Whether a light has a factor at all, which takes powers.
LANCER_INLINE bool has_factor(const Light& light) {
    switch (light.kind) {
        case Light::Kind::point:
        case Light::Kind::directional:
            return light.fades;
        case Light::Kind::spot:
            return true;
    }
    return true;
}

/// sample_light()
LANCER_INLINE LightSamples sample_light(const Job& job, std::size_t index, const Surfaces& s,
                                        Mask mask) {
    const Light& light = job.scene->lights[index];
    LightSamples at;
    at.color = all(light.color);
    if (light.kind == Light::Kind::directional) {
        at.direction = all(light.place);
        at.distance = all(infinity);
        return at;
    }
    const Vectors way = -difference(s.position, s.position_lo, all(light.place));
    const Numbers square = dot(way, way);
    at.distance = root(square);
    at.direction = way / at.distance;
    const Mask sound = mask & is_sound_square(square);
    if (has_factor(light)) at.color = at.color * light_factor(light, at, sound);
    for_each_lane(mask & ~sound, [&](int i) {
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

/// metallic_share(), for cosines above 0
LANCER_INLINE Numbers metallic_share(const Numbers& cosine) {
    const Numbers one = all(1.0);
    constexpr double quarter_turn = static_cast<double>(1.570796326794896619231321691639751442L);
    const Numbers x =
        arc_cosine(smaller(one, cosine)) / all(quarter_turn) - all(static_cast<double>(1.12L));
    const Numbers f =
        all(static_cast<double>(0.014567225L)) / (x * x) - all(static_cast<double>(0.011612903L));
    return smaller(one, f);
}

/// tinted(): the colour of a highlight.
LANCER_INLINE Vectors tinted(const Surfaces& s, const Numbers& cosine, const Vectors& color,
                             Mask mask) {
    const Mask metallic = mask & ~equal(s.metallic, all(0.0));
    if (metallic == 0) return color;
    const Numbers one = all(1.0);
    const Vectors white{one, one, one};
    const Numbers amount = s.metallic * (one - metallic_share(select(metallic, cosine, one)));
    return select(metallic, color * (white + amount * (s.color - white)), color);
}

/// The strength of Phong's and Blinn's highlights.
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

/// Sets the items that rays in these directions leave for good: left_for_good().
LANCER_INLINE void set_left(const Surfaces& s, const Vectors& direction, Starts& starts) {
    const Mask outward = less(all(0.0), dot(s.geometric, direction));
    put_selected(starts.left, outward, s.convex, nothing);
}

/// The bodies around rays before and after their hits.
struct Around {
    Bodies before, after;

    /// Which of eight new rays in these directions go back to the side that the old rays came from:
    /// Crossed::towards().
    LANCER_INLINE static Mask back(const Surfaces& s, const Rays& r, const Vectors& direction) {
        const Numbers zero = all(0.0);
        return less(zero, dot(s.geometric, direction)) ^ less(zero, dot(s.geometric, r.dir));
    }
    /// Sets the bodies around the new rays.
    void put_towards(Mask is_back, Bodies& bodies) const {
        bodies.depth = before.depth > after.depth ? before.depth : after.depth;
        for (int k = 0; k < bodies.depth; ++k) {
            for (int i = 0; i < lanes; ++i) {
                const Bodies& from = (is_back >> i & 1) != 0 ? before : after;
                bodies.item[k][i] = k < from.depth ? from.item[k][i] : nothing;
            }
        }
    }
};

/// The local light of the surfaces: Lighting::local_color().
///
/// \param mirror  the rays' directions mirrored at the surfaces
/// \param around  null if no ray is in a body
inline Vectors local_color(Job& job, const Rays& r, const NearestHits& hits, const Surfaces& s,
                           const Vectors& mirror, Mask mask, const Around* around = nullptr) {
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
    starts.normal = s.geometric;
    starts.planes = mask;
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
            set_left(s, at.direction, starts);
            if (around != nullptr)
                around->put_towards(Around::back(s, r, at.direction), starts.bodies);
            lit = ShadowQuery(job, to_light, starts, at.distance, job.last_in_the_way[i])
                      .lit(lit, share);
            if (lit == 0) continue;
        }
        const Vectors color = at.color * share;
        lit &= less(zero, max_component(absolute(color)));
        if (lit == 0) continue;
        Vectors more = sum + s.opacity * s.color * color * (s.diffuse * cosine);
        if ((glossy & lit) != 0 && !light.fill) {
            const Numbers strength = highlight(s, r.dir, mirror, at.direction, lit);
            more = select(glossy, more + tinted(s, cosine, color, glossy & lit) * strength, more);
        }
        sum = select(lit, more, sum);
    }
    return sum;
}

}  // namespace lancer::wide::LANCER_LEVEL
