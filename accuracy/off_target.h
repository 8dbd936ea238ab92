// A picture of which few pixels are off, and which tells how many are.
#pragma once

#include "accuracy/error_picture.h"
#include "accuracy/error_target.h"

namespace lancer::accuracy {

struct OffGoal {
    double share = 0.01;  ///< of the pixels, from least_share to 1
    double steps = 2;     ///< of 8 bits, each 1/255 in linear light
    std::uint64_t seed = 0;
    bool audited = true;  ///< false: no ray beside those of the picture, and no interval
    FixedLimits fixed;
    bool leaves_out = false;            ///< as in ErrorGoal
    double most_rays_per_pixel = 1024;  ///< on average
    std::optional<PictureRows> rows;    ///< as in ErrorGoal

    double threshold() const { return steps / 255; }
};

/// To tell a smaller one would take too many draws.
inline constexpr double least_share = 0.0003;

/// The picture with about the fewest rays of which at most goal.share of the pixels are off by more
/// than goal.steps, as an audit tells with 95 % confidence. Audits decide whether to go on; the
/// last, with fresh draws, is taken once and reported, whatever it says. The same bytes for any
/// number of threads. Throws Unreachable, SceneError.
///
/// \param renderer  makes the picture; may be the truth's own
ErrorPicture render_to_share(const Renderer& renderer, const Truth& truth, const View& view,
                             const OffGoal& goal, const Progress& progress);

}  // namespace lancer::accuracy
