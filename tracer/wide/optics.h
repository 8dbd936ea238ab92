// Light at eight surfaces: shading/optics.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// mirrored()
LANCER_INLINE Vectors mirrored(const Vectors& d, const Vectors& n) {
    return normalize(d - all(2.0) * dot(d, n) * n);
}

/// refracted(): the directions, and the lanes with total reflection, where `bent` has no meaning.
struct Refracted {
    Vectors bent;
    Mask total;

    LANCER_INLINE Refracted(const Vectors& d, const Vectors& n, const Numbers& ratio) {
        const Numbers one = all(1.0);
        const Numbers c = -dot(d, n);
        const Numbers q = (one - ratio) * (one + ratio) + (ratio * c) * (ratio * c);
        total = less(q, all(0.0));
        const Numbers sum = ratio * c + root(select(total, one, q));
        bent = normalize(ratio * d + (ratio - one) * (ratio + one) / sum * n);
    }
};

/// fresnel_reflectance()
LANCER_INLINE Numbers fresnel_reflectance(const Numbers& cosine, const Numbers& index) {
    const Numbers one = all(1.0);
    const Numbers g2 = (index - one) * (index + one) + cosine * cosine;
    const Mask total = at_most(g2, all(0.0));
    const Numbers g = root(select(total, one, g2));
    const Numbers a = (g - cosine) / (g + cosine);
    const Numbers b = (cosine * (g + cosine) - one) / (cosine * (g - cosine) + one);
    return select(total, one, a * a * (one + b * b) / all(2.0));
}

/// The index after opaque surfaces over the index before them: opaque_reflectance().
///
/// \param outside  the index of the media around the rays
LANCER_INLINE Numbers opaque_index(const Scene& scene, const NearestHits& hits, const Surfaces& s,
                                   const Numbers& outside, Mask mask) {
    const Numbers index = s.ior / outside;
    Mask goes_out = 0;
    for_each_lane(mask & ~hits.entering, [&](int i) {
        if (scene.items[hits.item[i]].body) goes_out |= Mask(1) << i;
    });
    return select(goes_out, all(1.0) / index, index);
}

/// The share of light that eight surfaces mirror.
///
/// \param index  the index after the surface over the index before it
LANCER_INLINE Vectors mirror_of(const Surfaces& s, const Vectors& ray_dir, const Numbers& index,
                                Mask mask) {
    const Mask fresnel = mask & less(all(0.0), s.fresnel);
    if (fresnel == 0) return s.reflection;
    const Numbers one = all(1.0);
    const Numbers cosine = select(fresnel, -dot(s.normal, ray_dir), one);
    const Numbers share = fresnel_reflectance(cosine, select(fresnel, index, one));
    return select(fresnel, s.reflection * share, s.reflection);
}

}  // namespace lancer::wide::LANCER_LEVEL
