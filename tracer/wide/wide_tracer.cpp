#include "tracer/wide/wide_tracer.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "tracer/recursion/opaque.h"
#include "tracer/recursion/whitted.h"
#include "tracer/wide/flat_world.h"
#include "tracer/wide/job.h"

namespace lancer {
namespace wide {

// Each compiled in a file of its own, with the level's instructions.
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

Vec3d vector_of(const double* v) {
    return {v[0], v[1], v[2]};
}
void put(const Vec3d& from, double* to) {
    for (int i = 0; i < 3; ++i) to[i] = from[i];
}

Ray<double> ray_of(const LaneRay& r) {
    return {vector_of(r.origin), vector_of(r.origin_lo), vector_of(r.dir),
            r.dir_squared,       r.inv_squared,          r.origin_error,
            r.filter_error,      vector_of(r.inv_dir),   r.whole};
}
lancer::Start<double> start_of(const LaneStart& from) {
    lancer::Start<double> start;
    if (from.item != none) start.surfaces.push_back({from.item, from.face, from.entering});
    start.left = from.left;
    return start;
}
MediaList bodies_of(const LaneStart& from) {
    MediaList bodies;
    for (const std::uint32_t body : from.bodies)
        if (body != none) bodies.push_back(body);
    return bodies;
}
Hit<double> hit_of(const LaneHit& h) {
    return {h.t, h.error, {h.item, h.face, h.entering}, h.u, h.v};
}

template <class Tracer>
constexpr bool is_opaque = std::is_same_v<Tracer, OpaqueTracer<double>>;

/// The scalar code behind ExactMethods.
///
/// \tparam Tracer  the recursion for such worlds: OpaqueTracer or Whitted
template <class Tracer>
class ScalarMethods final : public ExactMethods {
  public:
    ScalarMethods(const World<double>& world, const TraceLimits& limits)
        : world_(world), tracer_(world, limits) {}

    const RayCounts& counts() const { return tracer_.counts(); }

    void trace(const LaneRay& ray, const LaneStart& start, double weight, int depth,
               double* color) override {
        if constexpr (is_opaque<Tracer>)
            put(tracer_.trace(ray_of(ray), start_of(start), weight, depth), color);
    }

    void follow(const LaneRay& ray, const LaneStart& start, double weight, int depth,
                const double* through, const LightSink& sink) override {
        if constexpr (!is_opaque<Tracer>) {
            tracer_.follow(ray_of(ray), start_of(start), media_of(start), weight, depth,
                           vector_of(through), [&](const Vec3d& light) {
                               double one[3];
                               put(light, one);
                               sink.add(sink.self, one);
                           });
        }
    }

    void shade(const LaneRay& ray, const LaneHit& hit, double weight, int depth,
               double* color) override {
        if constexpr (is_opaque<Tracer>) {
            Contact<double> contact;
            contact.push_back(hit_of(hit));
            put(tracer_.shade(ray_of(ray), contact, weight, depth), color);
        }
    }

    void behind(const double* direction, double* color) override {
        put(color_behind(world_, vector_of(direction)), color);
    }

    void surface(const LaneRay& ray, const LaneHit& hit, LaneSurface& surface) override {
        const Surface<double> s = make_surface(world_, ray_of(ray), hit_of(hit));
        put(s.position, surface.position);
        put(s.position_lo, surface.position_lo);
        put(s.geometric, surface.geometric);
        put(s.normal, surface.normal);
        put(s.color, surface.color);
        surface.error = s.error;
        surface.opacity = s.opacity;
        surface.outermost = s.outermost;
    }

    void light(std::size_t index, const double* position, const double* position_lo,
               LaneLight& light) override {
        const LightSample<double> at =
            sample_light(world_.lights[index], vector_of(position), vector_of(position_lo));
        put(at.direction, light.direction);
        put(at.color, light.color);
        light.distance = at.distance;
    }

    void crossings(std::uint32_t item, const LaneRay& lane_ray, const LaneStart& lane_start,
                   const HitSink& sink) override {
        const Ray<double> ray = ray_of(lane_ray);
        const lancer::Start<double> start = start_of(lane_start);
        const Around around = around_of(lane_start);
        const IntersectionFilter<double, Around> accept(world_, start, around);
        const auto limit = [&] { return sink.limit(sink.self); };
        const RayInterval<double, decltype(limit)> interval{0, limit};
        crossings_from(world_, item, ray, accept, accept.hints(item), interval,
                       [&](const Crossing<double>& c, double u, double v) {
                           if (accept(item, c))
                               sink.add(sink.self, {accept.met_at(c), c.error, u, v, item, c.face,
                                                    c.entering});
                           return false;
                       });
    }

    bool blocks(std::uint32_t item, const LaneRay& lane_ray, const LaneStart& lane_start,
                double distance) override {
        const Ray<double> ray = ray_of(lane_ray);
        const lancer::Start<double> start = start_of(lane_start);
        const NoMedia nowhere;
        const IntersectionFilter<double, NoMedia> accept(world_, start, nowhere);
        OcclusionQuery<double, NoMedia> query{world_, accept, start, distance};
        query.at = item;
        const LightInterval<double, NoMedia> limit{query};
        const RayInterval<double, LightInterval<double, NoMedia>> interval{0, limit};
        crossings_from(world_, item, ray, accept, query.hints(), interval,
                       [&](const Crossing<double>& c, double, double) {
                           if (accept(item, c) && c.t < distance - c.error)
                               query.occlusion = Occlusion::blocked;
                           return query.occlusion == Occlusion::blocked;
                       });
        return query.occlusion == Occlusion::blocked;
    }

    void light_share(const LaneRay& ray, const LaneStart& start, double distance,
                     double* share) override {
        const Ray<double> r = ray_of(ray);
        if constexpr (is_opaque<Tracer>)
            put(light_through(world_, r, distance, start_of(start), NoMedia{}), share);
        else
            put(light_through(world_, r, distance, start_of(start), media_of(start)), share);
    }

  private:
    using Around = std::conditional_t<is_opaque<Tracer>, NoMedia, MediaList>;

    static Around around_of(const LaneStart& start) {
        if constexpr (is_opaque<Tracer>)
            return {};
        else
            return bodies_of(start);
    }
    Media media_of(const LaneStart& start) const {
        Media media{bodies_of(start), {}};
        if (world_.has_smooth_media) media.optical = media.bodies;
        return media;
    }

    const World<double>& world_;
    Tracer tracer_;
};

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

/// The sums of a tile. Beyond so many chains rays go one by one, and take no more memory.
class TileLedger : public Ledger {
  public:
    TileLedger() : Ledger{} {
        grow = [](Ledger& self) { static_cast<TileLedger&>(self).add_room(); };
    }
    TileLedger(const TileLedger&) = delete;
    TileLedger& operator=(const TileLedger&) = delete;

    /// Before any is begun.
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
    if (world_.planes != world_.bounded) return nullptr;  // something in no tree that is no plane
    const wide::Scene& scene = arrays_->flat.scene();
    if (is_all_opaque(world_))
        return std::make_unique<wide::LevelTracer<OpaqueTracer<double>>>(world_, scene, limits,
                                                                         level_);
    // Rays must begin outside of all bodies.
    if (camera.orthographic) return nullptr;
    for (const Bounds<double>& box : world_.medium_bounds)
        if (box.contains(camera.position)) return nullptr;
    return std::make_unique<wide::LevelTracer<Whitted<double>>>(world_, scene, limits, level_);
}

}  // namespace lancer
