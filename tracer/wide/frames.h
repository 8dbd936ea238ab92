// Eight rays in an object's own space: rays/frame.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

LANCER_INLINE Vectors map_vector(const double (&rows)[3][3], const Vectors& v) {
    return {dot(all(rows[0]), v), dot(all(rows[1]), v), dot(all(rows[2]), v)};
}
LANCER_INLINE Vectors map_transposed(const double (&rows)[3][3], const Vectors& v) {
    return all(rows[0]) * v.x + all(rows[1]) * v.y + all(rows[2]) * v.z;
}

/// The same sums, with |lo| <= u |hi| in each component: normalized()
LANCER_INLINE VectorPair normalized(const Vectors& hi, const Vectors& lo) {
    const Mask exact = is_zero(lo);
    if (exact == 255) return {hi, lo};
    const VectorPair sum = two_sum(hi, lo);
    return {select(exact, hi, sum.hi), select(exact, lo, sum.lo)};
}

/// mapping_error()
LANCER_INLINE Numbers mapping_error(const Frame& frame, const Numbers& by_map, const Vectors& low) {
    return frame.keeps_digits ? bound<2>() * max_component(absolute(low)) : by_map;
}

LANCER_INLINE Rays to_local(const Rays& r, const Frame& frame) {
    const VectorPair about = two_sum(r.origin, -all(frame.shift));
    const Vectors low = about.lo + r.origin_lo;
    const VectorPair start = normalized(about.hi, low);
    const Numbers by_map = bound<6>() * max_component(absolute(start.hi));
    const Numbers error = all(frame.inverse_norm) * (r.origin_error + all(frame.transform_error) +
                                                     mapping_error(frame, by_map, low));
    const VectorPair local = normalized(map_vector(frame.linear_inverse, start.hi),
                                        map_vector(frame.linear_inverse, start.lo));
    return make_rays(local.hi, local.lo, map_vector(frame.linear_inverse, r.dir), error);
}

}  // namespace lancer::wide::LANCER_LEVEL
