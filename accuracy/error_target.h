// A picture whose error is asked for, and told.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "accuracy/error_picture.h"
#include "accuracy/limits.h"

namespace lancer::accuracy {

struct ErrorGoal {
    double max_error = 0.01;  ///< RMSE over pixels and channels in linear light, > 0
    std::uint64_t seed = 0;
    bool audited = true;  ///< false: no ray beside those of the picture, and no interval
    FixedLimits fixed;
    /// The renderer leaves out more than limits do: shadows, normals, digits ...
    bool leaves_out = false;
    double most_rays_per_pixel = 1024;  ///< on average
    /// These rows alone, as one part of the picture: they are held to the goal by themselves, with
    /// draws whatever these tell, for the report on the whole (joined_report.h).
    std::optional<PictureRows> rows;
};

/// Refused before the picture is made; the message says what can be reached.
struct Unreachable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The picture with about the fewest rays whose audited interval ends below the goal. Between
/// passes every decision comes from complete data, so the bytes are the same for any number of
/// threads. Audits decide whether to go on, and whether an error can be told; the last, with fresh
/// draws after the last refinement, is taken once and reported, whatever it says. Throws
/// Unreachable, SceneError.
///
/// \param renderer  makes the picture; may be the truth's own
ErrorPicture render_to_error(const Renderer& renderer, const Truth& truth, const View& view,
                             const ErrorGoal& goal, const Progress& progress);

}  // namespace lancer::accuracy
