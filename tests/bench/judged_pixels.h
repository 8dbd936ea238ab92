// Measures errors of pictures of a scene in some thousand pixels, one drawn from each of as many
// squares. So the truth takes as long for a large picture as for a small one.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/scene.h"
#include "tracer/render.h"

namespace lancer::accuracy {

/// Throws std::runtime_error.
Scene load_scene(const std::string& path);

/// The scene's renderer without limits that matter, from true surfaces.
std::unique_ptr<Renderer> uncut_renderer(const Scene& scene);
inline constexpr TraceLimits uncut_limits{1000, 1e-6};

/// The pixels in which errors are measured, and their true values.
class Judge {
  public:
    Judge(const Renderer& renderer, const View& view);

    /// RMSE of values in the pixels.
    double error(const std::vector<Color>& values) const;
    double error(const Image& picture) const;

    struct Pixel {
        int x = 0;
        int y = 0;
    };
    /// A pixel's sample of this index.
    using PointOf = std::function<PicturePoint(const Pixel&, std::uint32_t index)>;
    /// Receives the means over the first samples of each pixel; returns false when they are enough.
    using Take = std::function<bool(std::uint32_t samples, const std::vector<Color>& means)>;
    /// The means over the first, the first two ... samples of each pixel. Adds to `rays`.
    void means(std::uint32_t most, const TraceLimits& limits, const PointOf& point_of,
               RayCounts& rays, const Take& take) const;

    /// The same for n x n points on a grid.
    static PicturePoint grid_point(const Pixel& pixel, std::uint32_t index, std::uint32_t n);
    static PicturePoint sobol_point(const Pixel& pixel, std::uint32_t index, std::uint64_t seed = 0,
                                    std::uint64_t stream = 0);
    std::size_t size() const { return pixels_.size(); }

  private:
    const Renderer& renderer_;
    const View& view_;
    std::vector<Pixel> pixels_;
    std::array<std::vector<Color>, 2> truth_;
};

}  // namespace lancer::accuracy
