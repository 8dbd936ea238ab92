// Eight rays by one torus against the scalar method, bit for bit.
#include "tests/oracle/wide_checks.h"
#include "tests/oracle/wide_kernels.h"
#include "tests/oracle/wide_levels.h"
#include "tests/oracle/wide_rays.h"
#include "tracer/shapes/torus.h"

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
        wide = {solid.ring, solid.tube, solid.shrink, solid.grow, wide::nothing};
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

/// Rays that leave the torus for good are recognized; nothing is required for others.
TEST(OracleWide, FromATorus) {
    on_each_level([](const WideKernels& kernels) {
        std::size_t settled = 0;
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
            WideAnswer answers[lanes];
            kernels.torus_shadow(c.wide, rays.lane_rays.data(), true, infinity, answers);
            for (std::size_t i = 0; i < lanes; ++i) {
                ++asked;
                EXPECT_FALSE(answers[i].hit);
                if (answers[i].unsure) continue;
                ++settled;
                const auto end = [] { return infinity; };
                crossings(c.solid, rays.rays[i], IntersectionHints{0},
                          RayInterval<double, decltype(end)>{-1e-300, end},
                          [&](const Crossing<double>& other) {
                              EXPECT_LE(other.t, other.error) << "case " << draw.number();
                          });
            }
        });
        EXPECT_GT(settled, asked / 5);
    });
}

}  // namespace
}  // namespace lancer::oracle
