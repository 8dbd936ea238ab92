// The scalar code that answers for a lane which is unsure: one ray at a time, from a lane's form
// and back.
#pragma once

#include <type_traits>

#include "tracer/recursion/opaque.h"
#include "tracer/recursion/whitted.h"
#include "tracer/wide/exact_methods.h"
#include "tracer/wide/flat_patches.h"
#include "tracer/wide/plain_vector.h"
#include "tracer/wide/scalar_crossings.h"

namespace lancer::wide {

inline Hit<double> hit_of(const LaneHit& h) {
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

    void crossings(std::uint32_t item, const LaneRay& ray, const LaneStart& start,
                   const HitSink& sink) override {
        cross_item(world_, item, ray, start, !is_opaque<Tracer>, sink);
    }

    void patch(std::uint32_t item, PatchShape& shape) override {
        shape =
            shape_of(std::get<BicubicSolid<double>>(world_.primitives[item].solid).surface->tree());
    }

    void piece_crossings(const PatchPiece& piece, const PieceLine& line, const PlanePart* part,
                         const HitSink& sink) override {
        cross_piece(piece, line, part, sink);
    }

    bool blocks(std::uint32_t item, const LaneRay& ray, const LaneStart& start,
                double distance) override {
        return blocks_light(world_, item, ray, start, distance);
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
    static Media media_of(const LaneStart& start) {
        return {list_of(start.bodies), list_of(start.optical)};
    }

    const World<double>& world_;
    Tracer tracer_;
};

}  // namespace lancer::wide
