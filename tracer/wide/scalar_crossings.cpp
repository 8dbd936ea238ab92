#include "tracer/wide/scalar_crossings.h"

#include "tracer/intersect/occlusion_build.h"

namespace lancer::wide {
namespace {

template <class Bodies>
void cross(const Geometry<double>& geometry, std::uint32_t item, const LaneRay& lane_ray,
           const LaneStart& lane_start, const Bodies& bodies, const HitSink& sink) {
    const Ray<double> ray = ray_of(lane_ray);
    const lancer::Start<double> start = start_of(lane_start);
    const IntersectionFilter<double, Bodies> accept(geometry, start, bodies);
    const auto limit = [&] { return sink.limit(sink.self); };
    const RayInterval<double, decltype(limit)> interval{0, limit};
    crossings_from(
        geometry, item, ray, accept, accept.hints(item), interval,
        [&](const Crossing<double>& c, double u, double v) {
            if (accept(item, c))
                sink.add(sink.self, {accept.met_at(c), c.error, u, v, item, c.face, c.entering});
            return false;
        });
}

}  // namespace

void cross_item(const Geometry<double>& geometry, std::uint32_t item, const LaneRay& ray,
                const LaneStart& start, bool listed, const HitSink& sink) {
    if (listed)
        cross(geometry, item, ray, start, list_of(start.bodies), sink);
    else
        cross(geometry, item, ray, start, NoMedia{}, sink);
}

bool blocks_light(const Geometry<double>& geometry, std::uint32_t item, const LaneRay& lane_ray,
                  const LaneStart& lane_start, double distance) {
    const Ray<double> ray = ray_of(lane_ray);
    const lancer::Start<double> start = start_of(lane_start);
    const NoMedia nowhere;
    const IntersectionFilter<double, NoMedia> accept(geometry, start, nowhere);
    OcclusionQuery<double, NoMedia> query{geometry, accept, start, distance};
    query.at = item;
    const LightInterval<double, NoMedia> limit{query};
    const RayInterval<double, LightInterval<double, NoMedia>> interval{0, limit};
    crossings_from(geometry, item, ray, accept, query.hints(), interval,
                   [&](const Crossing<double>& c, double, double) {
                       if (accept(item, c) && c.t < distance - c.error)
                           query.occlusion = Occlusion::blocked;
                       return query.occlusion == Occlusion::blocked;
                   });
    return query.occlusion == Occlusion::blocked;
}

}  // namespace lancer::wide
