// Eight hits with what shading asks of them: shading/surface.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// SurfacePoint<double>, as far as textures ask.
struct SurfacePoints {
    Vectors anchor, offset;  ///< in the primitives' own spaces
    Numbers error;
};

/// Eight hits with all that shading asks of them: Surface<double> and its finish.
struct Surfaces {
    Vectors position, position_lo, geometric, normal, color, reflection, own;
    Numbers error, opacity, diffuse, phong, shininess, blinn, inverse_roughness, metallic;
    Numbers ior, fresnel;
    alignas(32) std::uint32_t convex[lanes];  ///< the items of the hits that are, else `nothing`
    SurfacePoints* points;                    ///< null: nobody asks

    LANCER_INLINE void note(Mask mask, const Vectors& anchor, const Vectors& offset,
                            const Numbers& of_point) {
        if (points == nullptr) return;
        points->anchor = select(mask, anchor, points->anchor);
        points->offset = select(mask, offset, points->offset);
        points->error = select(mask, of_point, points->error);
    }
};

LANCER_INLINE void put(Mask mask, const VectorPair& place, const Numbers& error,
                       const Vectors& normal, Surfaces& s) {
    s.position = select(mask, place.hi, s.position);
    s.position_lo = select(mask, place.lo, s.position_lo);
    s.error = select(mask, error, s.error);
    s.geometric = select(mask, normal, s.geometric);
    s.normal = select(mask, normal, s.normal);
}
/// Points in world space.
LANCER_INLINE void put(Mask mask, const Vectors& anchor, const Vectors& offset,
                       const Numbers& error, const Vectors& normal, Surfaces& s) {
    s.note(mask, anchor, offset, error);
    put(mask, two_sum(anchor, offset), error, normal, s);
}

}  // namespace lancer::wide::LANCER_LEVEL
