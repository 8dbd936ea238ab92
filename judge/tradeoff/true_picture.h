// What settings are judged by: two independent halves of many Sobol points a pixel, with nothing
// cut that could show.
//
// For a picture m and halves h1, h2 of the true values mu, (m - h1)(m - h2) has the mean (m - mu)^2
// (accuracy/audit.h), and what the halves differ by tells how wrong their mean is.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tracer/render.h"

namespace lancer::judge {

/// The scene without tolerances of its surfaces or of its script: all are met where they are.
Scene with_true_surfaces(Scene scene);

class TruePicture {
  public:
    /// \param view, limits  of the picture; the view's crop is what the picture holds
    /// \param seed          of the settings that are judged; the halves draw other points
    TruePicture(const View& view, const TraceLimits& limits, std::uint64_t seed);

    /// Raises the number of points in each pixel of each half. Throws SceneError.
    void refine(const Renderer& renderer, std::uint32_t points, const Progress& progress);

    int width() const { return part_.width; }
    int height() const { return part_.height; }
    std::size_t pixels() const { return sums_[0].size(); }
    /// Of each half, a pixel.
    std::uint32_t points() const { return points_; }
    Color half(unsigned which, std::size_t pixel) const {
        return sums_[which][pixel] / static_cast<double>(points_);
    }
    Color mean(std::size_t pixel) const { return (half(0, pixel) + half(1, pixel)) / 2.0; }
    /// The mean of both halves.
    /// The first points of the pixel that rays were sent through, 64 at most.
    std::vector<PicturePoint> first_points(int x, int y) const;

    Image image() const;
    /// Root mean square of that mean's own error, over pixels and channels, as the halves tell.
    double error() const;

    /// The sums, for a cache: the same on every machine. restore() takes them back; false, and
    /// nothing changes, when they are not those of a picture of this size.
    std::string bytes() const;
    bool restore(std::string_view bytes);

  private:
    View view_;
    TraceLimits limits_;
    std::uint64_t seed_;
    Crop part_;
    std::uint32_t points_ = 0;
    std::array<std::vector<Color>, 2> sums_;
};

}  // namespace lancer::judge
