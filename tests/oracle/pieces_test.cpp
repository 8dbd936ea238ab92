// What a piece of a patch predicts about a line (tracer/splines/piece_frame.h), compared with the
// crossings of the exact method behind it.
#include "tests/oracle/random_patch.h"
#include "tests/oracle/tally.h"
#include "tracer/rays/crossing.h"
#include "tracer/shapes/bicubic.h"

namespace lancer::oracle {
namespace {

std::vector<Crossing<double>> crossings_of(const PieceTree<double>& tree, std::uint32_t piece,
                                           const Ray<double>& ray) {
    std::vector<Crossing<double>> found;
    const PieceStart<double> start(tree.homes[tree.home[piece]], ray);
    piece_crossings(tree.pieces[piece], piece, start, shear_of(ray),
                    [&](const Crossing<double>& c, double, double) { found.push_back(c); });
    return found;
}

/// A ray towards a place near a piece, sometimes within rounding of its border.
Ray<double> ray_to(const BicubicSolid<double>& solid, std::uint32_t piece, Draw& draw,
                   double size) {
    const auto parameter = [&] {
        if (draw.between(0, 1) < 0.25)
            return (draw.between(0, 1) < 0.5 ? 0.0 : 1.0) +
                   draw.decade(-17, -2) * draw.between(-1, 1);
        return draw.between(-0.2, 1.2);
    };
    const double u = parameter();
    const SurfacePoint<double> p = bicubic_point(solid, piece, u, parameter());
    const Vec3d target = p.anchor + p.offset;
    const Vec3d way = Vec3d(draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1));
    const double error = draw.between(0, 1) < 0.2 ? size * draw.decade(-16, -7) : 0;
    return make_ray(target - size * draw.decade(-3, 3) * way, Vec3d(0), normalize(way), error);
}

/// A piece of a random patch.
struct Drawn {
    Draw& draw;
    double size;  ///< of the patch
    const BicubicSolid<double>& solid;
    const PieceTree<double>& tree;
    std::uint32_t piece;
};

/// 64 pieces of every sixteenth case's patch.
template <class Look>
void for_pieces(const char* name, Look&& look) {
    Tally tally(name);
    tally.run([&](Draw& draw) {
        if (draw.number() % 16 != 0) return;
        const double size = draw.decade(-3, 3);
        const BicubicSurface<double> surface(random_patch(draw, size), 0);
        const BicubicSolid<double> solid{&surface};
        const PieceTree<double>& tree = surface.tree();
        for (int i = 0; i < 64; ++i) {
            const auto piece = static_cast<std::uint32_t>(draw.between(0, 0.999) *
                                                          static_cast<double>(tree.pieces.size()));
            look(Drawn{draw, size, solid, tree, piece});
        }
    });
}

TEST(Pieces, ForeseeWhatTheMethodFinds) {
    std::uint64_t lines = 0, clear = 0, passed = 0, met = 0, crossed = 0;
    for_pieces("pieces", [&](const Drawn& drawn) {
        const auto& [draw, size, solid, tree, piece] = drawn;
        const Ray<double> ray = ray_to(solid, piece, draw, size);
        const PieceStart<double> start(tree.homes[tree.home[piece]], ray);
        const splines::PieceView<double> view(tree.frames[piece], start.at, ray.dir, start.noise);
        const std::vector<Crossing<double>> found = crossings_of(tree, piece, ray);
        ++lines;
        if (!view.is_clear) return;
        ++clear;
        ASSERT_LE(found.size(), 1u) << "case " << draw.number();
        crossed += found.size();
        if (view.passes_by()) {
            ++passed;
            EXPECT_TRUE(found.empty()) << "case " << draw.number() << ": passed by, yet met";
        }
        const auto [first, last] = view.stretch();
        for (const Crossing<double>& c : found) {
            EXPECT_GE(c.t - 8 * c.error, first) << "case " << draw.number();
            EXPECT_LE(c.t + 8 * c.error, last) << "case " << draw.number();
        }
        if (view.meets(tree.pieces[piece])) {
            ++met;
            EXPECT_EQ(found.size(), 1u) << "case " << draw.number() << ": not met";
        }
    });
    // A filter that never decides would pass, but be useless.
    EXPECT_GT(4 * clear, lines);
    EXPECT_GT(10 * passed, 5 * (clear - crossed));
    EXPECT_GT(10 * met, 5 * crossed);
}

/// A ray that starts on a piece which it meets at most once has its crossing there at the start.
TEST(Pieces, LeaveOutTheStartAlone) {
    std::uint64_t clear = 0;
    for_pieces("starts on pieces", [&](const Drawn& drawn) {
        const auto& [draw, size, solid, tree, piece] = drawn;
        const double u = draw.between(0, 1);
        const SurfacePoint<double> p = bicubic_point(solid, piece, u, draw.between(0, 1));
        const Vec3d way(draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1));
        const Vec3d origin = p.anchor + p.offset;
        const Ray<double> ray =
            make_ray(origin, Vec3d(0), normalize(way),
                     p.error + gamma<double>(2) * max_component(absolute(origin)));
        const PieceStart<double> start(tree.homes[tree.home[piece]], ray);
        if (!splines::PieceView<double>(tree.frames[piece], start.at, ray.dir, start.noise)
                 .is_clear)
            return;
        ++clear;
        for (const Crossing<double>& c : crossings_of(tree, piece, ray))
            EXPECT_LE(std::abs(c.t), c.error) << "case " << draw.number();
    });
    EXPECT_GT(clear, 100u);
}

}  // namespace
}  // namespace lancer::oracle
