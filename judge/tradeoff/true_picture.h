// The truth for settings: two independent halves with many Sobol points a pixel, cutting nothing
// that could be visible.
//
// For a picture m and halves h1, h2 of the true values mu, (m - h1)(m - h2) has the mean (m - mu)^2
// (accuracy/audit.h). The difference of the halves gives the error of their mean.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tracer/render.h"

namespace lancer::judge {

/// The scene without the tolerances of its surfaces and of its script: all surfaces are exact.
Scene with_true_surfaces(Scene scene);

class TruePicture {
  public:
    /// \param view, limits  of the picture; the view's crop is the part that the picture holds
    /// \param seed          of the judged settings; the halves draw other points
    TruePicture(const View& view, const TraceLimits& limits, std::uint64_t seed);

    /// Raises the number of points in each pixel of each half. Throws SceneError.
    void refine(const Renderer& renderer, std::uint32_t points, const Progress& progress);

    int width() const { return part_.width; }
    int height() const { return part_.height; }
    std::size_t pixels() const { return sums_[0].size(); }
    /// The number of points per pixel in each half.
    std::uint32_t points() const { return points_; }
    Color half(unsigned which, std::size_t pixel) const {
        return sums_[which][pixel] / static_cast<double>(points_);
    }
    Color mean(std::size_t pixel) const { return (half(0, pixel) + half(1, pixel)) / 2.0; }
    /// The first points in the pixel through which rays went, at most 64.
    std::vector<PicturePoint> first_points(int x, int y) const;

    /// The mean of both halves.
    Image image() const;
    /// The root mean square of the error of image(), over pixels and channels, estimated from the
    /// halves.
    double error() const;

    /// The sums in a form for a cache, the same on every machine. restore() reads them; it returns
    /// false and changes nothing when they do not belong to a picture of this size.
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
