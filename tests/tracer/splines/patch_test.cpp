// Rays that meet patches on their true surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "model/patch_net.h"
#include "tests/tracer/splines/random_patch.h"
#include "tracer/rays/crossing.h"
#include "tracer/rays/surface_point.h"
#include "tracer/render.h"
#include "tracer/shapes/bicubic.h"
#include "tracer/tessellation/tessellate.h"

namespace lancer {
namespace {

using Wide = long double;

template <class Real>
splines::Bicubic<Real> points(const Patch& patch) {
    const BezierPatch p = bezier_net(patch).patch(0, 0);
    splines::Bicubic<Real> q;
    for (std::size_t i = 0; i < 16; ++i) q[i] = convert<Real>(p[i]);
    return q;
}

struct Met {
    double t;
    double error;
    SurfacePoint<double> point;
};

std::vector<Met> meetings(const BicubicSurface<double>& surface, const Ray<double>& ray) {
    std::vector<Met> met;
    const BicubicSolid<double> solid{&surface};
    crossings(solid, ray, IntersectionHints{}, whole_line<double>(),
              [&](const Crossing<double>& c, double u, double v) {
                  met.push_back({c.t, c.error, bicubic_point(solid, c.face, u, v)});
                  return false;
              });
    return met;
}

TEST(TruePatch, EveryPointOfTheSurfaceIsMetByEveryRayToIt) {
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> share(0, 1);
    std::normal_distribution<double> normal;
    for (unsigned seed = 0; seed < 12; ++seed) {
        for (const double factor : {1.0, 1e9, 1e-9, 1e90, 1e-90}) {
            if (factor != 1 && seed > 3) continue;
            const Patch patch = random_patch(seed, factor, seed % 3);
            const auto exact = points<Wide>(patch);
            // As compile does, the patch is traced at a size near 1.
            const int exponent = -std::ilogb(factor);
            const BicubicSurface<double> surface(patch, exponent);
            for (int i = 0; i < 400; ++i) {
                // Also on the border, where a neighbour would be.
                const auto at = [&](int kind) {
                    return kind == 0 ? 0.0 : kind == 1 ? 1.0 : share(generator);
                };
                const double u = at(i % 5);
                const double v = at(i % 7);
                const Vec3<Wide> target =
                    std::ldexp(Wide(1), exponent) *
                    splines::sample(exact, splines::Place<Wide>(u), splines::Place<Wide>(v)).point;
                const Vec3d from(3 * normal(generator), 3 * normal(generator),
                                 3 * normal(generator));
                const Vec3<Wide> way = target - convert<Wide>(from);
                const Wide distance = length(way);
                const Ray<double> ray =
                    make_ray(from, Vec3d(0), convert<double>(way / distance), 0.0);
                Wide nearest = std::numeric_limits<Wide>::infinity();
                for (const Met& met : meetings(surface, ray)) {
                    const Wide off = std::abs(met.t - distance);
                    nearest = std::min(nearest, off);
                    const Vec3<Wide> point =
                        convert<Wide>(met.point.anchor) + convert<Wide>(met.point.offset);
                    // The ray's direction is rounded, by an angle of some roundings.
                    const Wide wrong = length(cross(point - convert<Wide>(from), way / distance));
                    EXPECT_LE(wrong, 1e-14L + 8 * met.error) << seed << " " << i;
                    if (off > 2 * met.error + 1e-14L) continue;
                    EXPECT_LE(length(point - target), 1e-14L + 1e3L * met.error);
                }
                // At grazing incidence, the rounding of the direction moves the hit far.
                EXPECT_LE(nearest, 1e-9L) << seed << " " << factor << " " << i;
            }
        }
    }
}

/// Bound on the distance of q from the patch: the best found by Gauss-Newton steps from (u, v).
Wide distance(const splines::Bicubic<Wide>& p, const Vec3<Wide>& q, Wide u, Wide v) {
    Wide best = std::numeric_limits<Wide>::infinity();
    for (int i = 0; i < 4; ++i) {
        const auto s = splines::sample(p, splines::Place<Wide>(u), splines::Place<Wide>(v));
        const Vec3<Wide> d = q - s.point;
        best = std::min(best, length(d));
        const Wide a = dot(s.du, s.du), b = dot(s.du, s.dv), c = dot(s.dv, s.dv);
        const Wide det = a * c - b * b;
        if (!(det > 0)) break;
        const Wide x = dot(s.du, d), y = dot(s.dv, d);
        u = std::clamp<Wide>(u + (c * x - b * y) / det, 0, 1);
        v = std::clamp<Wide>(v + (a * y - b * x) / det, 0, 1);
    }
    return best;
}

TEST(TruePatch, WhatIsMetLiesOnTheSurfaceAndTIsWithinItsBound) {
    std::mt19937 generator(6);
    std::normal_distribution<double> normal;
    int met_at_all = 0;
    for (unsigned seed = 0; seed < 8; ++seed) {
        const Patch patch = random_patch(seed, 1, 1 + seed % 3);
        const auto exact = points<Wide>(patch);
        const BicubicSurface<double> surface(patch, 0);
        for (int i = 0; i < 2000; ++i) {
            const Vec3d from = Vec3d(normal(generator), normal(generator), normal(generator)) * 3.0;
            const Vec3d towards =
                Vec3d(normal(generator), normal(generator), normal(generator)) * 0.4;
            const Ray<double> ray = make_ray(from, Vec3d(0), normalize(towards - from), 0.0);
            for (const Met& met : meetings(surface, ray)) {
                ++met_at_all;
                const Vec3<Wide> point =
                    convert<Wide>(met.point.anchor) + convert<Wide>(met.point.offset);
                const Wide off =
                    distance(exact, point, met.point.parameter.x, met.point.parameter.y);
                EXPECT_LE(off, 1e-14L) << seed << " " << i;
                EXPECT_LE(off, met.point.error) << seed << " " << i;
                const Vec3<Wide> along =
                    convert<Wide>(ray.origin) + Wide(met.t) * convert<Wide>(ray.dir);
                EXPECT_LE(length(along - point), 4 * met.error + 1e-15L) << seed << " " << i;
            }
        }
    }
    EXPECT_GT(met_at_all, 4000);
}

/// Two bent patches with one border curve, the second turned round, and a net of many.
std::vector<Patch> neighbours(bool with_pole) {
    Patch first = random_patch(3, 3, 1);
    Patch second = random_patch(4, 3, 1);
    for (Vec3d& p : second.control) p.z += 3;
    for (std::size_t i = 0; i < 4; ++i) second.control[i] = first.control[12 + i];
    if (with_pole) {
        for (std::size_t i = 0; i < 4; ++i) second.control[12 + i] = second.control[12];
    }
    std::ranges::reverse(second.control);
    return {first, second};
}

struct View3 {
    Vec3d at;
    Vec3d from;
};

/// Counts lit pixels of a black surface that covers the picture, in front of a white world.
int leaks(const std::vector<Patch>& patches, const View3& view, double height, int size) {
    Scene scene;
    scene.background = {1, 1, 1};
    Material black;
    black.color = {0, 0, 0};
    scene.materials.push_back(black);
    scene.patches = patches;
    for (std::uint32_t i = 0; i < patches.size(); ++i) {
        Object object;
        object.shape = PatchRef{i};
        object.material = static_cast<std::uint32_t>(scene.materials.size() - 1);
        scene.objects.push_back(object);
    }
    Camera camera;
    camera.position = view.from;
    camera.look_at = view.at;
    camera.up = {0.31, 0.2, 0.9};
    camera.projection = OrthographicProjection{height};
    scene.cameras.push_back(camera);
    RayCounts counts;
    const Image image =
        compile(scene, scene.settings)->render({0, size, size, {}, false}, {}, counts);
    int lit = 0;
    for (const double value : image.data) lit += value > 0;
    return lit;
}

TEST(TruePatch, NothingShinesThroughACommonBorderAtAnyZoom) {
    const std::vector<Patch> two = neighbours(false);
    for (const double s : {0.25, 1.0 / 3, 0.5, 0.77}) {
        const auto border = points<double>(two[0]);
        const Vec3d at = splines::cubic(border[12], border[13], border[14], border[15],
                                        splines::Place<double>(s))
                             .first;
        for (const Vec3d& way : {Vec3d(0.1, 4, 0.2), Vec3d(1, 3, 0.9), Vec3d(-0.3, -2, 0.4)}) {
            for (double height = 0.05; height > 1e-13; height /= 32) {
                EXPECT_EQ(leaks(two, {at, at + way}, height, 64), 0) << s << " " << height;
            }
        }
    }
}

TEST(TessellatedPatch, NothingShinesThroughACommonBorderAtAnyZoom) {
    for (const auto& [a, b] : {std::pair{1e-2, 1e-2}, {1e-1, 1e-3}, {1e-3, 1e-1}}) {
        std::vector<Patch> two = neighbours(false);
        two[0].tolerance = a;
        two[1].tolerance = b;
        splines::BorderTolerances borders;
        borders.add(two[0], a);
        borders.add(two[1], b);
        const Mesh mesh = splines::tessellate(two[0], a, &borders).value();
        // Vertices of the border and the middles of its edges.
        std::vector<Vec3d> places;
        for (const auto& face : mesh.faces) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto from = face[k];
                const auto to = face[(k + 1) % 3];
                if (mesh.uvs[from].y != 1 || mesh.uvs[to].y != 1) continue;
                if (std::abs(mesh.uvs[from].x - 0.5) > 0.3) continue;
                places.push_back(mesh.vertices[from]);
                places.push_back((mesh.vertices[from] + mesh.vertices[to]) / 2.0);
            }
        }
        ASSERT_GE(places.size(), 2u);
        const std::size_t stride = places.size() / 4 | 1;
        for (std::size_t i = 0; i < places.size(); i += stride) {
            for (const Vec3d& way : {Vec3d(0.1, 4, 0.2), Vec3d(-0.3, -2, 0.4)}) {
                for (double height = 0.05; height > 1e-13; height /= 64)
                    EXPECT_EQ(leaks(two, {places[i], places[i] + way}, height, 32), 0)
                        << a << " " << b << " " << i << " " << height;
            }
        }
    }
}

TEST(TruePatch, NothingShinesThroughTheInsideAtAnyZoom) {
    // Where pieces meet: at halves and quarters; and at a pole.
    const Patch patch = random_patch(7, 3, 1);
    const auto p = points<double>(patch);
    for (const double u : {0.5, 0.25, 0.125}) {
        for (const double v : {0.5, 0.75, 0.3}) {
            const Vec3d at =
                splines::sample(p, splines::Place<double>(u), splines::Place<double>(v)).point;
            for (double height = 0.02; height > 1e-13; height /= 64)
                EXPECT_EQ(leaks({patch}, {at, at + Vec3d(0.4, 3, -0.2)}, height, 48), 0)
                    << u << " " << v << " " << height;
        }
    }
    // A closed cap: an eighth of a ball, twice, mirrored.
    const double k = 0.5522847498;
    Patch cap;
    for (const Vec2d& a : {Vec2d{0, 1}, {k, 1}, {1, k}, {1, 0}}) {
        for (const Vec2d& t : {Vec2d{1, 0}, {1, k}, {k, 1}, {0, 1}})
            cap.control.emplace_back(a.x * t.x, a.y, a.x * t.y);
    }
    std::vector<Patch> ball;
    for (const double x : {1.0, -1.0}) {
        for (const double z : {1.0, -1.0}) {
            ball.push_back(cap);
            for (Vec3d& q : ball.back().control) q = {x * q.x, q.y, z * q.z};
        }
    }
    const Vec3d pole(0, 1, 0);
    for (double height = 0.1; height > 1e-13; height /= 16) {
        EXPECT_EQ(leaks(ball, {pole, {0.2, 4, 0.1}}, height, 64), 0) << height;
        EXPECT_EQ(leaks(ball, {pole, {0, 4, 0}}, height, 65), 0) << height;
    }
}

}  // namespace
}  // namespace lancer
