// Rays of lanes in the form of scalar code.
#pragma once

#include "tracer/intersect/intersection_filter.h"
#include "tracer/rays/ray.h"
#include "tracer/wide/exact_methods.h"

namespace lancer::wide {

inline Vec3d vector_of(const double* v) {
    return {v[0], v[1], v[2]};
}

inline Ray<double> ray_of(const LaneRay& r) {
    return {vector_of(r.origin), vector_of(r.origin_lo), vector_of(r.dir),
            r.dir_squared,       r.inv_squared,          r.origin_error,
            r.filter_error,      vector_of(r.inv_dir),   r.whole};
}
inline lancer::Start<double> start_of(const LaneStart& from) {
    lancer::Start<double> start;
    if (from.item != none) start.surfaces.push_back({from.item, from.face, from.entering});
    start.left = from.left;
    return start;
}
inline MediaList list_of(const std::uint32_t (&from)[most_bodies]) {
    MediaList bodies;
    for (const std::uint32_t body : from)
        if (body != none) bodies.push_back(body);
    return bodies;
}

}  // namespace lancer::wide
