// The recursion without light: computes the share of light that the limits can leave out.
#pragma once

#include <memory>

#include "tracer/rays/ray.h"
#include "tracer/rays/trace_limits.h"
#include "tracer/scene/world.h"
#include "tracer/shading/probe_record.h"

namespace lancer {

/// Traces the same rays as Whitted or OpaqueTracer (whichever the world needs), but no shadow rays.
/// One object per thread.
template <class Real>
class CutTracer {
  public:
    CutTracer(const World<Real>& world, const TraceLimits& limits);
    ~CutTracer();
    CutTracer(const CutTracer&) = delete;
    CutTracer& operator=(const CutTracer&) = delete;

    /// Returns the sum of CutRecorder in place of a colour. Parameters: see Whitted.
    Vec3<Real> camera_ray(const Ray<Real>& ray, Real at_camera, const Ray<Real>& from_camera,
                          ProbeRecord<Real>* record);

  private:
    struct Tracers;
    std::unique_ptr<Tracers> tracers_;
};

}  // namespace lancer
