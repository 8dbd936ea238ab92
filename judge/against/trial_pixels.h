// Sample points of a picture at which explanations are tested: few enough to be cheap, and enough
// to decide.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/image.h"
#include "model/scene.h"
#include "tracer/render.h"

namespace lancer::judge {

/// Some pixels of a picture: those that differ, and others that must not be spoilt.
struct TrialPixels {
    std::vector<PicturePoint> points;  ///< where the other program is taken to look
    std::vector<Color> ours;
    std::vector<Color> theirs;
    /// the number of different points, which come first; the others agree
    std::size_t different = 0;
    double tolerance = 1e-4;
    double exposure = 1;
    bool clipped = false;  ///< their values are at most 1, so ours are clipped, too
};

/// Every n-th of the points that differ, so that there are about `most`.
TrialPixels few_of(const TrialPixels& samples, std::size_t most);

/// Renders variants of the scene at the samples' points, in the units of the other picture.
class VariantTracer {
  public:
    VariantTracer(const View& view, const TrialPixels& samples) : view_(view), samples_(samples) {}

    /// The colours of `scene` at the samples' points. Throws SceneError.
    std::vector<Color> trace(const Scene& scene) const;
    /// The same with one renderer, for several sets of points.
    std::vector<Color> trace(const Renderer& renderer, const Settings& settings,
                             const std::vector<PicturePoint>& points) const;
    const View& view() const { return view_; }

  private:
    View view_;
    const TrialPixels& samples_;
};

/// An explanation: its words, and the picture that it predicts.
struct Explanation {
    std::string words;  ///< a sentence without a full stop
    std::vector<Color> colors;
    bool is_shift = false;
    /// Per sample: 1 where the explanation predicts nothing, for example outside of the picture.
    /// Empty: it predicts all.
    std::vector<std::uint8_t> left_out{};
};

/// The effect of an explanation on the samples.
struct Effect {
    double repaired = 0;  ///< share of the different samples that agree with it
    double spoilt = 0;    ///< share of the other samples that no longer agree

    /// Nearly all are repaired, and hardly any is spoilt; some at edges may be.
    bool convinces() const { return repaired >= 0.9 && spoilt <= 0.02; }
    bool is_perfect() const { return repaired >= 0.995 && spoilt <= 0.001; }
};

/// Its colours are not clipped yet.
Effect effect_of(const TrialPixels& samples, const Explanation& explanation);

/// A value as the other picture would hold it.
Color as_held(const Color& color, const TrialPixels& samples);

}  // namespace lancer::judge
