// Renders a scene. This is the public interface of the folder; it hides the number type.
#pragma once

#include <cstdint>
#include <functional>
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

/// The picture of the scene that is wanted.
struct View {
    std::size_t camera = 0;  ///< index into Scene::cameras
    int width = 640;
    int height = 480;
    std::optional<Crop> crop;  ///< if set, only these pixels; the image has the crop's size
    bool aov = false;          ///< also object id, depth, normal and shadow, see render()
    bool alpha = false;        ///< a fourth channel, see render()
};

/// A point of the image plane, in pixels of the whole picture: (0.5, 0.5) is the centre of the
/// first pixel.
struct PicturePoint {
    double x = 0;
    double y = 0;
};

/// An image without pixels that has the form of the picture.
Image form_of(const View& view);

/// Receives the finished tiles of a picture: their pixels, and where they begin in it. Called once
/// for each tile, from several threads at once.
using TakeTile = std::function<void(int x, int y, const Image& tile)>;

/// Counts of a compiled scene.
struct WorldCounts {
    std::uint64_t shapes = 0;
    std::uint64_t triangles = 0;
    std::uint64_t lights = 0;
    std::uint64_t nodes = 0;  ///< of all acceleration structures
};

/// The colour of one camera ray, and what it met first; for judging differences.
struct Probe {
    Color color{0, 0, 0};
    std::uint32_t object = none;  ///< index into Scene::objects; none: background
    double depth = 0;  ///< distance along the ray from its origin at the camera, in scene units
    Vec3d normal{0, 0, 0};  ///< shading normal, towards the viewer; 0 for the background
    /// One bit for each of the first 64 lights: its light reaches the point, at least in part.
    std::uint64_t lit = 0;
    /// A hash of all discrete events: objects, faces and shadows that the rays of the tree met, but
    /// not texture cells. Probes with equal paths differ only continuously.
    std::uint64_t path = 0;
    std::uint64_t rays = 0;  ///< number of rays of all kinds that were traced for it
};

/// A compiled scene: acceleration structures built, matrices inverted. Safe to use from many
/// threads.
class Renderer {
  public:
    virtual ~Renderer() = default;

    /// Renders the picture in linear light. The bytes are the same for any number of threads. With
    /// `view.aov` it has the extra channels object.id, depth.Z, normal.X, normal.Y, normal.Z and
    /// shadow.Y (the share of the lights that do not reach the point), computed by the ray through
    /// the pixel's centre. With `view.alpha` it has an alpha channel: the background's light is
    /// left out of the colours, and alpha is 1 minus the background's share, the mean over the
    /// channels. Background seen through glass counts, background in mirrors does not. Throws
    /// SceneError if light overflows the number type.
    Image render(const View& view, const Progress& progress, RayCounts& counts) const;

    /// The same tile by tile, so that no picture need be held. If light overflows, all tiles come
    /// before the exception.
    virtual void render_tiles(const View& view, const TakeTile& take, const Progress& progress,
                              RayCounts& counts) const = 0;

    /// Traces one ray through each of the points. colors[i] is the colour of points[i] in linear
    /// light. Its bits do not depend on the number of threads or on the other points. Large batches
    /// in which neighbours are adjacent are fast. Points may lie anywhere; the view's crop is
    /// ignored. limits.max_depth must be at most that of the settings. Adds to `counts`. Throws
    /// SceneError as render() does.
    virtual void trace(const View& view, std::span<const PicturePoint> points,
                       const TraceLimits& limits, std::span<Color> colors, const Progress& progress,
                       RayCounts& counts) const = 0;

    /// The shares of light that trace() leaves out. shares[i] is the sum, over all branches of
    /// points[i]'s ray that the limits end, of the product of all factors on the path, per channel.
    /// No light is computed. A branch that was cut would contribute at most this share of the light
    /// that it would have met.
    virtual void cut_shares(const View& view, std::span<const PicturePoint> points,
                            const TraceLimits& limits, std::span<Color> shares,
                            const Progress& progress) const = 0;

    /// The points through which render() traces rays for the pixel at column x, row y of the whole
    /// picture, in the order in which their light is summed.
    virtual std::vector<PicturePoint> samples(int x, int y) const = 0;

    /// Traces one ray through the point (x, y) of the image plane, see PicturePoint.
    virtual Probe probe(const View& view, double x, double y) const = 0;

    virtual WorldCounts counts() const = 0;

    /// The level in use: how many rays go side by side. Scalar for types other than double.
    virtual Level level() const = 0;
};

/// Compiles a scene. Throws SceneError, e.g. if coordinates leave the number type's range.
///
/// \param level  the fastest level that may be used; the processor must support it. Pictures are
///               the same on all levels
std::unique_ptr<Renderer> compile(const Scene& scene, const Settings& settings,
                                  Level level = best_level());

/// For the judge: a renderer with its own recursion (tracer/povray/recursion.h), in double
/// precision. It follows POV-Ray's rules, or ours if `rules.followed` is false. Throws SceneError
/// as compile() does.
std::unique_ptr<Renderer> compile_by_povray(const Scene& scene, const Settings& settings,
                                            const PovRayRules& rules);

}  // namespace lancer
