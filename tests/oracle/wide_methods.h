// The scalar code behind wide kernels, for tests and benches that leave nothing to it, or little.
#pragma once

#include "tracer/wide/exact_methods.h"

namespace lancer::oracle {

class NoMethods : public wide::ExactMethods {
  public:
    void trace(const wide::LaneRay&, const wide::LaneStart&, double, int, double*) override {}
    void follow(const wide::LaneRay&, const wide::LaneStart&, double, int, const double*,
                const wide::LightSink&) override {}
    void shade(const wide::LaneRay&, const wide::LaneHit&, double, int, double*) override {}
    void behind(const double*, double*) override {}
    void surface(const wide::LaneRay&, const wide::LaneHit&, wide::LaneSurface&) override {}
    void light(std::size_t, const double*, const double*, wide::LaneLight&) override {}
    void crossings(std::uint32_t, const wide::LaneRay&, const wide::LaneStart&,
                   const wide::HitSink&) override {}
    void patch(std::uint32_t, wide::PatchShape&) override {}
    void piece_crossings(const wide::PatchPiece&, const wide::PieceLine&, const wide::PlanePart*,
                         const wide::HitSink&) override {}
    bool blocks(std::uint32_t, const wide::LaneRay&, const wide::LaneStart&, double) override {
        return false;
    }
    void light_share(const wide::LaneRay&, const wide::LaneStart&, double, double*) override {}

  protected:
    ~NoMethods() = default;
};

}  // namespace lancer::oracle
