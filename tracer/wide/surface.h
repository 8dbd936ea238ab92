// Eight hits with what shading asks of them: shading/surface.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Eight hits with all that shading asks of them: Surface<double> and its finish.
struct Surfaces {
    Vectors position, position_lo, geometric, normal, color, reflection, own;
    Numbers error, opacity, diffuse, phong, shininess, blinn, inverse_roughness, metallic;
    Numbers ior, fresnel;
};

LANCER_INLINE void put(Mask mask, const VectorPair& place, const Numbers& error,
                       const Vectors& normal, Surfaces& s) {
    s.position = select(mask, place.hi, s.position);
    s.position_lo = select(mask, place.lo, s.position_lo);
    s.error = select(mask, error, s.error);
    s.geometric = select(mask, normal, s.geometric);
    s.normal = select(mask, normal, s.normal);
}

}  // namespace lancer::wide::LANCER_LEVEL
