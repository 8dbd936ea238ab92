// Pictures that are formulas of the image plane: their truth is known without the estimator.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tracer/render.h"

namespace lancer::accuracy {

using Formula = std::function<Color(double x, double y, const TraceLimits& limits)>;

/// A renderer whose rays return the values of a formula. One thread, no geometry.
class PlainRenderer final : public Renderer {
  public:
    explicit PlainRenderer(Formula formula) : formula_(std::move(formula)) {}

    void render_tiles(const View& view, const TakeTile& take, const Progress& progress,
                      RayCounts& counts) const override;
    void trace(const View& view, std::span<const PicturePoint> points, const TraceLimits& limits,
               std::span<Color> colors, const Progress& progress, RayCounts& counts) const override;
    /// A formula has no known cuts.
    void cut_shares(const View&, std::span<const PicturePoint>, const TraceLimits&,
                    std::span<Color> shares, const Progress&) const override {
        std::fill(shares.begin(), shares.end(), Color(0));
    }
    std::vector<PicturePoint> samples(int x, int y) const override { return {{x + 0.5, y + 0.5}}; }
    Probe probe(const View& view, double x, double y) const override;
    Level level() const override { return Level::scalar; }
    WorldCounts counts() const override { return {}; }

  private:
    Formula formula_;
};

/// 128 x 96 pixels.
View view_of_128();

/// Hard cases and easy ones for that view.
struct PlainPicture {
    std::string name;
    Formula formula;
};
const std::vector<PlainPicture>& plain_pictures();
const Formula& plain_picture(const std::string& name);

/// The mean over each pixel, from fine x fine points a pixel that no sampler shares.
Image truth_of(const Formula& formula, const View& view, int fine = 32);

/// The root mean squared difference over pixels and the first three channels.
double rms_difference(const Image& a, const Image& b);

}  // namespace lancer::accuracy
