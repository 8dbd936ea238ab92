// Eight rays by one patch against the scalar method, bit for bit.
#include "tests/oracle/random_patch.h"
#include "tests/oracle/wide_checks.h"
#include "tests/oracle/wide_levels.h"
#include "tests/oracle/wide_methods.h"
#include "tests/oracle/wide_rays.h"
#include "tracer/wide/flat_patches.h"

namespace lancer::oracle {
namespace {

/// Knows one patch.
class PatchMethods final : public NoMethods {
  public:
    explicit PatchMethods(const BicubicSolid<double>& solid) : solid_(solid) {}

    void patch(std::uint32_t, wide::PatchShape& shape) override {
        shape = wide::shape_of(solid_.surface->tree());
    }
    void piece_crossings(const wide::PatchPiece& piece, const wide::PieceLine& line,
                         const wide::PlanePart* part, const wide::HitSink& sink) override {
        wide::cross_piece(piece, line, part, sink);
    }

  private:
    const BicubicSolid<double>& solid_;
};

struct PatchHit {
    Crossing<double> crossing;
    double u, v;
};

/// The crossings that count, nearest first: IntersectionFilter.
std::vector<PatchHit> hits_with(const BicubicSolid<double>& solid, const Ray<double>& ray,
                                std::uint32_t face, double limit) {
    std::vector<PatchHit> found;
    const auto last = [&] { return limit; };
    crossings(solid, ray, IntersectionHints{face}, RayInterval<double, decltype(last)>{0, last},
              [&](const Crossing<double>& c, double u, double v) {
                  if (c.t > c.error && !(c.t > limit)) found.push_back({c, u, v});
                  return false;
              });
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.crossing.t < b.crossing.t; });
    return found;
}

/// Eight rays that come to places near each other, or start there, some of them along the surface.
struct PatchCase {
    double size;
    BicubicSurface<double> surface;
    BicubicSolid<double> solid{&surface};
    std::uint32_t face = none;
    std::vector<Ray<double>> rays;
    std::vector<wide::LaneRay> lane_rays;
    double normals[lanes][3];
    bool has_normals = false;

    const double (*known_normals() const)[3] { return has_normals ? normals : nullptr; }

    explicit PatchCase(Draw& draw)
        : size(draw.decade(-3, 3)), surface(random_patch(draw, size), 0) {
        const PieceTree<double>& tree = surface.tree();
        const auto piece = static_cast<std::uint32_t>(draw.between(0, 0.999) *
                                                      static_cast<double>(tree.pieces.size()));
        const bool starts = draw.unit() < 0.3;
        const bool sideways = draw.unit() < 0.25;
        if (starts) face = piece;
        has_normals = starts && draw.unit() < 0.8;
        const double spread = draw.decade(-3, 0);
        const double u = draw.unit();
        const double v = draw.unit();
        const Vec3d from = draw.direction();
        for (int i = 0; i < lanes; ++i) {
            const auto near = [&](double s) {
                return std::clamp(s + spread * draw.between(-1, 1), 0.0, 1.0);
            };
            const double own_u = near(u);
            const SurfacePoint<double> p = bicubic_point(solid, piece, own_u, near(v));
            const Vec3d place = p.anchor + p.offset;
            Vec3d way = normalize(from + spread * draw.direction());
            if (sideways) {  // nearly along the surface
                const Vec3d normal = normalize(p.normal);
                way = normalize(way - lancer::dot(way, normal) * normal * (1 - draw.decade(-9, 0)));
            }
            const double error = p.error + gamma<double>(2) * max_component(absolute(place));
            const Vec3d origin = starts ? place : place - size * draw.decade(-2, 2) * way;
            put(normalize(p.normal), normals[i]);
            rays.push_back(make_ray(origin, Vec3d(0), way, starts ? error : 0));
            lane_rays.push_back(lane_ray(rays.back()));
        }
    }
};

TEST(OracleWide, Patch) {
    on_each_level([](const WideKernels& kernels) {
        Share nearest, shadow;
        Tally("patch, side by side").run([&](Draw& draw) {
            if (draw.number() % 4 != 0) return;
            const PatchCase c(draw);
            PatchMethods exact(c.solid);
            const double limit = some_limit(draw, c.size);
            WideAnswer answers[lanes];
            WideAnswer shadows[lanes];
            kernels.patch(exact, c.lane_rays.data(), c.face, c.known_normals(), limit, answers);
            kernels.patch_shadow(exact, c.lane_rays.data(), c.face, c.known_normals(), limit,
                                 shadows);
            for (std::size_t i = 0; i < lanes; ++i) {
                const std::vector<PatchHit> found = hits_with(c.solid, c.rays[i], c.face, limit);
                ++shadow.answers;
                shadow.hits += shadows[i].hit;
                shadow.unsure += shadows[i].unsure;
                const bool hidden = std::any_of(found.begin(), found.end(), [&](const auto& h) {
                    return h.crossing.t < limit - h.crossing.error;
                });
                if (!shadows[i].unsure) {
                    EXPECT_EQ(shadows[i].hit, hidden) << "case " << draw.number();
                }
                ++nearest.answers;
                nearest.hits += answers[i].hit;
                nearest.unsure += answers[i].unsure;
                if (answers[i].unsure) continue;
                ASSERT_EQ(answers[i].hit, !found.empty()) << "case " << draw.number();
                if (found.empty()) continue;
                EXPECT_EQ(answers[i].t, found[0].crossing.t) << "case " << draw.number();
                EXPECT_EQ(answers[i].error, found[0].crossing.error) << "case " << draw.number();
                EXPECT_EQ(answers[i].face, found[0].crossing.face) << "case " << draw.number();
                EXPECT_EQ(answers[i].entering, found[0].crossing.entering);
                EXPECT_EQ(answers[i].u, found[0].u) << "case " << draw.number();
                EXPECT_EQ(answers[i].v, found[0].v) << "case " << draw.number();
            }
        });
        nearest.expect(0.2);
        shadow.expect(0.05);
    });
}

}  // namespace
}  // namespace lancer::oracle
