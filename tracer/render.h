// Scene → picture. The folder's public face; the number type is chosen behind it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "model/image.h"
#include "model/scene.h"
#include "model/settings.h"
#include "model/shapes.h"
#include "tracer/rays/ray_counts.h"
#include "tracer/rays/trace_limits.h"
#include "tracer/scene/povray_rules.h"
#include "tracer/wide/level.h"

namespace lancer {

/// A rectangle of pixels, from the picture's top left corner.
struct Crop {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// Which picture of the scene.
struct View {
    std::size_t camera = 0;  ///< index into Scene::cameras
    int width = 640;
    int height = 480;
    std::optional<Crop> crop;  ///< only these pixels; the result has the crop's size
    bool aov = false;          ///< also object id, depth, normal and shadow, see render()
    bool alpha = false;        ///< a fourth channel, see render()
};

/// A place of the image plane in pixels of the whole picture: (0.5, 0.5) is the centre of the
/// first.
struct PicturePoint {
    double x = 0;
    double y = 0;
};

/// What there is to count in a compiled scene.
struct WorldCounts {
    std::uint64_t shapes = 0;
    std::uint64_t triangles = 0;
    std::uint64_t lights = 0;
    std::uint64_t nodes = 0;  ///< of all acceleration structures
};

/// What one ray through the image plane brought, and what it met first: for judging differences.
struct Probe {
    Color color{0, 0, 0};
    std::uint32_t object = none;  ///< index into Scene::objects; none: background
    double depth = 0;  ///< distance from the camera's plane of origin along the ray, scene units
    Vec3d normal{0, 0, 0};  ///< shading normal, towards the viewer; 0 for the background
    /// Per light (the first 64) one bit: its light reaches the point, at least in part.
    std::uint64_t lit = 0;
    /// Hash of everything discrete on the way: objects, faces and shadows met by all rays of the
    /// tree, texture cells left out. Two probes with equal paths differ only by smooth amounts.
    std::uint64_t path = 0;
    std::uint64_t rays = 0;  ///< of all kinds that were traced for it
};

/// A compiled scene: acceleration structures built, matrices inverted. Safe to use from many
/// threads.
class Renderer {
  public:
    virtual ~Renderer() = default;

    /// The picture in linear light, the same bytes for any number of threads. With `view.aov` it
    /// has the extra channels object.id, depth.Z, normal.X, normal.Y, normal.Z, shadow.Y (share of
    /// the lights that do not reach the point), taken by the ray through the pixel's centre. With
    /// `view.alpha` it has alpha: what rays bring that hit nothing is left out of the colours, and
    /// alpha is 1 less the share that it had, the mean of the channels. Light that glass passes or
    /// bends counts, mirrors stay as they are. Throws SceneError when light leaves the number
    /// type's range.
    virtual Image render(const View& view, const Progress& progress, RayCounts& counts) const = 0;

    /// One ray through each of the points: colors[i] is the light, linear, that points[i] brings,
    /// the same bits for any number of threads and whatever points stand beside it. Large batches
    /// with neighbours together are fast. Points may lie anywhere; the view's crop is not looked
    /// at; recursion may be limited below the settings, not above. Adds to `counts`. Throws
    /// SceneError as render() does.
    virtual void trace(const View& view, std::span<const PicturePoint> points,
                       const TraceLimits& limits, std::span<Color> colors, const Progress& progress,
                       RayCounts& counts) const = 0;

    /// What trace() leaves out: shares[i] is the sum over the branches of points[i]'s ray that the
    /// limits end, by channel, of the product of all factors along the way. No light is computed. A
    /// branch that was cut would bring at most that share of the light that it would have met.
    virtual void cut_shares(const View& view, std::span<const PicturePoint> points,
                            const TraceLimits& limits, std::span<Color> shares,
                            const Progress& progress) const = 0;

    /// The points of the pixel at column x, row y of the whole picture that render() sends rays
    /// through, in the order in which their light is summed.
    virtual std::vector<PicturePoint> samples(int x, int y) const = 0;

    /// One ray through the point (x, y) of the image plane, in pixels: (0.5, 0.5) is the centre of
    /// the first pixel.
    virtual Probe probe(const View& view, double x, double y) const = 0;

    virtual WorldCounts counts() const = 0;

    /// How many rays go side by side, where they do: scalar in other types than double.
    virtual Level level() const = 0;
};

/// Builds what rendering needs. Throws SceneError, e.g. for coordinates that leave the number
/// type's range.
///
/// \param level  the fastest that may be used; supported here. Pictures are the same on all
std::unique_ptr<Renderer> compile(const Scene& scene, const Settings& settings,
                                  Level level = best_level());

/// For the judge: a renderer with a recursion of its own (tracer/povray/recursion.h), by POV-Ray's
/// rules or, where they are not `followed`, by ours; in double precision. Throws SceneError as
/// compile() does.
std::unique_ptr<Renderer> compile_by_povray(const Scene& scene, const Settings& settings,
                                            const PovRayRules& rules);

}  // namespace lancer
