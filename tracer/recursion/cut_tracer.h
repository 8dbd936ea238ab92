// The recursion without its light: which share of it the limits leave out.
#pragma once

#include <memory>

#include "tracer/rays/ray.h"
#include "tracer/rays/trace_limits.h"
#include "tracer/scene/world.h"
#include "tracer/shading/probe_record.h"

namespace lancer {

/// Traces the rays that Whitted or OpaqueTracer would, whichever the world takes, and none to
/// lights. One object per thread.
template <class Real>
class CutTracer {
  public:
    CutTracer(const World<Real>& world, const TraceLimits& limits);
    ~CutTracer();
    CutTracer(const CutTracer&) = delete;
    CutTracer& operator=(const CutTracer&) = delete;

    /// In place of a colour, the sum that CutRecorder forms. Parameters: see Whitted.
    Vec3<Real> camera_ray(const Ray<Real>& ray, Real at_camera, const Ray<Real>& from_camera,
                          ProbeRecord<Real>* record);

  private:
    struct Tracers;
    std::unique_ptr<Tracers> tracers_;
};

}  // namespace lancer
