// Renders a picture of which at most a given share of pixels is off, and reports that share.
#pragma once

#include "accuracy/error_picture.h"
#include "accuracy/error_target.h"

namespace lancer::accuracy {

struct OffGoal {
    double share = 0.01;  ///< of the pixels, from least_share to 1
    double steps = 2;     ///< threshold in steps of 8 bits, each 1/255 in linear light
    std::uint64_t seed = 0;
    bool audited = true;  ///< false: only the picture's own rays are traced; no interval
    FixedLimits fixed;
    bool leaves_out = false;            ///< as in ErrorGoal
    double most_rays_per_pixel = 1024;  ///< on average
    std::optional<PictureRows> rows;    ///< as in ErrorGoal

    double threshold() const { return steps / 255; }
};

/// The smallest share that can be asked for; a smaller one would take too many draws.
inline constexpr double least_share = 0.0003;

/// Renders the picture with about the fewest rays for which at most goal.share of the pixels are
/// off by more than goal.steps, by an audit with 95 % confidence. Deciding audits choose whether to
/// go on. One more audit, with fresh draws, is taken once at the end and reported whatever it says.
/// The bytes are the same for any number of threads. Throws Unreachable, SceneError.
///
/// \param renderer  makes the picture; may be the truth's own
ErrorPicture render_to_share(const Renderer& renderer, const Truth& truth, const View& view,
                             const OffGoal& goal, const Progress& progress);

}  // namespace lancer::accuracy
