// Surfaces and refraction side by side compared with make_surface(), number by number.
#include <random>

#include "tests/extremes/stage.h"
#include "tests/oracle/tally.h"
#include "tests/oracle/wide_kernels.h"
#include "tests/oracle/wide_levels.h"
#include "tests/oracle/wide_methods.h"
#include "tracer/compile/compile.h"
#include "tracer/intersect/nearest_contact.h"
#include "tracer/shading/optics.h"
#include "tracer/shading/surface.h"
#include "tracer/wide/flat_world.h"

namespace lancer::oracle {
namespace {

/// Counts the hits that scalar code must handle, and handles none.
class NoSurfaces final : public NoMethods {
  public:
    std::size_t asked = 0;

    void surface(const wide::LaneRay&, const wide::LaneHit&, wide::LaneSurface& s) override {
        ++asked;
        s = {};
        s.error = -1;
    }
};

/// Balls, boxes, cylinders, cones and planes, and rings and meshes in frames, smooth and flat.
Scene shapes(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const auto place = [&] {
        const double x = 4 * unit(random) - 2;
        const double y = 2 * unit(random);
        return Vec3d(x, y, 4 * unit(random) - 2);
    };
    extremes::Stage s;
    const auto wears = [&](std::variant<ImageTexture, Checker, Gradient, VertexColors> pattern) {
        const Affine<double> map = compose(extremes::turn(1, 360 * unit(random)),
                                           extremes::stretched(0.1 + unit(random), 0.3, 0.5));
        Material m;
        m.texture = static_cast<std::uint32_t>(s.scene.textures.size());
        s.scene.textures.push_back({std::move(pattern), map});
        return s.material(m);
    };
    const double step = 0.2 + unit(random) / 2;
    const std::uint32_t materials[] = {s.matt({0.2, 0.5, 0.7}), s.mirror(), s.matt({1, 0, 0.1}),
                                       wears(Checker{{0.1, 0.5, 0.9}, {0.8, 0.7, 0.3}}),
                                       wears(Gradient{{0.2, 1, 0.5},
                                                      {{0.1, {1, 0, 0.2}},
                                                       {step, {0.3, 0.9, 0}},
                                                       {step, {0, 0.1, 0.2}},
                                                       {0.9, {0.7, 0.5, 1}}}})};
    s.add(Plane{{0, 1, 0}, -0.3}, materials[0]);
    s.add(Plane{{unit(random), 1, unit(random)}, -0.5}, materials[3]);
    for (int i = 0; i < 21; ++i) {
        const double size = 0.1 + 0.5 * unit(random);
        const std::uint32_t material = materials[random() % 5];
        const Vec3d p = place();
        const Affine<double> map = compose(
            extremes::shift(place()), compose(extremes::turn(i % 3, 360 * unit(random)),
                                              extremes::stretched(1, 0.5 + unit(random), 0.5)));
        switch (i % 7) {
            case 0:
                s.add(Sphere{p, size}, material);
                break;
            case 1:
                s.add(Box{p, p + Vec3d(size, size / 2, size)}, material);
                break;
            case 2:
                s.add(extremes::icosphere(p, size, 2), material);
                break;
            case 3:
                s.add(Cylinder{p, p + size * (random() % 2 == 0 ? Vec3d(0, 1, 0) : place()),
                               size / 2, random() % 2 == 0},
                      material);
                break;
            case 4:
                s.add(Cone{p, p + size * place(), size / 2, random() % 2 == 0 ? 0 : size / 3,
                           random() % 2 == 0},
                      material);
                break;
            case 5:
                s.add(Torus{size, size * 0.9 * unit(random)}, material,
                      i < 7 ? Affine<double>{} : map);
                break;
            default:
                s.add(extremes::icosphere(Vec3d(0), size, 2), material, map);
                break;
        }
        if (auto* mesh = std::get_if<MeshRef>(&s.scene.objects.back().shape))
            mesh->smooth = random() % 2 == 0;
    }
    return s.scene;
}

void put(const Vec3d& v, double (&to)[3]) {
    for (int i = 0; i < 3; ++i) to[i] = v[i];
}

void expect_same(const double (&wide)[3], const Vec3d& expected, const char* what) {
    for (int i = 0; i < 3; ++i) EXPECT_EQ(wide[i], expected[i]) << what;
}

TEST(OracleWide, Surfaces) {
    on_each_level([](const WideKernels& kernels) {
        std::mt19937_64 random(11);
        std::uniform_real_distribution<double> unit(-1, 1);
        const auto direction = [&] {
            const double x = unit(random);
            const double y = unit(random);
            return normalize(Vec3d(x, y, unit(random)) + Vec3d(1e-3));
        };
        NoSurfaces exact;
        std::size_t checked = 0;
        for (int k = 0; k < 12; ++k) {
            const Scene scene = shapes(random);
            const auto world = compile_world<double>(scene, scene.settings);
            const wide::FlatWorld flat(*world);
            std::vector<wide::LaneRay> rays;
            std::vector<wide::LaneHit> hits;
            std::vector<Surface<double>> expected;
            for (int i = 0; i < 4000; ++i) {
                const Vec3d from =
                    direction() * std::ldexp(1.0, static_cast<int>(random() % 8) - 3);
                const Vec3d low = i % 2 == 0 ? Vec3d(0) : from * (unit(random) * 0x1p-54);
                const Ray<double> ray =
                    make_ray(from, low, normalize(direction() * 0.2 - from), 1e-17);
                const auto contact = nearest_contact(*world, ray, Start<double>{}, NoMedia{});
                if (contact.size() != 1) continue;
                const Hit<double> hit = contact.front();
                wide::LaneRay r{};
                put(ray.origin, r.origin);
                put(ray.origin_lo, r.origin_lo);
                put(ray.dir, r.dir);
                r.origin_error = ray.origin_error;
                rays.push_back(r);
                hits.push_back({hit.t, hit.error, hit.u, hit.v, hit.surface.primitive,
                                hit.surface.face, hit.surface.entering});
                expected.push_back(make_surface(*world, ray, hit));
            }
            for (std::size_t i = 0; i + 8 <= rays.size(); i += 8) {
                wide::LaneSurface out[8];
                kernels.surfaces(flat.scene(), exact, &rays[i], &hits[i], out);
                for (std::size_t j = 0; j < 8; ++j) {
                    if (out[j].error == -1) continue;  // scalar code must handle it
                    const Surface<double>& s = expected[i + j];
                    expect_same(out[j].position, s.position, "position");
                    expect_same(out[j].position_lo, s.position_lo, "position_lo");
                    expect_same(out[j].geometric, s.geometric, "geometric");
                    expect_same(out[j].normal, s.normal, "normal");
                    expect_same(out[j].color, s.color, "color");
                    EXPECT_EQ(out[j].error, s.error);
                    EXPECT_EQ(out[j].opacity, s.opacity);
                    EXPECT_EQ(out[j].outermost, s.primitive->convex || s.outermost);
                    ++checked;
                }
            }
        }
        EXPECT_GT(checked, 10000u);
        EXPECT_LT(exact.asked, checked / 50);
    });
}

TEST(OracleWide, LightIsBentTheSame) {
    on_each_level([](const WideKernels& kernels) {
        int total = 0;
        Tally("refraction, side by side").run([&](Draw& draw) {
            wide::LaneRay rays[8] = {};
            Vec3d dirs[8], normals[8];
            double plain[8][3], ratios[8], bent[8][3];
            for (int i = 0; i < 8; ++i) {
                dirs[i] = draw.direction();
                const Vec3d n = draw.direction();
                normals[i] = lancer::dot(n, dirs[i]) > 0 ? -n : n;
                for (int c = 0; c < 3; ++c) {
                    rays[i].dir[c] = dirs[i][c];
                    plain[i][c] = normals[i][c];
                }
                ratios[i] = draw.decade(-0.5, 0.5);
            }
            WideAnswer answers[8];
            kernels.bend(rays, plain, ratios, bent, answers);
            for (int i = 0; i < 8; ++i) {
                EXPECT_EQ(answers[i].t,
                          fresnel_reflectance(-lancer::dot(normals[i], dirs[i]), 1 / ratios[i]));
                Vec3d expected;
                const bool passes = refracted(dirs[i], normals[i], ratios[i], expected);
                EXPECT_EQ(answers[i].hit, !passes) << "case " << draw.number();
                total += passes ? 0 : 1;
                if (!passes) continue;
                EXPECT_EQ(Vec3d(bent[i][0], bent[i][1], bent[i][2]), expected);
            }
        });
        EXPECT_GT(total, 1000);
    });
}

}  // namespace
}  // namespace lancer::oracle
