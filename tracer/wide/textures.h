// The colours of patterns at eight points: textures/placement.h and textures/pattern.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// PatternPoint<double>
struct PatternPoints {
    Vectors at, bound;
};

/// The placements of the textures of eight items.
struct Textures {
    Vectors rows[3];
    Vectors shift, bound, from;

    LANCER_INLINE Textures(const Scene& scene, const NearestHits& hits, Mask mask) {
        const auto texture_of = [&](int i) -> const Texture& {
            return scene.textures[scene.texture_of[hits.item[i]]];
        };
        const int first = __builtin_ctz(mask);
        const Texture& one = texture_of(first);
        for (int k = 0; k < 3; ++k) rows[k] = all(one.rows[k]);
        shift = all(one.shift);
        bound = all(one.bound);
        from = all(one.from);
        for_each_lane(mask & ~equal(hits.item, hits.item[first]), [&](int i) {
            const Texture& other = texture_of(i);
            for (int k = 0; k < 3; ++k) set_lane(rows[k], i, other.rows[k]);
            set_lane(shift, i, other.shift);
            set_lane(bound, i, other.bound);
            set_lane(from, i, other.from);
        });
    }

    /// place()
    LANCER_INLINE PatternPoints place(const SurfacePoints& p) const {
        const auto map = [&](const Vectors& v) {
            return Vectors{dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
        };
        const Vectors anchor = (p.anchor - from) + p.rest;
        const Vectors reach = Vectors{p.error, p.error, p.error} +
                              bound_of_roundings() * (absolute(anchor) + absolute(p.offset));
        const Vectors moved{dot(absolute(rows[0]), reach), dot(absolute(rows[1]), reach),
                            dot(absolute(rows[2]), reach)};
        return {(map(anchor) + shift) + map(p.offset), bound + moved};
    }

  private:
    LANCER_INLINE static Numbers bound_of_roundings() { return LANCER_LEVEL::bound<16>(); }
};

LANCER_INLINE Vectors checker_colors(const Pattern& p, const PatternPoints& points) {
    Mask odd = 0;
    const auto count = [&](const Numbers& at, const Numbers& bound) {
        const Numbers whole = floor(at + bound);
        odd ^= 255 & ~equal(whole, all(2.0) * floor(whole / all(2.0)));
    };
    count(points.at.x, points.bound.x);
    count(points.at.y, points.bound.y);
    count(points.at.z, points.bound.z);
    return select(odd, all(p.odd), all(p.even));
}

LANCER_INLINE Vectors gradient_colors(const Pattern& p, const PatternPoints& points, Mask mask) {
    const Numbers zero = all(0.0);
    const Numbers one = all(1.0);
    const Vectors axis = all(p.axis);
    const Numbers along = dot(axis, points.at);
    const Vectors weights = absolute(axis);
    const Numbers bound =
        dot(weights, points.bound) + LANCER_LEVEL::bound<4>() * dot(weights, absolute(points.at));
    const Numbers g = larger(along - floor(along + bound), zero);
    const Numbers value = g + bound;
    Vectors color = all(p.stops[p.stop_count - 1].color);
    for (std::uint32_t k = 0; k < p.stop_count && mask != 0; ++k) {
        const Stop& above = p.stops[k];
        const Mask here = mask & less(value, all(above.at));
        if (here == 0) continue;
        mask &= ~here;
        Vectors between = all(above.color);
        if (k != 0) {
            const Stop& low = p.stops[k - 1];
            const Numbers share = larger((g - all(low.at)) / all(above.at - low.at), zero);
            between = (one - share) * all(low.color) + share * between;
        }
        color = select(here, between, color);
    }
    return color;
}

/// Sets the colours of the surfaces in the mask. All of them have textures that wide code can
/// compute.
[[gnu::noinline]] inline void put_texture_colors(const Scene& scene, const NearestHits& hits,
                                                 const SurfacePoints& at, Mask mask, Surfaces& s) {
    const PatternPoints points = Textures(scene, hits, mask).place(at);
    while (mask != 0) {
        const auto pattern_of = [&](int i) {
            return scene.textures[scene.texture_of[hits.item[i]]].pattern;
        };
        const std::uint32_t first = pattern_of(__builtin_ctz(mask));
        Mask same = 0;
        for_each_item(hits.item, mask, [&](std::uint32_t, Mask alike) {
            if (pattern_of(__builtin_ctz(alike)) == first) same |= alike;
        });
        const Pattern& p = scene.patterns[first];
        const Vectors color = p.kind == Pattern::Kind::checker ? checker_colors(p, points)
                                                               : gradient_colors(p, points, same);
        s.color = select(same, color, s.color);
        mask &= ~same;
    }
}

}  // namespace lancer::wide::LANCER_LEVEL
