// The recursion with a recorder of its ray tree.
#pragma once

#include "tracer/rays/ray.h"
#include "tracer/rays/ray_tree.h"
#include "tracer/rays/trace_limits.h"
#include "tracer/scene/world.h"
#include "tracer/shading/probe_record.h"

namespace lancer {

/// Traces one camera ray by Whitted or OpaqueTracer (whichever the world needs), and records it in
/// `tree`.
template <class Real>
class RecordedTracer {
  public:
    RecordedTracer(const World<Real>& world, const TraceLimits& limits, RayTree& tree)
        : world_(world), limits_(limits), tree_(tree) {}

    /// See Whitted.
    Vec3<Real> camera_ray(const Ray<Real>& ray, Real at_camera, const Ray<Real>& from_camera,
                          ProbeRecord<Real>* record);

  private:
    const World<Real>& world_;
    const TraceLimits limits_;
    RayTree& tree_;
};

}  // namespace lancer
