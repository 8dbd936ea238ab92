// Rays side by side compared with the scalar methods, which are proved and tested against 256-bit
// arithmetic: where wide code is sure, it gives the same bits.
#include <bit>

#include "model/elementary.h"
#include "tests/oracle/tally.h"
#include "tests/oracle/wide_checks.h"
#include "tests/oracle/wide_kernels.h"
#include "tests/oracle/wide_levels.h"
#include "tests/oracle/wide_rays.h"
#include "tracer/bvh/slabs.h"
#include "tracer/rays/frame.h"
#include "tracer/shapes/box.h"
#include "tracer/shapes/frustum.h"
#include "tracer/shapes/plane.h"
#include "tracer/shapes/sphere.h"
#include "tracer/shapes/triangle.h"
#include "tracer/wide/flat_frustums.h"

namespace lancer::oracle {
namespace {

using lancer::cross;

struct BallCase {
    BallSolid<double> ball;
    wide::Ball wide;
    Eight rays;
    double limit;

    explicit BallCase(Draw& draw) : BallCase(draw, draw.direction() * draw.decade(-2, 2)) {}

  private:
    BallCase(Draw& draw, const Vec3d& center)
        : ball{center, draw.decade(-3, 3), draw.number() % 5 == 2 ? draw.decade(-18, -8) : 0},
          rays(draw,
               [&](Draw& own) {
                   const Ray<double> ray = own.ray_at(center, ball.radius);
                   if (own.number() % 4 != 1) return ray;
                   // Nearly touches.
                   const Vec3d edge = normalize(cross(ray.dir, own.direction()));
                   const double reach = ball.radius * (1 - own.decade(-17, -1));
                   return make_ray(
                       center + edge * reach - ray.dir * (ball.radius * own.decade(0, 4)), Vec3d(0),
                       ray.dir, 0.0);
               }),
          limit(some_limit(draw, ball.radius)) {
        put(ball.center, wide.center);
        wide.radius = ball.radius;
        wide.transform_error = ball.transform_error;
        wide.filter_error = ball.filter_error;
    }
};

TEST(OracleWide, Ball) {
    on_each_level([](const WideKernels& kernels) {
        Share nearest, shadow;
        Tally("sphere, side by side").run([&](Draw& draw) {
            const BallCase c(draw);
            WideAnswer answers[lanes];
            kernels.ball(c.wide, c.rays.lane_rays.data(), c.limit, answers);
            for (std::size_t i = 0; i < lanes; ++i)
                check_nearest(crossings_to(c.ball, c.rays.rays[i], c.limit), answers[i], draw,
                              nearest);
            kernels.ball_shadow(c.wide, c.rays.lane_rays.data(), c.limit, answers);
            for (std::size_t i = 0; i < lanes; ++i)
                check_shadow(c.ball, c.rays.rays[i], c.limit, answers[i], draw, shadow);
        });
        nearest.expect(0.7);  // a third starts in or next to the ball, a quarter is nearly tangent
        shadow.expect(0.5);
    });
}

TEST(OracleWide, FromABall) {
    on_each_level([](const WideKernels& kernels) {
        Tally("sphere from its surface, side by side").run([&](Draw& draw) {
            const BallCase c(draw);
            WideAnswer answers[lanes];
            kernels.from_ball(c.wide, c.rays.lane_rays.data(), answers);
            for (std::size_t i = 0; i < lanes; ++i) {
                std::vector<Crossing<double>> found;
                IntersectionHints hints;
                hints.start_face = 0;
                crossings(c.ball, c.rays.rays[i], hints, whole_line<double>(),
                          [&](const Crossing<double>& other) { found.push_back(other); });
                ASSERT_EQ(found.size(), 1U);
                EXPECT_EQ(answers[i].t, found[0].t) << "case " << draw.number();
                EXPECT_EQ(answers[i].error, found[0].error) << "case " << draw.number();
            }
        });
    });
}

TEST(OracleWide, Box) {
    on_each_level([](const WideKernels& kernels) {
        Share nearest, shadow;
        Tally("box, side by side").run([&](Draw& draw) {
            const Vec3d min = draw.direction() * draw.decade(-2, 2);
            const double size = draw.decade(-3, 3);
            const double flat = draw.number() % 7 == 3 ? 0 : size / 2;
            const BoxSolid<double> box{min, min + Vec3d(size, flat, size * draw.unit()),
                                       draw.number() % 5 == 2 ? draw.decade(-18, -8) : 0};
            wide::Box wide_box{};
            put(box.min, wide_box.min);
            put(box.max, wide_box.max);
            wide_box.transform_error = box.transform_error;
            const Eight rays(draw, [&](Draw& own) {
                const Ray<double> ray = own.ray_at((box.min + box.max) / 2.0, size);
                if (own.number() % 4 != 1) return ray;
                return make_ray(box.max - ray.dir * size, Vec3d(0), ray.dir, 0.0);  // at a corner
            });
            const double limit = some_limit(draw, size);
            WideAnswer answers[lanes];
            kernels.box(wide_box, rays.lane_rays.data(), limit, answers);
            for (std::size_t i = 0; i < lanes; ++i)
                check_nearest(crossings_to(box, rays.rays[i], limit), answers[i], draw, nearest);
            kernels.box_shadow(wide_box, rays.lane_rays.data(), limit, answers);
            for (std::size_t i = 0; i < lanes; ++i)
                check_shadow(box, rays.rays[i], limit, answers[i], draw, shadow);
        });
        nearest.expect(0.2);
        shadow.expect(0.2);
    });
}

TEST(OracleWide, CylinderAndCone) {
    on_each_level([](const WideKernels& kernels) {
        Share nearest, shadow;
        Tally("cylinder and cone, side by side").run([&](Draw& draw) {
            FrustumSolid<double> f;
            f.small_end = draw.direction() * draw.decade(-2, 2);
            f.tilted = draw.number() % 3 != 0;
            f.axis = f.tilted ? draw.direction() : Vec3d(0, 1, 0);
            f.height = draw.decade(-2, 2);
            f.large_end = f.small_end + f.height * f.axis;
            f.radius = draw.number() % 4 == 0 ? 0 : draw.decade(-3, 1);
            f.slope = draw.number() % 2 == 0 ? draw.decade(-3, 2) : (f.radius > 0 ? 0 : 0.5);
            f.capped = draw.number() % 7 != 0;
            f.transform_error = draw.number() % 5 == 2 ? draw.decade(-18, -8) : 0;
            f.filter_error = f.transform_error + filter_error_of(f.small_end);
            const wide::Frustum frustum = wide::flat_frustum(f);
            const wide::Ball around = wide::ball_around(f);
            const double size = std::max(f.height, f.radius + f.slope * f.height);
            const Vec3d middle = f.small_end + (f.height / 2) * f.axis;
            const Eight rays(draw, [&](Draw& own) {
                const Ray<double> ray = own.ray_at(middle, size);
                if (own.number() % 4 != 1) return ray;
                // Nearly touches the side.
                const Vec3d out = normalize(cross(f.axis, own.direction()));
                const double axial = f.height * own.unit();
                const double reach = (f.radius + f.slope * axial) * (1 - own.decade(-17, -1));
                const Vec3d along = normalize(cross(out - f.slope * f.axis, own.direction()));
                return make_ray(f.small_end + axial * f.axis + reach * out - along * size, Vec3d(0),
                                along, 0.0);
            });
            const double distance = some_limit(draw, size);
            WideAnswer answers[lanes];
            kernels.frustum(around, frustum, rays.lane_rays.data(), distance, answers);
            for (std::size_t i = 0; i < lanes; ++i)
                check_nearest(crossings_to(f, rays.rays[i], distance), answers[i], draw, nearest);
            kernels.frustum_shadow(around, frustum, rays.lane_rays.data(), distance, answers);
            for (std::size_t i = 0; i < lanes; ++i)
                check_shadow(f, rays.rays[i], distance, answers[i], draw, shadow);
        });
        nearest.expect(0.1);
        shadow.expect(0.05);
    });
}

TEST(OracleWide, Plane) {
    on_each_level([](const WideKernels& kernels) {
        Share nearest, shadow;
        Tally("plane, side by side").run([&](Draw& draw) {
            const HalfSpace<double> half{draw.number() % 3 == 0 ? Vec3d(0, 1, 0) : draw.direction(),
                                         draw.direction() * draw.decade(-2, 2),
                                         draw.number() % 5 == 2 ? draw.decade(-18, -8) : 0};
            wide::Plane plane{};
            put(half.normal, plane.normal);
            put(half.point, plane.point);
            plane.transform_error = half.transform_error;
            plane.filter_error = half.filter_error;
            plane.offset = half.offset;
            const Eight rays(draw, [&](Draw& own) { return own.ray_at(half.point, 1); });
            const double limit = some_limit(draw, 1);
            WideAnswer answers[lanes];
            kernels.plane(plane, rays.lane_rays.data(), limit, answers);
            for (std::size_t i = 0; i < lanes; ++i)
                check_nearest(crossings_to(half, rays.rays[i], limit), answers[i], draw, nearest);
            kernels.plane_shadow(plane, rays.lane_rays.data(), limit, answers);
            for (std::size_t i = 0; i < lanes; ++i)
                check_shadow(half, rays.rays[i], limit, answers[i], draw, shadow);
        });
        nearest.expect(0.1);
        shadow.expect(0.1);
    });
}

TEST(OracleWide, Triangle) {
    on_each_level([](const WideKernels& kernels) {
        std::size_t hits = 0;
        Tally("triangle, side by side").run([&](Draw& draw) {
            const Vec3d a = draw.direction() * draw.decade(-2, 2);
            const double size = draw.decade(-2, 2);
            TriangleSheet<double> triangle{a, a + size * draw.direction(),
                                           a + size * draw.direction()};
            if (draw.number() % 4 == 1) triangle.c.y = triangle.b.y = a.y;
            wide::TriangleBlock block{};
            for (int axis = 0; axis < 3; ++axis) {
                block.corner[0][axis][0] = triangle.a[axis];
                block.corner[1][axis][0] = triangle.b[axis];
                block.corner[2][axis][0] = triangle.c[axis];
            }
            const Eight rays(draw, [&](Draw& own) {
                const Ray<double> ray = own.ray_at(a, size);
                if (own.number() % 3 != 0) return ray;
                // At a corner or an edge.
                const double share = own.number() % 2 == 0 ? 0 : own.unit();
                const Vec3d at = triangle.b + share * (triangle.c - triangle.b);
                return make_ray(at - ray.dir * size, Vec3d(0), ray.dir, 0.0);
            });
            const double limit = some_limit(draw, size);
            WideAnswer answers[lanes];
            kernels.triangle(block, triangle.reach(), rays.lane_rays.data(), limit, answers);
            for (std::size_t i = 0; i < lanes; ++i) {
                const Ray<double>& ray = rays.rays[i];
                const auto last = [&] { return limit; };
                const RayInterval<double, decltype(last)> interval{-infinity, last};
                TriangleHit<double> hit;
                Shear<double> shear = shear_of(ray);
                shear.noise = edge_noise(ray, triangle.reach());
                const bool found = intersect(triangle, ray, shear, interval, hit);
                EXPECT_FALSE(answers[i].unsure) << "case " << draw.number();
                ASSERT_EQ(answers[i].hit, found) << "case " << draw.number();
                if (!found) continue;
                ++hits;
                EXPECT_EQ(answers[i].t, hit.t) << "case " << draw.number();
                EXPECT_EQ(answers[i].error, hit.error) << "case " << draw.number();
                EXPECT_EQ(answers[i].u, hit.u) << "case " << draw.number();
                EXPECT_EQ(answers[i].v, hit.v) << "case " << draw.number();
                EXPECT_EQ(answers[i].entering, hit.entering) << "case " << draw.number();
            }
        });
        EXPECT_GT(hits, 5000u);
    });
}

TEST(OracleWide, Slabs) {
    on_each_level([](const WideKernels& kernels) {
        std::size_t met = 0, passed = 0;
        Tally("boxes, side by side").run([&](Draw& draw) {
            const Vec3d center = draw.direction() * draw.decade(-2, 2);
            const double size = draw.decade(-3, 2);
            const Bounds<double> box = widened(around(center, Vec3d(size, size / 2, size / 3)));
            Bounds<double> bounds = box;
            bounds.extend(center + draw.direction() * (size * draw.decade(0, 2)));
            bounds = widened(bounds);
            wide::Node node{};
            wide::Tree tree{&node, 1, {}, {}};
            put(bounds.min, tree.min);
            put(bounds.max, tree.max);
            for (int a = 0; a < 3; ++a) {
                node.min[a][0] = clearly_below(box.min[a]);
                node.max[a][0] = clearly_above(box.max[a]);
            }
            const Eight rays(draw, [&](Draw& own) { return own.ray_at(center, size); });
            const double limit = some_limit(draw, size);
            WideSlabs answers[lanes];
            kernels.slabs(tree, rays.lane_rays.data(), limit, answers);
            for (std::size_t i = 0; i < lanes; ++i) {
                const Ray<double>& ray = rays.rays[i];
                const BoxRay<double> expected(bounds, ray, 0, limit);
                const WideSlabs& answer = answers[i];
                ASSERT_EQ(answer.misses, expected.misses) << "case " << draw.number();
                // The place where the ray meets the box, by exact arithmetic: the middle of its
                // part inside.
                Exact in = 0, out = limit == infinity ? Exact(1e300) : Exact(limit);
                for (int a = 0; a < 3; ++a) {
                    const Exact d(ray.dir[a]);
                    const Exact o = Exact(ray.origin[a]) + Exact(ray.origin_lo[a]);
                    if (d == 0) {
                        if (o < box.min[a] || o > box.max[a]) out = -1;
                        continue;
                    }
                    const Exact t0 = (Exact(box.min[a]) - o) / d;
                    const Exact t1 = (Exact(box.max[a]) - o) / d;
                    in = std::max(in, std::min(t0, t1));
                    out = std::min(out, std::max(t0, t1));
                }
                const bool may = !answer.misses && answer.met;
                EXPECT_TRUE(may || in > out) << "case " << draw.number() << ": shut out";
                (may ? met : passed) += 1;
                if (answer.misses) continue;
                for (int a = 0; a < 3; ++a) {
                    expect_same(answer.enter_origin[a], expected.slabs[a].enter_origin, draw);
                    expect_same(answer.leave_origin[a], expected.slabs[a].leave_origin, draw);
                    expect_same(answer.enter_inverse[a], expected.slabs[a].enter_inverse, draw);
                    expect_same(answer.leave_inverse[a], expected.slabs[a].leave_inverse, draw);
                }
                expect_same(answer.last, expected.parameter(limit), draw);
            }
        });
        EXPECT_GT(met, 1000u);
        EXPECT_GT(passed, 1000u);
    });
}

TEST(OracleWide, Frame) {
    on_each_level([](const WideKernels& kernels) {
        Tally("rays in frames, side by side").run([&](Draw& draw) {
            Frame<double> f;
            for (Vec3d& row : f.to_world.rows) row = draw.direction() * draw.decade(-2, 2);
            f.keeps_digits = draw.number() % 4 == 0;
            if (f.keeps_digits) f.to_world.rows = Affine<double>{}.rows;
            f.to_world.shift = draw.direction() * draw.decade(-2, 2);
            f.linear_inverse = inverse(f.to_world);
            f.norm = f.inverse_norm = draw.decade(-1, 1);
            f.transform_error = draw.decade(-18, -10);
            wide::Frame frame{};
            for (std::size_t i = 0; i < 3; ++i)
                put(f.linear_inverse.rows[i], frame.linear_inverse[i]);
            put(f.to_world.shift, frame.shift);
            frame.inverse_norm = f.inverse_norm;
            frame.transform_error = f.transform_error;
            frame.keeps_digits = f.keeps_digits;
            const Eight rays(draw, [&](Draw& own) { return own.ray_at(f.to_world.shift, 1); });
            wide::LaneRay answers[lanes];
            kernels.local(frame, rays.lane_rays.data(), answers);
            for (std::size_t i = 0; i < lanes; ++i) {
                const Ray<double> expected = to_local(rays.rays[i], f);
                const wide::LaneRay& r = answers[i];
                EXPECT_EQ(r.whole, expected.whole);
                EXPECT_EQ(r.origin_error, expected.origin_error);
                EXPECT_EQ(r.filter_error, expected.filter_error);
                EXPECT_EQ(r.inv_squared, expected.inv_squared);
                for (int a = 0; a < 3; ++a) {
                    EXPECT_EQ(r.origin[a], expected.origin[a]) << "case " << draw.number();
                    EXPECT_EQ(r.origin_lo[a], expected.origin_lo[a]) << "case " << draw.number();
                    EXPECT_EQ(r.dir[a], expected.dir[a]) << "case " << draw.number();
                    EXPECT_EQ(r.inv_dir[a], expected.inv_dir[a]) << "case " << draw.number();
                }
            }
        });
    });
}

}  // namespace
}  // namespace lancer::oracle
