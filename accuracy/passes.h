// Renders a picture in passes, each of which improves it, for as long as there is time.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "accuracy/error_picture.h"
#include "accuracy/limits.h"

namespace lancer::accuracy {

/// Decides which pixels get more samples in each pass. The first pass gives one sample to every
/// pixel. The next 8 give a second sample to an eighth of the pixels each. Later passes double the
/// samples where that helps most. A pass depends only on its number and on the samples before it.
class Passes {
  public:
    explicit Passes(const PictureSamples& samples) : samples_(samples) {}

    /// The numbers of samples after the next pass. Empty when 16 bits could not show the predicted
    /// error.
    std::vector<std::uint32_t> next();
    int made() const { return made_; }
    /// Predicted camera rays per draw of an audit; updated from time to time.
    double rays_per_draw() const { return rays_per_draw_; }

  private:
    void plan();

    const PictureSamples& samples_;
    int made_ = 0;
    Prediction prediction_;
    double rays_per_draw_ = 32;
    std::vector<std::size_t> planned_;  ///< pixels whose samples will be doubled, the best last
};

struct PassGoal {
    std::uint64_t seed = 0;
    bool audited = true;
    FixedLimits fixed;
};

/// The state before a pass. Rays are camera rays.
struct PassState {
    int passes = 0;                 ///< that were made
    const PictureSamples& samples;  ///< every pixel has some after the first pass
    std::uint64_t rays = 0;         ///< through the image plane, up to now, of all kinds of work
    std::uint64_t next = 0;         ///< that the next pass will take
    std::uint64_t audits = 0;  ///< that audits would take if it were the last; 0: none is wanted
};
/// False ends the work before the pass.
using GoOn = std::function<bool(const PassState&)>;

/// Makes passes until `go_on` returns false or no visible error is left; the first pass is always
/// made. Two audits follow. The first decides whether the error is told, the second is printed. The
/// bytes of the picture depend only on the number of passes. Throws SceneError, and what `go_on`
/// throws.
///
/// \param renderer  makes the picture; may be the truth's own
ErrorPicture render_by_passes(const Renderer& renderer, const Truth& truth, const View& view,
                              const PassGoal& goal, const GoOn& go_on);

}  // namespace lancer::accuracy
