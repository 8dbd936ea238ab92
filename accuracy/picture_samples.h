// The samples of a picture that is being made, summed per pixel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracer/render.h"

namespace lancer::accuracy {

/// The samples of one pixel, summed.
struct PixelSums {
    Color sum{0, 0, 0};
    double squares = 0;  ///< of all samples and channels
    std::uint32_t count = 0;

    void add(const Color& sample);
    Color mean() const { return sum / static_cast<double>(count); }
    /// Unbiased variance of the samples, summed over channels; 0 for a single sample.
    double variance() const;
};

/// Rows of a picture, from the top of its crop.
struct RowRange {
    int first = 0;
    int count = 0;
};

/// The rows of one part of a picture. Predictions about a pixel use only the neighbours in the same
/// part.
struct PictureRows {
    int part = 0;                  ///< from 0; the audits of different parts draw independently
    int parts = 1;                 ///< number of parts of the whole picture
    std::vector<RowRange> ranges;  ///< from the top; empty for all rows
};

/// A picture whose pixels have as many samples as each needs, at its own Owen-scrambled Sobol
/// points. What a pixel holds depends on its place, the seed and the number of its samples alone.
class PictureSamples {
  public:
    /// The renderer and the view must outlive the object. With a crop the picture is that part;
    /// with `rows` these of it, laid one below the other.
    PictureSamples(const Renderer& renderer, const View& view, const TraceLimits& limits,
                   std::uint64_t seed, const PictureRows& rows = {});

    int width() const { return crop_.width; }
    int height() const { return static_cast<int>(rows_.size()); }
    std::size_t size() const { return pixels_.size(); }
    const std::vector<PixelSums>& pixels() const { return pixels_; }
    const RayCounts& rays() const { return rays_; }
    std::uint64_t seed() const { return seed_; }
    const View& view() const { return view_; }
    /// A pixel's place in the whole picture.
    int column(std::size_t pixel) const;
    int row(std::size_t pixel) const;
    /// The index of the pixel at this place, which must be one of these samples.
    std::size_t pixel_at(int column, int row) const;
    /// Whether rows y and `other` of these samples are as far apart in the whole picture as here.
    bool are_near(int y, int other) const {
        return rows_[static_cast<std::size_t>(other)] - rows_[static_cast<std::size_t>(y)] ==
               other - y;
    }
    /// A random key for choices that belong to no pixel. Keys of different parts are independent.
    std::uint64_t key(std::uint64_t stream) const;

    /// Raises each pixel's number of samples to wanted[pixel], unless it has as many already.
    void raise(std::span<const std::uint32_t> wanted, const Progress& progress);

    /// The means, in linear light; every pixel must have a sample.
    Image image() const;

  private:
    struct Run {
        std::size_t pixel;
        std::uint32_t points;
    };
    void trace(const std::vector<Run>& runs, const std::vector<PicturePoint>& points);

    const Renderer& renderer_;
    const View& view_;
    TraceLimits limits_;
    std::uint64_t seed_;
    Crop crop_;
    int part_;
    std::vector<int> rows_;  ///< row numbers in the whole picture
    std::vector<PixelSums> pixels_;
    RayCounts rays_;
};

/// Number of rays per batch: enough work for all cores, little memory.
inline constexpr std::size_t batch_size = std::size_t(1) << 17;

}  // namespace lancer::accuracy
