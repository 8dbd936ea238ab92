// Eight rays by one torus against the scalar method, bit for bit.
#include "tests/oracle/wide_checks.h"
#include "tests/oracle/wide_kernels.h"
#include "tests/oracle/wide_levels.h"
#include "tests/oracle/wide_rays.h"
#include "tracer/compile/maps.h"
#include "tracer/shapes/torus.h"
#include "tracer/wide/flat_tori.h"

namespace lancer::oracle {
namespace {

using lancer::cross;

struct TorusCase {
    TorusSolid<double> solid;
    wide::Torus wide;

    explicit TorusCase(Draw& draw) : solid{draw.between(0.5, 1), 0} {
        solid.tube = draw.number() % 7 == 0 ? solid.ring : solid.ring * draw.decade(-6, 0);
        solid.shrink = std::ldexp(1.0, static_cast<int>(draw.number() % 9) - 4);
        solid.grow = 1 / solid.shrink;
        wide = wide::flat_torus(solid, wide::nothing, nullptr);
    }
    /// A place on the tube, in the solid's own space, and the normal there.
    void on_surface(Draw& draw, Vec3d& place, Vec3d& outward) const {
        const double angle = draw.between(0, 6.28318);
        const double round = draw.between(0, 6.28318);
        const Vec3d away(std::cos(angle), 0, std::sin(angle));
        outward = away * std::cos(round) + Vec3d(0, std::sin(round), 0);
        place = (away * solid.ring + outward * solid.tube) * solid.grow;
    }
};

TEST(OracleWide, Torus) {
    on_each_level([](const WideKernels& kernels) {
        Share nearest, shadow;
        Tally("torus, side by side").run([&](Draw& draw) {
            const TorusCase c(draw);
            const double size = c.solid.reach() * c.solid.grow;
            const Eight rays(draw, [&](Draw& own) {
                Vec3d place;
                Vec3d outward;
                c.on_surface(own, place, outward);
                if (own.number() % 4 == 1) {  // nearly touches
                    const Vec3d along = normalize(cross(outward, own.direction()));
                    return make_ray(place - along * size, Vec3d(0), along, 0.0);
                }
                const Vec3d target = place - outward * (c.solid.tube * c.solid.grow * own.unit());
                const Vec3d from = target + own.direction() * (size * own.decade(-2, 4));
                return make_ray(from, Vec3d(0), normalize(target - from), 0.0);
            });
            const double limit = some_limit(draw, size);
            WideAnswer answers[lanes];
            kernels.torus(c.wide, rays.lane_rays.data(), limit, answers);
            for (std::size_t i = 0; i < lanes; ++i)
                check_nearest(crossings_to(c.solid, rays.rays[i], limit), answers[i], draw,
                              nearest);
            kernels.torus_shadow(c.wide, rays.lane_rays.data(), false, limit, answers);
            for (std::size_t i = 0; i < lanes; ++i)
                check_shadow(c.solid, rays.rays[i], limit, answers[i], draw, shadow);
        });
        nearest.expect(0.3);
        shadow.expect(0.3);
    });
}

/// Rays that leave the torus for good are recognized, and rays that meet it again. Nothing is
/// required for others.
TEST(OracleWide, FromATorus) {
    on_each_level([](const WideKernels& kernels) {
        std::size_t settled = 0;
        std::size_t again = 0;
        std::size_t asked = 0;
        Tally("torus from its surface, side by side").run([&](Draw& draw) {
            const TorusCase c(draw);
            const Eight rays(draw, [&](Draw& own) {
                Vec3d place;
                Vec3d outward;
                c.on_surface(own, place, outward);
                Vec3d dir = own.direction();
                if (own.number() % 4 == 1)
                    dir = normalize(normalize(cross(outward, dir)) + outward * own.decade(-16, -1));
                return make_ray(place, Vec3d(0), dir,
                                gamma<double>(8) * c.solid.reach() * c.solid.grow);
            });
            const double limit = some_limit(draw, c.solid.reach() * c.solid.grow);
            WideAnswer answers[lanes];
            kernels.torus_shadow(c.wide, rays.lane_rays.data(), true, limit, answers);
            for (std::size_t i = 0; i < lanes; ++i) {
                ++asked;
                if (answers[i].unsure) continue;
                ++settled;
                again += answers[i].hit;
                bool hidden = false;
                const auto end = [] { return infinity; };
                crossings(c.solid, rays.rays[i], IntersectionHints{0},
                          RayInterval<double, decltype(end)>{-1e-300, end},
                          [&](const Crossing<double>& other) {
                              hidden |= other.t > other.error && other.t < limit - other.error;
                          });
                EXPECT_EQ(answers[i].hit, hidden) << "case " << draw.number();
            }
        });
        EXPECT_GT(settled, asked / 4);
        EXPECT_GT(again, asked / 50);
    });
}

/// No ray misses the disc that meets the torus, wherever the torus was moved, turned and stretched
/// to. Rays that miss it are recognized.
TEST(OracleWide, DiscsOfTori) {
    on_each_level([](const WideKernels& kernels) {
        std::size_t apart = 0;
        std::size_t recognized = 0;
        Tally("torus, its disc").run([&](Draw& draw) {
            const TorusCase c(draw);
            Affine<double> map;
            const double size = draw.decade(-6, 6);
            for (Vec3d& row : map.rows) row = draw.direction() * size;
            if (draw.number() % 3 != 0) {  // a similarity
                map.rows[1] = normalize(cross(map.rows[0], map.rows[1])) * size;
                map.rows[2] = normalize(cross(map.rows[0], map.rows[1])) * size;
            }
            map.shift = draw.direction() * (size * draw.decade(-3, 6));
            const Frame<double> frame = make_frame(map);
            const wide::Torus torus = wide::flat_torus(c.solid, 0, &frame);
            const double reach = c.solid.reach() * c.solid.grow;
            const Eight rays(draw, [&](Draw& own) {
                Vec3d place;
                Vec3d outward;
                c.on_surface(own, place, outward);
                const double off = own.number() % 2 == 0 ? -c.solid.tube * own.decade(-17, 0)
                                                         : c.solid.reach() * own.decade(-17, 1);
                const Vec3d along =
                    own.number() % 4 < 2 ? own.direction() : cross(outward, own.direction());
                const Vec3d target = map_point(map, place + outward * (off * c.solid.grow));
                const Vec3d dir = normalize(map_vector(map, along));
                return make_ray(target - dir * (size * reach * own.decade(-2, 6)), Vec3d(0), dir,
                                0.0);
            });
            WideAnswer answers[lanes];
            kernels.disc(torus.disc, rays.lane_rays.data(), answers);
            for (std::size_t i = 0; i < lanes; ++i) {
                const bool meets =
                    !crossings_to(c.solid, to_local(rays.rays[i], frame), infinity).empty();
                EXPECT_TRUE(!meets || answers[i].unsure) << "case " << draw.number();
                apart += !meets;
                recognized += !answers[i].unsure;
            }
        });
        EXPECT_GT(recognized, apart / 10);
    });
}

}  // namespace
}  // namespace lancer::oracle
