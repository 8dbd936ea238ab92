#include "tracer/wide/wide_tracer.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "tracer/wide/flat_world.h"
#include "tracer/wide/job.h"
#include "tracer/wide/scalar_methods.h"

namespace lancer {
namespace wide {

// Each is compiled in its own file, with the level's instructions.
void trace_rays_avx2(Job& job, const Camera& camera, const double* x, const double* y, int count);
void trace_rays_avx512(Job& job, const Camera& camera, const double* x, const double* y, int count);

namespace {

TraceRays code_of(Level level) {
#ifdef __x86_64__
    if (level == Level::avx512) return trace_rays_avx512;
    if (level == Level::avx2) return trace_rays_avx2;
#endif
    assert(level != Level::scalar);
    return nullptr;
}

Camera camera_of(const CameraFrame<double>& frame, int width, int height) {
    Camera camera{};
    put(frame.position, camera.position);
    put(frame.forward, camera.forward);
    put(frame.right, camera.right);
    put(frame.up, camera.up);
    camera.orthographic = frame.orthographic;
    camera.width = width;
    camera.height = height;
    return camera;
}

/// The sums of a tile. The number of chains is fixed; when all are used, rays go one by one, and
/// take no more memory.
class TileLedger : public Ledger {
  public:
    TileLedger() : Ledger{} {
        grow = [](Ledger& self) { static_cast<TileLedger&>(self).add_room(); };
    }
    TileLedger(const TileLedger&) = delete;
    TileLedger& operator=(const TileLedger&) = delete;

    /// Allocates the chains. Call it before the first begin_chain().
    void make_chains() {
        chain_room = 1U << 16;
        own_chains_ = std::make_unique_for_overwrite<Chain[]>(chain_room);
        chains = own_chains_.get();
    }

  private:
    void add_room() {
        own_terms_.resize(std::max<std::size_t>(1024, 2 * own_terms_.size()));
        terms = own_terms_.data();
        term_room = static_cast<std::uint32_t>(own_terms_.size());
    }

    std::unique_ptr<Chain[]> own_chains_;
    std::vector<Term> own_terms_;
};

template <class Tracer>
class LevelTracer final : public WideTracer {
  public:
    LevelTracer(const World<double>& world, Scene scene, const TraceLimits& limits, Level level)
        : scene_(scene),
          exact_(world, limits),
          code_(code_of(level)),
          last_in_the_way_(world.lights.size(), nothing) {
        scene_.max_depth = limits.max_depth;
        scene_.min_contribution = limits.min_contribution;
        job_.scene = &scene_;
        job_.exact = &exact_;
        job_.wave = wave;
        job_.waves = &waves_;
        job_.last_in_the_way = last_in_the_way_.data();
        job_.ledger = &ledger_;
        if constexpr (!is_opaque<Tracer>) ledger_.make_chains();
    }

    void trace(const CameraFrame<double>& frame, int width, int height, RayBatch& batch) override {
        code_(job_, camera_of(frame, width, height), batch.x.data(), batch.y.data(), batch.count);
        const auto& color = waves_[0]->color;
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
            batch.color[i] = {color[0][i], color[1][i], color[2][i]};
    }

    RayCounts counts() const override {
        RayCounts counts = exact_.counts();
        counts.primary += job_.counts.primary;
        counts.shadow += job_.counts.shadow;
        counts.reflected += job_.counts.reflected;
        counts.transmitted += job_.counts.transmitted;
        return counts;
    }

  private:
    static Wave* wave(void* waves, int number) {
        auto& all = *static_cast<std::vector<std::unique_ptr<Wave>>*>(waves);
        const auto index = static_cast<std::size_t>(number);
        while (all.size() <= index) {
            all.push_back(std::make_unique_for_overwrite<Wave>());
            all.back()->count = all.back()->deepest = 0;
        }
        return all[index].get();
    }

    Scene scene_;
    ScalarMethods<Tracer> exact_;
    TraceRays code_;
    std::vector<std::unique_ptr<Wave>> waves_;
    std::vector<std::uint32_t> last_in_the_way_;
    TileLedger ledger_;
    Job job_{};
};

}  // namespace
}  // namespace wide

struct WideWorld::Arrays {
    wide::FlatWorld flat;
};

WideWorld::WideWorld(const World<double>& world, Level level)
    : world_(world), level_(level), arrays_(new Arrays{wide::FlatWorld(world)}) {
    assert(level != Level::scalar && is_supported(level));
}
WideWorld::~WideWorld() = default;

std::unique_ptr<WideTracer> WideWorld::tracer(const TraceLimits& limits,
                                              const CameraFrame<double>& camera) const {
    if (camera.ahead != 0 || !is_followed(limits, 1.0, 0)) return nullptr;
    if (world_.planes != world_.bounded) return nullptr;  // an unbounded composite
    const wide::Scene& scene = arrays_->flat.scene();
    if (is_all_opaque(world_))
        return std::make_unique<wide::LevelTracer<OpaqueTracer<double>>>(world_, scene, limits,
                                                                         level_);
    // Camera rays must begin outside of all bodies.
    if (camera.orthographic) return nullptr;
    for (const Bounds<double>& box : world_.medium_bounds)
        if (box.contains(camera.position)) return nullptr;
    return std::make_unique<wide::LevelTracer<Whitted<double>>>(world_, scene, limits, level_);
}

}  // namespace lancer
