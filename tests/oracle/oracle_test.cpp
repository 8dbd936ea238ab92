// Each kernel against 256-bit arithmetic: how far t, the point and the normal are off, and whether
// the bound that the kernel reports with t really bounds its error.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

#include "tracer/shapes/box.h"
#include "tracer/shapes/frustum.h"
#include "tracer/shapes/plane.h"
#include "tracer/shapes/sphere.h"
#include "tracer/shapes/triangle.h"

namespace lancer {
namespace {

using boost::multiprecision::cpp_bin_float;
using boost::multiprecision::digit_base_2;
using Exact =
    boost::multiprecision::number<cpp_bin_float<256, digit_base_2>, boost::multiprecision::et_off>;

using lancer::cross;
using lancer::dot;
using lancer::length;

struct ExactVec {
    Exact x, y, z;
};
ExactVec exact(const Vec3d& v) {
    return {v.x, v.y, v.z};
}
ExactVec operator+(const ExactVec& a, const ExactVec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
ExactVec operator-(const ExactVec& a, const ExactVec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
ExactVec operator*(const Exact& s, const ExactVec& v) {
    return {s * v.x, s * v.y, s * v.z};
}
Exact dot(const ExactVec& a, const ExactVec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
ExactVec cross(const ExactVec& a, const ExactVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Exact length(const ExactVec& v) {
    return sqrt(dot(v, v));
}
ExactVec unit_length(const ExactVec& v) {
    return (1 / length(v)) * v;
}

/// Worst and typical cases over many rays.
struct Tally {
    double worst_t = 0;         ///< error of t, in ulps of the larger of |t| and the shape's size
    double worst_share = 0;     ///< error of t over the bound reported: above 1 the bound is wrong
    std::vector<double> slack;  ///< the bound in ulps of the same
    double worst_point = 0;     ///< distance of the point from the surface, ulps of the size
    double worst_share_point = 0;
    double worst_normal = 0;  ///< ulps of 1
    std::uint64_t hits = 0;
    Ray<double> worst_ray{};

    void hit(const Ray<double>& ray, const Crossing<double>& c, const Exact& t, double size) {
        ++hits;
        const double scale = std::max(std::abs(c.t) * std::sqrt(ray.dir_squared), size) /
                             std::sqrt(ray.dir_squared) * std::numeric_limits<double>::epsilon();
        const double error = static_cast<double>(abs(Exact(c.t) - t));
        worst_t = std::max(worst_t, error / scale);
        slack.push_back(c.error / scale);
        const double share = error == 0 ? 0 : error / c.error;
        if (share > worst_share) {
            worst_share = share;
            worst_ray = ray;
        }
    }
    void point(const SurfacePoint<double>& p, const Exact& distance, const ExactVec& normal,
               double size) {
        const double off = static_cast<double>(abs(distance));
        worst_point = std::max(worst_point, off / size / std::numeric_limits<double>::epsilon());
        if (off > 0) worst_share_point = std::max(worst_share_point, off / p.error);
        const ExactVec n = unit_length(exact(p.normal));
        worst_normal = std::max(worst_normal, static_cast<double>(length(n - unit_length(normal))) /
                                                  std::numeric_limits<double>::epsilon());
    }
    void report(const char* shape) {
        ASSERT_GT(hits, 100u);
        std::nth_element(slack.begin(), slack.begin() + static_cast<std::ptrdiff_t>(hits / 2),
                         slack.end());
        const double typical = slack[hits / 2];
        std::cout << "| " << shape << " | " << hits << " | " << worst_t << " | " << typical << " | "
                  << worst_share << " | " << worst_point << " | " << worst_share_point << " | "
                  << worst_normal << " |\n";
        EXPECT_LE(worst_share, 1) << shape << ": origin " << worst_ray.origin.x << " "
                                  << worst_ray.origin.y << " " << worst_ray.origin.z
                                  << " direction " << worst_ray.dir.x << " " << worst_ray.dir.y
                                  << " " << worst_ray.dir.z;
        EXPECT_LE(worst_share_point, 1) << shape;
        EXPECT_LE(typical, 200) << shape << ": half of the bounds are wider than this, in ulps";
    }
};

class Oracle : public testing::Test {
  protected:
    std::mt19937_64 random{20240607};
    double unit() { return static_cast<double>(random() >> 11) / 9007199254740992.0; }
    double between(double a, double b) { return a + (b - a) * unit(); }
    double decade(double low, double high) { return std::pow(10.0, between(low, high)); }
    Vec3d direction() {
        for (;;) {
            const Vec3d v(between(-1, 1), between(-1, 1), between(-1, 1));
            const double l = length_squared(v);
            if (l > 0.01 && l < 1) return normalize(v);
        }
    }
    /// From some distance (10^-3 to 10^4 sizes) towards a place near the shape.
    Ray<double> ray_at(const Vec3d& place, double size) {
        const Vec3d target = place + direction() * (size * between(0, 1));
        const Vec3d from = place + direction() * (size * decade(-3, 4));
        return make_ray(from, Vec3d(0), normalize(target - from), 0.0);
    }
    int rays() const {
        const char* wanted = std::getenv("LANCER_ORACLE_RAYS");
        return wanted == nullptr ? 10000 : std::atoi(wanted);
    }
};

TEST_F(Oracle, Ball) {
    Tally tally;
    for (int i = 0; i < rays(); ++i) {
        const BallSolid<double> ball{direction() * decade(-2, 2), decade(-3, 3)};
        // Every other ray nearly touches.
        Ray<double> ray = ray_at(ball.center, ball.radius);
        if (i % 2 == 1) {
            const Vec3d edge = normalize(cross(ray.dir, direction()));
            const double reach = ball.radius * (1 - decade(-17, -1));
            ray = make_ray(ball.center + edge * reach - ray.dir * (ball.radius * decade(0, 4)),
                           Vec3d(0), ray.dir, 0.0);
        }
        const ExactVec f = exact(ball.center) - exact(ray.origin);
        const ExactVec d = exact(ray.dir);
        const Exact dd = dot(d, d);
        const Exact b = dot(f, d);
        const Exact square = b * b - dd * (dot(f, f) - Exact(ball.radius) * ball.radius);
        const Exact root = square > 0 ? Exact(sqrt(square)) : Exact(0);
        crossings(ball, ray, Known{}, [&](const Crossing<double>& c) {
            const Exact t = c.entering ? Exact((b - root) / dd) : Exact((b + root) / dd);
            tally.hit(ray, c, t, ball.radius);
            const SurfacePoint<double> p = surface_point(ball, ray, c.t, 0);
            const ExactVec from_center =
                exact(p.anchor) + exact(p.offset) + exact(p.rest) - exact(ball.center);
            const ExactVec truth = exact(ray.origin) + Exact(c.t) * d - exact(ball.center);
            tally.point(p, length(from_center) - ball.radius, truth, ball.radius);
        });
    }
    tally.report("sphere");
}

/// The other root from a start on the sphere, whatever the angle.
TEST_F(Oracle, BallFromItsSurface) {
    Tally tally;
    for (int i = 0; i < rays(); ++i) {
        const BallSolid<double> ball{direction() * decade(-2, 2), decade(-3, 3)};
        const Vec3d n = direction();
        const VectorSum<double> start = two_sum(ball.center, n * ball.radius);
        Vec3d along = direction();
        if (i % 2 == 1) along = normalize(cross(n, along)) + n * decade(-16, -1);
        const Ray<double> ray = make_ray(start.hi, start.lo, normalize(along), 0.0);
        const ExactVec f = exact(ball.center) - exact(ray.origin) - exact(ray.origin_lo);
        const Exact t = 2 * dot(f, exact(ray.dir)) / dot(exact(ray.dir), exact(ray.dir));
        crossings(ball, ray, Known{0, false},
                  [&](const Crossing<double>& c) { tally.hit(ray, c, t, ball.radius); });
    }
    tally.report("sphere, from its surface");
}

TEST_F(Oracle, Box) {
    Tally tally;
    for (int i = 0; i < rays(); ++i) {
        const Vec3d corner = direction() * decade(-2, 2);
        const Vec3d sides(decade(-3, 1), decade(-3, 1), decade(-3, 1));
        const BoxSolid<double> box{corner, corner + sides};
        const double size = max_component(sides);
        const Ray<double> ray = ray_at(corner + sides / 2.0, size);
        crossings(box, ray, Known{}, [&](const Crossing<double>& c) {
            const int axis = static_cast<int>(c.face / 2);
            const double at = c.face % 2 == 1 ? box.max[axis] : box.min[axis];
            const Exact t = (Exact(at) - ray.origin[axis]) / ray.dir[axis];
            tally.hit(ray, c, t, size);
        });
    }
    tally.report("box");
}

TEST_F(Oracle, Plane) {
    Tally tally;
    for (int i = 0; i < rays(); ++i) {
        const HalfSpace<double> half{direction(), direction() * decade(-2, 2)};
        Ray<double> ray = ray_at(half.point, 1);
        if (i % 2 == 1) {  // grazing
            const Vec3d along = normalize(cross(half.normal, direction()));
            ray = make_ray(ray.origin, Vec3d(0), normalize(along + half.normal * decade(-12, -1)),
                           0.0);
        }
        crossings(half, ray, Known{}, [&](const Crossing<double>& c) {
            const ExactVec n = exact(half.normal);
            const Exact t = dot(n, exact(half.point) - exact(ray.origin)) / dot(n, exact(ray.dir));
            tally.hit(ray, c, t, 1);
            const SurfacePoint<double> p = surface_point(half, ray, c.t, 0);
            const ExactVec rel = exact(p.anchor) + exact(p.offset) - exact(half.point);
            // How far the point may be off grows with its distance from the plane's own point.
            const double reach = std::max(1.0, static_cast<double>(length(rel)));
            tally.point(p, dot(n, rel) / length(n), n, reach);
        });
    }
    tally.report("plane");
}

TEST_F(Oracle, Triangle) {
    Tally tally;
    for (int i = 0; i < rays(); ++i) {
        const Vec3d place = direction() * decade(-2, 2);
        const double size = decade(-3, 2);
        const double flat = i % 2 == 1 ? decade(-8, 0) : 1;  // needles
        const Vec3d a = place;
        const Vec3d b = place + direction() * size;
        const Vec3d c3 = a + (b - a) * unit() + direction() * (size * flat);
        const TriangleSheet<double> triangle{a, b, c3};
        const double u = unit();
        const double v = unit() * (1 - u);
        const Vec3d target = a + u * (b - a) + v * (c3 - a);
        const Vec3d from = target + direction() * (size * decade(-3, 4));
        const Ray<double> ray = make_ray(from, Vec3d(0), normalize(target - from), 0.0);
        TriangleHit<double> hit;
        if (!intersect(triangle, ray, hit)) continue;
        const ExactVec n = cross(exact(b) - exact(a), exact(c3) - exact(a));
        const Exact t = dot(n, exact(a) - exact(ray.origin)) / dot(n, exact(ray.dir));
        tally.hit(ray, {hit.t, hit.error, 0, hit.entering}, t, size);
        const SurfacePoint<double> p = triangle_point(triangle, hit.u, hit.v);
        const ExactVec rel = exact(p.anchor) + exact(p.offset) - exact(a);
        const Exact off = dot(unit_length(n), rel);
        const double distance = static_cast<double>(abs(off));
        tally.worst_point =
            std::max(tally.worst_point, distance / size / std::numeric_limits<double>::epsilon());
        if (distance > 0)
            tally.worst_share_point = std::max(tally.worst_share_point, distance / p.error);
    }
    tally.report("triangle");
}

TEST_F(Oracle, Frustum) {
    Tally tally;
    Tally caps;
    for (int i = 0; i < rays(); ++i) {
        FrustumSolid<double> f;
        f.small_end = direction() * decade(-2, 2);
        f.axis = i % 3 == 0 ? Vec3d(0, 1, 0) : direction();
        f.tilted = i % 3 != 0;
        f.height = decade(-2, 2);
        f.large_end = f.small_end + f.height * f.axis;
        f.radius = i % 4 == 0 ? 0 : decade(-3, 1);
        f.slope = i % 2 == 0 ? decade(-2, 0.5) : (f.radius > 0 ? 0 : 0.5);
        f.capped = true;
        const double size = std::max(f.height, f.radius + f.slope * f.height);
        const Vec3d middle = f.small_end + (f.height / 2) * f.axis;
        const Ray<double> ray = ray_at(middle, size);
        const ExactVec w = unit_length(exact(f.axis));
        const ExactVec start = exact(ray.origin) - exact(f.small_end);
        const ExactVec d = exact(ray.dir);
        const Exact sa = dot(w, start);
        const Exact da = dot(w, d);
        const ExactVec sp = start - sa * w;
        const ExactVec dp = d - da * w;
        const Exact radius = Exact(f.radius) + Exact(f.slope) * sa;
        const Exact rate = Exact(f.slope) * da;
        const Exact qa = dot(dp, dp) - rate * rate;
        const Exact qb = dot(sp, dp) - radius * rate;
        const Exact qc = dot(sp, sp) - radius * radius;
        const Exact square = qb * qb - qa * qc;
        crossings(f, ray, Known{}, [&](const Crossing<double>& c) {
            if (c.face == frustum_face::mantle) {
                const Exact root = square > 0 ? Exact(sqrt(square)) : Exact(0);
                const Exact t0 = (-qb - root) / qa;
                const Exact t1 = (-qb + root) / qa;
                const Exact t = abs(t0 - c.t) < abs(t1 - c.t) ? t0 : t1;
                tally.hit(ray, c, t, size);
            } else {
                const bool small = c.face == frustum_face::small_cap;
                const ExactVec end = exact(small ? f.small_end : f.large_end);
                caps.hit(ray, c, dot(w, end - exact(ray.origin)) / da, size);
            }
        });
    }
    tally.report("cylinder and cone, mantle");
    caps.report("cylinder and cone, caps");
}

}  // namespace
}  // namespace lancer
