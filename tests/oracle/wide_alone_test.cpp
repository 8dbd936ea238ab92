// One of eight rays in the space of a mesh compared with the scalar methods: the same numbers.
#include "tests/oracle/wide_kernels.h"
#include "tests/oracle/wide_levels.h"
#include "tests/oracle/wide_rays.h"
#include "tracer/bvh/slabs.h"
#include "tracer/rays/frame.h"
#include "tracer/shapes/triangle.h"

namespace lancer::oracle {
namespace {

/// A frame, in both forms.
struct Place {
    Frame<double> frame;
    wide::Mesh mesh{};

    Place(Draw& draw, wide::MeshShape& shape) {
        for (Vec3d& row : frame.to_world.rows) row = draw.direction() * draw.decade(-2, 2);
        frame.keeps_digits = draw.number() % 4 == 0;
        if (frame.keeps_digits) frame.to_world.rows = Affine<double>{}.rows;
        if (draw.number() % 5 != 0) frame.to_world.shift = draw.direction() * draw.decade(-2, 2);
        frame.linear_inverse = inverse(frame.to_world);
        frame.norm = frame.inverse_norm = draw.decade(-1, 1);
        frame.transform_error = draw.decade(-18, -10);
        put(frame.to_world.shift, mesh.shift);
        for (std::size_t i = 0; i < 3; ++i) {
            mesh.inverse_x[i] = frame.linear_inverse.rows[i].x;
            mesh.inverse_y[i] = frame.linear_inverse.rows[i].y;
            mesh.inverse_z[i] = frame.linear_inverse.rows[i].z;
        }
        mesh.inverse_norm = frame.inverse_norm;
        mesh.transform_error = frame.transform_error;
        mesh.keeps_digits = frame.keeps_digits;
        mesh.shape = &shape;
    }
};

TEST(OracleWide, RaysAlone) {
    on_each_level([](const WideKernels& kernels) {
        std::size_t met = 0;
        Tally("rays in a mesh's space, alone").run([&](Draw& draw) {
            wide::MeshShape shape{};
            const Place place(draw, shape);
            const Vec3d middle = draw.direction() * draw.decade(-2, 1);
            const Bounds<double> bounds =
                widened(around(middle, Vec3d(1, 0.7, draw.number() % 7 == 0 ? 0 : 0.3)));
            put(bounds.min, shape.tree.min);
            put(bounds.max, shape.tree.max);
            const Vec3d target = map_point(place.frame.to_world, middle);
            const Eight rays(draw, [&](Draw& own) {
                return own.ray_at(target, 0.3 * lancer::length(place.frame.to_world.rows[0]));
            });
            const double limit = some_limit(draw, 1);
            wide::LaneRay local[lanes];
            WideSlabs slabs[lanes];
            kernels.alone(place.mesh, rays.lane_rays.data(), limit, local, slabs);
            for (std::size_t i = 0; i < lanes; ++i) {
                const Ray<double> expected = to_local(rays.rays[i], place.frame);
                const wide::LaneRay& r = local[i];
                EXPECT_EQ(r.whole, expected.whole) << "case " << draw.number();
                EXPECT_EQ(r.origin_error, expected.origin_error) << "case " << draw.number();
                for (int a = 0; a < 3; ++a) {
                    EXPECT_EQ(r.origin[a], expected.origin[a]) << "case " << draw.number();
                    EXPECT_EQ(r.origin_lo[a], expected.origin_lo[a]) << "case " << draw.number();
                    EXPECT_EQ(r.dir[a], expected.dir[a]) << "case " << draw.number();
                    EXPECT_EQ(r.inv_dir[a], expected.inv_dir[a]) << "case " << draw.number();
                }
                const BoxRay<double> boxes(bounds, expected, 0, limit);
                ASSERT_EQ(slabs[i].misses, boxes.misses) << "case " << draw.number();
                if (boxes.misses) continue;
                ++met;
                for (int a = 0; a < 3; ++a) {
                    expect_same(slabs[i].enter_origin[a], boxes.slabs[a].enter_origin, draw);
                    expect_same(slabs[i].leave_origin[a], boxes.slabs[a].leave_origin, draw);
                    expect_same(slabs[i].enter_inverse[a], boxes.slabs[a].enter_inverse, draw);
                    expect_same(slabs[i].leave_inverse[a], boxes.slabs[a].leave_inverse, draw);
                }
                expect_same(slabs[i].last, boxes.parameter(limit), draw);
            }
        });
        EXPECT_GT(met, 5000u);
    });
}

/// A leaf of up to four triangles, the only one of a mesh.
struct LeafMesh {
    std::vector<TriangleSheet<double>> triangles;
    wide::TriangleBlock block{};
    wide::Node node{};
    wide::MeshShape shape{};

    explicit LeafMesh(Draw& draw) {
        const auto count = static_cast<std::uint32_t>(1 + draw.number() % 4);
        Bounds<double> bounds;
        for (std::uint32_t k = 0; k < count; ++k) {
            const Vec3d a = draw.direction();
            TriangleSheet<double> t{a, a + draw.direction() * draw.unit(), a + draw.direction()};
            if (k > 0 && draw.number() % 3 == 0) {  // shares an edge with the one before
                t.a = triangles.back().b;
                t.b = triangles.back().a;
            }
            triangles.push_back(t);
            for (int axis = 0; axis < 3; ++axis) {
                block.corner[0][axis][k] = t.a[axis];
                block.corner[1][axis][k] = t.b[axis];
                block.corner[2][axis][k] = t.c[axis];
            }
            block.face[k] = k;
            for (const Vec3d& corner : {t.a, t.b, t.c}) bounds.extend(corner);
        }
        bounds = widened(bounds);
        for (int axis = 0; axis < 3; ++axis) {
            node.min[axis][0] = clearly_below(bounds.min[axis]);
            node.max[axis][0] = clearly_above(bounds.max[axis]);
        }
        for (std::uint32_t& child : node.child) child = wide::nothing;
        node.child[0] = 0;
        node.count[0] = count;
        shape.tree.nodes = &node;
        shape.tree.node_count = 1;
        put(bounds.min, shape.tree.min);
        put(bounds.max, shape.tree.max);
        shape.leaves = &block;
        shape.reach = bounds.reach();
    }
};

struct FaceHit {
    TriangleHit<double> hit;
    std::uint32_t face;
};

TEST(OracleWide, TrianglesOfALeafForOneRay) {
    on_each_level([](const WideKernels& kernels) {
        std::size_t hits = 0, hidden = 0, unsure = 0;
        Tally("leaf of triangles, alone").run([&](Draw& draw) {
            LeafMesh leaf(draw);
            const Place place(draw, leaf.shape);
            const TriangleSheet<double>& aim = leaf.triangles.back();
            const Eight rays(draw, [&](Draw& own) {
                // Into the triangle, or to an edge of it.
                const double u = own.unit();
                const double v = own.number() % 3 == 0 ? 1 - u : (1 - u) * own.unit();
                const Vec3d local = aim.a + u * (aim.b - aim.a) + v * (aim.c - aim.a);
                const Vec3d target = map_point(place.frame.to_world, local);
                const Vec3d from = target + own.direction() * own.decade(-3, 3);
                return make_ray(from, Vec3d(0), normalize(target - from), 0.0);
            });
            const double limit = some_limit(draw, 1);
            WideAnswer answers[lanes], shadows[lanes];
            kernels.lone_mesh(place.mesh, rays.lane_rays.data(), limit, answers, shadows);
            for (std::size_t i = 0; i < lanes; ++i) {
                const Ray<double> ray = to_local(rays.rays[i], place.frame);
                const auto last = [&] { return limit; };
                const RayInterval<double, decltype(last)> interval{-infinity, last};
                Shear<double> shear = shear_of(ray);
                shear.noise = edge_noise(ray, leaf.shape.reach);
                std::vector<FaceHit> found;
                bool blocks = false;
                for (std::uint32_t k = 0; k < leaf.triangles.size(); ++k) {
                    FaceHit f{{}, k};
                    if (!intersect(leaf.triangles[k], ray, shear, interval, f.hit)) continue;
                    blocks |= f.hit.t > f.hit.error && f.hit.t < limit - f.hit.error;
                    if (f.hit.t > f.hit.error) found.push_back(f);
                }
                if (!shadows[i].unsure) {
                    EXPECT_EQ(shadows[i].hit, blocks) << "case " << draw.number();
                    hidden += blocks;
                }
                unsure += answers[i].unsure;
                if (answers[i].unsure) continue;
                ASSERT_EQ(answers[i].hit, !found.empty()) << "case " << draw.number();
                if (found.empty()) continue;
                ++hits;
                std::sort(found.begin(), found.end(),
                          [](const auto& a, const auto& b) { return a.hit.t < b.hit.t; });
                const FaceHit& first = found.front();
                EXPECT_EQ(answers[i].t, first.hit.t) << "case " << draw.number();
                EXPECT_EQ(answers[i].error, first.hit.error) << "case " << draw.number();
                EXPECT_EQ(answers[i].u, first.hit.u) << "case " << draw.number();
                EXPECT_EQ(answers[i].v, first.hit.v) << "case " << draw.number();
                EXPECT_EQ(answers[i].face, first.face) << "case " << draw.number();
                EXPECT_EQ(answers[i].entering, first.hit.entering) << "case " << draw.number();
                if (found.size() > 1) {
                    EXPECT_GT(found[1].hit.t, first.hit.t + 8 * first.hit.error)
                        << "case " << draw.number();
                }
            }
        });
        EXPECT_GT(hits, 20000u);
        EXPECT_GT(hidden, 10000u);
        EXPECT_LT(unsure, 40000u);
    });
}

}  // namespace
}  // namespace lancer::oracle
