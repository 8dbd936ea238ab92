// Rays by eights, as the tests of wide code take them.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "tests/oracle/tally.h"
#include "tracer/wide/job.h"

namespace lancer::oracle {

inline constexpr int lanes = 8;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline void put(const Vec3d& v, double (&to)[3]) {
    for (int i = 0; i < 3; ++i) to[i] = v[i];
}
inline wide::LaneRay lane_ray(const Ray<double>& ray) {
    wide::LaneRay r{};
    put(ray.origin, r.origin);
    put(ray.origin_lo, r.origin_lo);
    put(ray.dir, r.dir);
    r.origin_error = ray.origin_error;
    return r;
}

/// Eight rays, as different as cases of their own.
struct Eight {
    std::vector<Ray<double>> rays;
    std::vector<wide::LaneRay> lane_rays;

    template <class Make>
    Eight(const Draw& draw, Make&& make) {
        for (std::uint64_t i = 0; i < lanes; ++i) {
            Draw own(draw.number() * lanes + i);
            const Ray<double> ray = own.in_two_parts(make(own));
            const double error = own.number() % 5 == 2 ? own.decade(-18, -6) : 0;
            rays.push_back(make_ray(ray.origin, ray.origin_lo, ray.dir, error));
            lane_rays.push_back(lane_ray(rays.back()));
        }
    }
};

inline double some_limit(Draw& draw, double size) {
    return draw.number() % 2 == 0 ? infinity : size * draw.decade(-2, 4);
}

/// Equal, or both not a number.
inline void expect_same(float a, float b, const Draw& draw) {
    EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b)))
        << "case " << draw.number() << ": " << a << " " << b;
}

}  // namespace lancer::oracle
