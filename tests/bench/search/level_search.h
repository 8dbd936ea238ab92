// The search of the wide code alone. Compiled once for each level, after wide/level_code.h.
#pragma once

namespace lancer::wide {

/// Eight rays, and what they meet first.
struct EightRays {
    double origin[3][8], dir[3][8];
    double t[8];
    std::uint32_t face[8];
    std::uint32_t some;    ///< a bit for each ray that meets something
    std::uint32_t unsure;  ///< those that are left to scalar code
};

}  // namespace lancer::wide

#ifdef LANCER_LEVEL
namespace lancer::wide::LANCER_LEVEL {

[[gnu::noinline]] inline void search_eight(const Job& job, EightRays& rays) {
    const Numbers zero = all(0.0);
    const Vectors origin{load(rays.origin[0]), load(rays.origin[1]), load(rays.origin[2])};
    const Vectors dir{load(rays.dir[0]), load(rays.dir[1]), load(rays.dir[2])};
    const Rays r = make_rays(origin, {zero, zero, zero}, dir, zero);
    Starts starts;
    for (int i = 0; i < lanes; ++i) {
        starts.item[i] = starts.left[i] = nothing;
        starts.face[i] = 0;
    }
    NearestHits hits;
    find_nearest(job, r, starts, 255, hits);
    store(rays.t, hits.t);
    for (int i = 0; i < lanes; ++i) rays.face[i] = hits.face[i];
    rays.some = hits.some;
    rays.unsure = hits.unsure;
}

}  // namespace lancer::wide::LANCER_LEVEL
#endif
