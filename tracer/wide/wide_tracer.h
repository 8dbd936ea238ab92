// Traces rays side by side, in double. The light and the counts are the same, bit for bit, as those
// of OpaqueTracer and Whitted, in front of which this is one more filter.
#pragma once

#include <array>
#include <memory>

#include "tracer/rays/camera.h"
#include "tracer/rays/ray_counts.h"
#include "tracer/rays/trace_limits.h"
#include "tracer/scene/world.h"
#include "tracer/wide/level.h"

namespace lancer {

/// Points of the picture, in pixels, through which rays are traced together. Batches of
/// neighbouring points are fast.
struct RayBatch {
    static constexpr int most = 256;

    std::array<double, most + 8> x, y;  ///< whole vectors are read
    std::array<Vec3d, most> color;      ///< result: the colours of the rays
    int count = 0;
};

/// Traces rays through one world. One object per thread, because it counts rays.
class WideTracer {
  public:
    virtual ~WideTracer() = default;

    /// \param width, height  of the whole picture
    virtual void trace(const CameraFrame<double>& camera, int width, int height,
                       RayBatch& batch) = 0;
    virtual RayCounts counts() const = 0;
};

/// A world with the arrays that wide code reads.
class WideWorld {
  public:
    /// \param level  not `scalar`, and supported
    WideWorld(const World<double>& world, Level level);
    ~WideWorld();

    Level level() const { return level_; }

    /// Null if rays must be traced one by one: in a world with an unbounded composite; for a camera
    /// far from the scene; for limits that cut even camera rays; and, in worlds that are not all
    /// opaque, for an orthographic camera or one that may be inside a body.
    std::unique_ptr<WideTracer> tracer(const TraceLimits& limits,
                                       const CameraFrame<double>& camera) const;

  private:
    struct Arrays;

    const World<double>& world_;
    const Level level_;
    std::unique_ptr<const Arrays> arrays_;
};

}  // namespace lancer
