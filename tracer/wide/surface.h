// Eight hits with the data that shading needs: shading/surface.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Those members of SurfacePoint<double> that textures need.
struct SurfacePoints {
    Vectors anchor, offset, rest;  ///< in the primitives' own spaces
    Numbers error;
};

/// Eight hits with all data that shading needs: Surface<double> and its finish.
struct Surfaces {
    Vectors position, position_lo, geometric, normal, color, reflection, own;
    Numbers error, opacity, diffuse, phong, shininess, blinn, inverse_roughness, metallic;
    Numbers ior, fresnel;
    alignas(32)
        std::uint32_t convex[lanes];  ///< the items of hits on their convex hulls, else `nothing`
    SurfacePoints* points;            ///< null if no surface has a texture

    LANCER_INLINE void note(Mask mask, const Vectors& anchor, const Vectors& offset,
                            const Numbers& of_point) {
        if (points == nullptr) return;
        points->anchor = select(mask, anchor, points->anchor);
        points->offset = select(mask, offset, points->offset);
        points->error = select(mask, of_point, points->error);
    }
    LANCER_INLINE void note_rest(Mask mask, const Vectors& rest) {
        if (points != nullptr) points->rest = select(mask, rest, points->rest);
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
/// For points in world space.
LANCER_INLINE void put(Mask mask, const Vectors& anchor, const Vectors& offset,
                       const Numbers& error, const Vectors& normal, Surfaces& s) {
    s.note(mask, anchor, offset, error);
    put(mask, two_sum(anchor, offset), error, normal, s);
}

/// Maps points from an object's own space to the world: make_surface().
struct Moved {
    VectorPair place;
    Numbers error;

    LANCER_INLINE Moved(const Frame& frame, const Vectors& from, const Vectors& by,
                        const Numbers& of_point) {
        const Vectors anchor = map_vector(frame.to_world, from);
        const Vectors offset = map_vector(frame.to_world, by);
        const VectorPair inner = two_sum(anchor, offset);
        place = two_sum(all(frame.shift), inner.hi);
        const Vectors low = place.lo + inner.lo;
        const VectorPair whole = normalized(place.hi, low);
        const Mask exact = is_zero(inner.lo);
        place = {select(exact, place.hi, whole.hi), select(exact, place.lo, whole.lo)};
        const Numbers size = max_component(absolute(anchor)) + max_component(absolute(offset));
        error = all(frame.norm) * of_point + mapping_error(frame, bound<4>() * size, low);
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
