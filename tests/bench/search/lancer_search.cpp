#include <cmath>
#include <memory>

#include "model/scene.h"
#include "tests/bench/search/search_rays.h"
#include "tests/extremes/stage.h"
#include "tests/oracle/wide_methods.h"
#include "tracer/compile/compile.h"
#include "tracer/intersect/candidates.h"
#include "tracer/intersect/nearest_contact.h"
#include "tracer/wide/flat_world.h"
#include "tracer/wide/job.h"
#include "tracer/wide/level.h"
#include "tracer/wide/scalar_methods.h"
//
#include "tests/bench/search/level_search.h"

namespace lancer {

namespace wide {

void search_eight_avx2(const Job& job, EightRays& rays);
void search_eight_avx512(const Job& job, EightRays& rays);

}  // namespace wide

namespace search {

namespace {

/// The exact methods that the search of a mesh calls: crossings with the mesh.
class Crossings final : public oracle::NoMethods {
  public:
    explicit Crossings(const World<double>& world) : world_(world) {}

    void crossings(std::uint32_t item, const wide::LaneRay& r, const wide::LaneStart&,
                   const wide::HitSink& sink) override {
        const Ray<double> ray = wide::ray_of(r);
        const auto limit = [&] { return sink.limit(sink.self); };
        const RayInterval<double, decltype(limit)> interval{0, limit};
        primitive_crossings(
            world_, world_.primitives[item], ray, IntersectionHints{}, interval,
            [&](const Crossing<double>& c, double u, double v) {
                if (c.t >= 0) sink.add(sink.self, {c.t, c.error, u, v, item, c.face, c.entering});
                return false;
            });
    }

  private:
    const World<double>& world_;
};

/// A mesh as the tracer has it, and its searches.
class Prepared {
  public:
    explicit Prepared(const Mesh& mesh) {
        extremes::Stage stage;
        stage.add(mesh, stage.matt({1, 1, 1}));
        stage.look({2.1, 1.3, 1.7}, {0, 0, 0}, 45);
        world_ = compile_world<double>(stage.scene, stage.scene.settings);
        flat_ = std::make_unique<wide::FlatWorld>(*world_);
        exact_ = std::make_unique<Crossings>(*world_);
        job_.scene = &flat_->scene();
        job_.exact = exact_.get();
        scale_ = std::ldexp(1.0, world_->scale_exponent);
    }

    void one_by_one(std::span<const SearchRay> rays, std::span<double> distances,
                    std::span<std::uint32_t> faces) const {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Ray<double> ray =
                make_ray(rays[i].origin * scale_, Vec3d(0), rays[i].direction, 0.0);
            const auto contact = nearest_contact(*world_, ray, Start<double>{}, NoMedia{});
            distances[i] = contact.empty() ? no_hit : contact[0].t / scale_;
            if (!faces.empty() && !contact.empty()) faces[i] = contact[0].surface.face;
        }
    }

    /// Searches again, one by one, for rays that are unsure on this level.
    template <class Level>
    void by_eights(Level search, std::span<const SearchRay> rays, std::span<double> distances,
                   std::span<std::uint32_t> faces) const {
        for (std::size_t at = 0; at < rays.size(); at += 8) {
            const std::size_t count = std::min<std::size_t>(8, rays.size() - at);
            wide::EightRays eight{};
            for (std::size_t i = 0; i < 8; ++i) {
                const SearchRay& ray = rays[at + std::min(i, count - 1)];
                for (int a = 0; a < 3; ++a) {
                    eight.origin[a][i] = ray.origin[a] * scale_;
                    eight.dir[a][i] = ray.direction[a];
                }
            }
            search(job_, eight);
            for (std::size_t i = 0; i < count; ++i) {
                if ((eight.unsure >> i & 1) != 0) {
                    one_by_one(rays.subspan(at + i, 1), distances.subspan(at + i, 1),
                               faces.empty() ? faces : faces.subspan(at + i, 1));
                    continue;
                }
                distances[at + i] = (eight.some >> i & 1) != 0 ? eight.t[i] / scale_ : no_hit;
                if (!faces.empty()) faces[at + i] = eight.face[i];
            }
        }
    }

  private:
    std::unique_ptr<World<double>> world_;
    std::unique_ptr<wide::FlatWorld> flat_;
    std::unique_ptr<Crossings> exact_;
    wide::Job job_{};
    double scale_ = 1;
};

}  // namespace

std::vector<NamedSearch> lancer_searches(const Mesh& mesh) {
    const auto prepared = std::make_shared<const Prepared>(mesh);
    std::vector<NamedSearch> searches{
        {"Lancer, double, one ray", [prepared](auto... asked) { prepared->one_by_one(asked...); }}};
    const auto add = [&](Level level, const char* name, auto search) {
        if (is_supported(level))
            searches.push_back(
                {name, [=](auto... asked) { prepared->by_eights(search, asked...); }});
    };
    add(Level::avx2, "Lancer, double, eight rays, AVX2", wide::search_eight_avx2);
    add(Level::avx512, "Lancer, double, eight rays, AVX-512", wide::search_eight_avx512);
    return searches;
}

}  // namespace search

}  // namespace lancer
