// Spheres, boxes, planes, triangles, cylinders and cones compared with 256-bit arithmetic: the
// errors of t, the point and the normal, whether the error bound that the kernel reports with t
// holds, and whether no crossing is missed.
#include "tests/oracle/tally.h"
#include "tracer/rays/crossing.h"
#include "tracer/rays/shear.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/box.h"
#include "tracer/shapes/frustum.h"
#include "tracer/shapes/plane.h"
#include "tracer/shapes/sphere.h"
#include "tracer/shapes/triangle.h"

namespace lancer::oracle {
namespace {

using lancer::cross;
using lancer::dot;
using lancer::length;

TEST(Oracle, Sphere) {
    Tally tally("sphere");
    tally.run([&](Draw& draw) {
        const BallSolid<double> ball{draw.direction() * draw.decade(-2, 2), draw.decade(-3, 3)};
        Ray<double> ray = draw.ray_at(ball.center, ball.radius);
        if (draw.number() % 2 == 1) {  // nearly touches
            const Vec3d edge = normalize(cross(ray.dir, draw.direction()));
            const double reach = ball.radius * (1 - draw.decade(-17, -1));
            ray = make_ray(ball.center + edge * reach - ray.dir * (ball.radius * draw.decade(0, 4)),
                           Vec3d(0), ray.dir, 0.0);
        }
        ray = draw.in_two_parts(ray);
        const ExactVec f = exact(ball.center) - start_of(ray);
        const ExactVec d = exact(ray.dir);
        const Exact dd = dot(d, d);
        const Exact b = dot(f, d);
        const Exact rr = Exact(ball.radius) * ball.radius;
        const Exact square = b * b - dd * (dot(f, f) - rr);
        const Exact root = square > 0 ? Exact(sqrt(square)) : Exact(0);
        int found = 0;
        crossings(ball, ray, IntersectionHints{}, whole_line<double>(),
                  [&](const Crossing<double>& c) {
                      ++found;
                      const Exact t = c.entering ? Exact((b - root) / dd) : Exact((b + root) / dd);
                      tally.hit(ray, c, t, ball.radius);
                      const SurfacePoint<double> p = surface_point(ball, ray, c.t, 0);
                      const ExactVec from_center =
                          exact(p.anchor) + exact(p.offset) + exact(p.rest) - exact(ball.center);
                      const ExactVec truth = start_of(ray) + Exact(c.t) * d - exact(ball.center);
                      tally.point(p, length(from_center) - ball.radius, truth, ball.radius);
                  });
        // The kernel's own rounding moves the line by about u |f|, which matters relative to r.
        if (square > Exact(1e-14) * dd * (sqrt(dot(f, f) * rr) + rr))
            tally.expect_found(found == 2);
    });
    tally.report();
}

/// The other root from a start on the sphere, whatever the angle.
TEST(Oracle, SphereFromItsSurface) {
    Tally tally("sphere, from its surface");
    tally.run([&](Draw& draw) {
        const BallSolid<double> ball{draw.direction() * draw.decade(-2, 2), draw.decade(-3, 3)};
        const Vec3d n = draw.direction();
        const DoubleWordVector<double> start = two_sum(ball.center, n * ball.radius);
        Vec3d along = draw.direction();
        if (draw.number() % 2 == 1) along = normalize(cross(n, along)) + n * draw.decade(-16, -1);
        const Ray<double> ray = make_ray(start.hi, start.lo, normalize(along), 0.0);
        const ExactVec f = exact(ball.center) - start_of(ray);
        const Exact t = 2 * dot(f, exact(ray.dir)) / dot(exact(ray.dir), exact(ray.dir));
        crossings(ball, ray, IntersectionHints{0, false}, whole_line<double>(),
                  [&](const Crossing<double>& c) { tally.hit(ray, c, t, ball.radius); });
    });
    tally.report();
}

TEST(Oracle, Box) {
    Tally tally("box");
    tally.run([&](Draw& draw) {
        const Vec3d corner = draw.direction() * draw.decade(-2, 2);
        const Vec3d sides(draw.decade(-3, 1), draw.decade(-3, 1), draw.decade(-3, 1));
        const BoxSolid<double> box{corner, corner + sides};
        const double size = max_component(sides);
        const Ray<double> ray = draw.in_two_parts(draw.ray_at(corner + sides / 2.0, size));
        Exact in = -Exact(std::numeric_limits<double>::max());
        Exact out = std::numeric_limits<double>::max();
        bool beside = false;
        for (int axis = 0; axis < 3; ++axis) {
            const Exact low = Exact(box.min[axis]) - ray.origin[axis] - ray.origin_lo[axis];
            const Exact high = Exact(box.max[axis]) - ray.origin[axis] - ray.origin_lo[axis];
            if (ray.dir[axis] == 0) {
                beside = beside || low > 0 || high < 0;
                continue;
            }
            const Exact a = low / ray.dir[axis];
            const Exact b = high / ray.dir[axis];
            in = std::max(in, std::min(a, b));
            out = std::min(out, std::max(a, b));
        }
        int found = 0;
        crossings(
            box, ray, IntersectionHints{}, whole_line<double>(), [&](const Crossing<double>& c) {
                ++found;
                const int axis = static_cast<int>(c.face / 2);
                const bool at_max = c.face % 2 == 1;
                const double at = at_max ? box.max[axis] : box.min[axis];
                const Exact t =
                    (Exact(at) - ray.origin[axis] - ray.origin_lo[axis]) / ray.dir[axis];
                tally.hit(ray, c, t, size);
                const SurfacePoint<double> p = surface_point(box, ray, c.t, c.face);
                Vec3d normal(0.0);
                normal[axis] = at_max ? 1 : -1;
                tally.point(p, Exact(p.anchor[axis]) + p.offset[axis] - at, exact(normal), size);
            });
        const Exact margin = Exact(1e-13) * std::max(Exact(abs(in)), Exact(abs(out)));
        if (!beside && out - in > margin) tally.expect_found(found == 2);
    });
    tally.report();
}

TEST(Oracle, Plane) {
    Tally tally("plane");
    tally.run([&](Draw& draw) {
        const HalfSpace<double> half{draw.direction(), draw.direction() * draw.decade(-2, 2)};
        Ray<double> ray = draw.ray_at(half.point, 1);
        if (draw.number() % 2 == 1) {  // grazing
            const Vec3d along = normalize(cross(half.normal, draw.direction()));
            ray = make_ray(ray.origin, Vec3d(0),
                           normalize(along + half.normal * draw.decade(-12, -1)), 0.0);
        }
        ray = draw.in_two_parts(ray);
        const ExactVec n = exact(half.normal);
        const Exact t = dot(n, exact(half.point) - start_of(ray)) / dot(n, exact(ray.dir));
        // A query that ends around the crossing.
        const double end = static_cast<double>(t) * (1 + draw.between(-1, 1) * draw.decade(-15, 0));
        const auto last = [&] { return end; };
        bool found = false;
        double bound = 0;
        crossings(half, ray, IntersectionHints{}, RayInterval<double, decltype(last)>{0, last},
                  [&](const Crossing<double>&) { found = true; });
        crossings(half, ray, IntersectionHints{}, whole_line<double>(),
                  [&](const Crossing<double>& c) {
                      bound = c.error;
                      tally.hit(ray, c, t, 1);
                      const SurfacePoint<double> p = surface_point(half, ray, c.t, 0);
                      const ExactVec rel = exact(p.anchor) + exact(p.offset) - exact(half.point);
                      // The possible error of the point grows with its distance from the plane's
                      // reference point.
                      const double reach = std::max(1.0, static_cast<double>(length(rel)));
                      tally.point(p, dot(n, rel) / length(n), n, reach);
                  });
        if (t > 0 && t + bound < end) tally.expect_found(found);
    });
    tally.report();
}

TEST(Oracle, Triangle) {
    Tally tally("triangle");
    tally.run([&](Draw& draw) {
        const double size = draw.decade(-3, 2);
        const double flat = draw.number() % 2 == 1 ? draw.decade(-8, 0) : 1;  // needles
        const Vec3d a = draw.direction() * draw.decade(-2, 2);
        const Vec3d b = a + draw.direction() * size;
        const Vec3d c3 = a + (b - a) * draw.unit() + draw.direction() * (size * flat);
        const TriangleSheet<double> triangle{a, b, c3};
        const double u = draw.unit();
        const double v = draw.unit() * (1 - u);
        const Vec3d target = a + u * (b - a) + v * (c3 - a);
        const Vec3d from = target + draw.direction() * (size * draw.decade(-3, 4));
        const Ray<double> ray =
            draw.in_two_parts(make_ray(from, Vec3d(0), normalize(target - from), 0.0));
        TriangleHit<double> hit;
        Shear<double> shear = shear_of(ray);
        shear.noise = edge_noise(ray, triangle.reach());
        const bool found = intersect(triangle, ray, shear, whole_line<double>(), hit);
        const ExactVec n = cross(exact(b) - exact(a), exact(c3) - exact(a));
        const ExactVec d = exact(ray.dir);
        const Exact t = dot(n, exact(a) - start_of(ray)) / dot(n, d);
        // Weights by volumes of the ray with the edges: all of one sign inside.
        const auto volume = [&](const Vec3d& p, const Vec3d& q) {
            return dot(d, cross(exact(p) - start_of(ray), exact(q) - start_of(ray)));
        };
        const Exact w[] = {volume(b, c3), volume(c3, a), volume(a, b)};
        const bool inside =
            (w[0] > 0 && w[1] > 0 && w[2] > 0) || (w[0] < 0 && w[1] < 0 && w[2] < 0);
        const double reach = std::max(size, length(from - target));
        const Exact least = std::min({Exact(abs(w[0])), Exact(abs(w[1])), Exact(abs(w[2]))});
        if (inside && least > Exact(1e-13) * reach * reach) tally.expect_found(found);
        if (!found) return;
        tally.hit(ray, {hit.t, hit.error, 0, hit.entering}, t, size);
        const SurfacePoint<double> p = triangle_point(triangle, hit.u, hit.v);
        const ExactVec rel = exact(p.anchor) + exact(p.offset) - exact(a);
        tally.point(p, dot(unit_of(n), rel), n, size);
    });
    tally.report();
}

FrustumSolid<double> random_frustum(Draw& draw) {
    FrustumSolid<double> f;
    f.small_end = draw.direction() * draw.decade(-2, 2);
    f.tilted = draw.number() % 3 != 0;
    f.axis = f.tilted ? draw.direction() : Vec3d(0, 1, 0);
    f.height = draw.decade(-2, 2);
    f.large_end = f.small_end + f.height * f.axis;
    f.radius = draw.number() % 4 == 0 ? 0 : draw.decade(-3, 1);
    f.slope = draw.number() % 2 == 0 ? draw.decade(-2, 0.5) : (f.radius > 0 ? 0 : 0.5);
    f.capped = true;
    f.filter_error = filter_error_of(f.small_end);
    return f;
}
double whole_size(const FrustumSolid<double>& f) {
    return std::max(f.height, f.radius + f.slope * f.height);
}

/// A line meets the side where qa t^2 + 2 qb t + qc = 0, as in side_span().
struct ExactMantle {
    ExactVec w;      ///< the axis, truly unit
    ExactVec start;  ///< relative to the smaller end
    Exact sa, da;    ///< axial parts of start and direction
    Exact qa, qb, qc;

    ExactMantle(const FrustumSolid<double>& f, const Ray<double>& ray)
        : w(unit_of(exact(f.axis))), start(start_of(ray) - exact(f.small_end)) {
        const ExactVec d = exact(ray.dir);
        sa = dot(w, start);
        da = dot(w, d);
        const ExactVec sp = start - sa * w;
        const ExactVec dp = d - da * w;
        const Exact radius = Exact(f.radius) + Exact(f.slope) * sa;
        const Exact rate = Exact(f.slope) * da;
        qa = dot(dp, dp) - rate * rate;
        qb = dot(sp, dp) - radius * rate;
        qc = dot(sp, sp) - radius * radius;
    }
};

TEST(Oracle, CylinderAndCone) {
    Tally side("cylinder and cone, side");
    Tally caps("cylinder and cone, caps");
    side.run([&](Draw& draw) {
        caps.at(draw);
        const FrustumSolid<double> f = random_frustum(draw);
        const double size = whole_size(f);
        const Ray<double> ray =
            draw.in_two_parts(draw.ray_at(f.small_end + (f.height / 2) * f.axis, size));
        const ExactMantle exactly(f, ray);
        const ExactVec& w = exactly.w;
        const ExactVec& start = exactly.start;
        const Exact& sa = exactly.sa;
        const Exact& da = exactly.da;
        const Exact& qa = exactly.qa;
        const Exact& qb = exactly.qb;
        const ExactVec d = exact(ray.dir);
        const Exact square = qb * qb - qa * exactly.qc;
        const Exact root = square > 0 ? Exact(sqrt(square)) : Exact(0);
        const Exact t0 = (-qb - root) / qa;
        const Exact t1 = (-qb + root) / qa;
        int found = 0;
        crossings(
            f, ray, IntersectionHints{}, whole_line<double>(), [&](const Crossing<double>& c) {
                ++found;
                const SurfacePoint<double> p = surface_point(f, ray, c.t, c.face);
                const ExactVec rel = exact(p.anchor) + exact(p.offset) - exact(f.small_end);
                const ExactVec radial = rel - dot(w, rel) * w;
                if (c.face == frustum_face::side) {
                    side.hit(ray, c, abs(t0 - c.t) < abs(t1 - c.t) ? t0 : t1, size);
                    const Exact distance = length(radial);
                    if (!(distance > Exact(1e-3) * f.radius)) return;
                    const Exact off = distance - (Exact(f.radius) + Exact(f.slope) * dot(w, rel));
                    const Exact steep = sqrt(1 + Exact(f.slope) * f.slope);
                    const ExactVec at = start + Exact(c.t) * d;
                    const ExactVec out = unit_of(at - dot(w, at) * w) - Exact(f.slope) * w;
                    side.point(p, off / steep, out, size);
                } else {
                    const bool small = c.face == frustum_face::small_cap;
                    const ExactVec end = exact(small ? f.small_end : f.large_end);
                    caps.hit(ray, c, dot(w, end - start_of(ray)) / da, size);
                    const ExactVec from_end = exact(p.anchor) + exact(p.offset) - end;
                    caps.point(p, dot(w, from_end), Exact(small ? -1 : 1) * w, size);
                }
            });
        if (!(qa > Exact(1e-12)) || da == 0 || !(square > 0)) return;
        const Exact low = -sa / da;
        const Exact high = (dot(w, exact(f.large_end) - exact(f.small_end)) - sa) / da;
        const Exact in = std::max(t0, std::min(low, high));
        const Exact out = std::min(t1, std::max(low, high));
        const Exact far = std::max({Exact(abs(in)), Exact(abs(out)), Exact(size)});
        const bool certain = square > Exact(1e-11) * far * far && out - in > Exact(1e-7) * far;
        if (certain) side.expect_found(found == 2);
    });
    side.report();
    caps.report();
}

/// The other root from a start on the side, whatever the angle.
TEST(Oracle, CylinderAndConeFromTheMantle) {
    Tally tally("cylinder and cone, from the side");
    tally.run([&](Draw& draw) {
        const FrustumSolid<double> f = random_frustum(draw);
        const Vec3d outward = normalize(cross(f.axis, draw.direction()));
        const double axial = f.height * draw.unit();
        const DoubleWordVector<double> start =
            two_sum(f.small_end, axial * f.axis + (f.radius + f.slope * axial) * outward);
        Vec3d along = draw.direction();
        if (draw.number() % 5 < 2)
            along = normalize(cross(outward, along)) + outward * draw.decade(-16, -1);
        const Ray<double> ray = make_ray(start.hi, start.lo, normalize(along), 0.0);
        const ExactMantle exactly(f, ray);
        const Exact t = -2 * exactly.qb / exactly.qa;
        crossings(f, ray, IntersectionHints{frustum_face::side, false}, whole_line<double>(),
                  [&](const Crossing<double>& c) {
                      if (c.face == frustum_face::side) tally.hit(ray, c, t, whole_size(f));
                  });
    });
    tally.report();
}

}  // namespace
}  // namespace lancer::oracle
