// A picture that gets better pass by pass, for as long as there is time.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "accuracy/error_picture.h"
#include "accuracy/limits.h"

namespace lancer::accuracy {

/// Which pixels each pass gives more samples: first one everywhere, then a second in eighths of the
/// picture, then twice as many where that helps most. What a pass does depends on its number and on
/// the samples of those before.
class Passes {
  public:
    explicit Passes(const PictureSamples& samples) : samples_(samples) {}

    /// The numbers of samples after the next pass. Empty: 16 bits show no error that is left.
    std::vector<std::uint32_t> next();
    int made() const { return made_; }
    /// Rays of an audit through the image plane, a draw, as predicted now and then.
    double rays_per_draw() const { return rays_per_draw_; }

  private:
    void plan();

    const PictureSamples& samples_;
    int made_ = 0;
    Prediction prediction_;
    double rays_per_draw_ = 32;
    std::vector<std::size_t> planned_;  ///< pixels to be doubled, the best last
};

struct PassGoal {
    std::uint64_t seed = 0;
    bool audited = true;
    FixedLimits fixed;
};

/// What is known before each pass.
struct PassState {
    int passes = 0;                 ///< that were made
    const PictureSamples& samples;  ///< every pixel has some after the first pass
    std::uint64_t rays = 0;         ///< through the image plane, up to now, of all kinds of work
    std::uint64_t next = 0;         ///< that the next pass will take
    std::uint64_t audits = 0;  ///< that audits would take if it were the last; 0: none is wanted
};
/// False ends the work before the pass.
using GoOn = std::function<bool(const PassState&)>;

/// Passes until `go_on` says no, the first always, or until there is nothing left to mend; then
/// audits, the first of which decides whether the error is told. The bytes of the picture depend on
/// the number of passes alone. Throws SceneError, and what `go_on` throws.
///
/// \param renderer  makes the picture; may be the truth's own
ErrorPicture render_by_passes(const Renderer& renderer, const Truth& truth, const View& view,
                              const PassGoal& goal, const GoOn& go_on);

}  // namespace lancer::accuracy
