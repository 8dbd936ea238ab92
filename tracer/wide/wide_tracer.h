// Rays side by side through a world in double: the same light, bit for bit, and the same counts as
// OpaqueTracer and Whitted, one more filter in front of them.
#pragma once

#include <array>
#include <memory>

#include "tracer/rays/camera.h"
#include "tracer/rays/ray_counts.h"
#include "tracer/rays/trace_limits.h"
#include "tracer/scene/world.h"
#include "tracer/wide/level.h"

namespace lancer {

/// Points of the picture, in pixels, that rays are sent through together; neighbours side by side
/// are fast.
struct RayBatch {
    static constexpr int most = 256;

    std::array<double, most + 8> x, y;  ///< whole vectors are read
    std::array<Vec3d, most> color;      ///< what the rays brought
    int count = 0;
};

/// Traces rays through one world. One object per thread: it counts what it does.
class WideTracer {
  public:
    virtual ~WideTracer() = default;

    /// \param width, height  of the whole picture
    virtual void trace(const CameraFrame<double>& camera, int width, int height,
                       RayBatch& batch) = 0;
    virtual RayCounts counts() const = 0;
};

/// What wide code reads of a world, beside the world.
class WideWorld {
  public:
    /// \param level  not `scalar`, and supported
    WideWorld(const World<double>& world, Level level);
    ~WideWorld();

    Level level() const { return level_; }

    /// Null where rays go one by one: in a world with a composite that has no bounds, from a camera
    /// far from the scene, or, in worlds with media, from one that may be in a body or has no
    /// place.
    std::unique_ptr<WideTracer> tracer(const TraceLimits& limits,
                                       const CameraFrame<double>& camera) const;

  private:
    struct Arrays;

    const World<double>& world_;
    const Level level_;
    std::unique_ptr<const Arrays> arrays_;
};

}  // namespace lancer
