// Renders a picture to an error that the user asks for, and reports the error that it has.
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
    bool audited = true;  ///< false: only the picture's own rays are traced; no interval
    FixedLimits fixed;
    /// The renderer leaves out more than its limits cut: shadows, smooth normals, precision ...
    bool leaves_out = false;
    double most_rays_per_pixel = 1024;  ///< on average
    /// If set, only these rows are rendered, as one part of the picture. The part itself must reach
    /// the goal. Its audit is always drawn, even where its own error cannot be told, because the
    /// report on the whole picture needs the draws (joined_report.h).
    std::optional<PictureRows> rows;
};

/// The goal cannot be reached. Thrown before the picture is made; the message says what can be
/// reached.
struct Unreachable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Renders the picture with about the fewest rays for which the audited interval ends below the
/// goal. Every decision uses the complete data of the passes before it, so the bytes are the same
/// for any number of threads.
///
/// Deciding audits choose whether to go on and whether an error can be told. One more audit, with
/// fresh draws, is taken after the last refinement. It is taken once and reported whatever it
/// says. Throws Unreachable, SceneError.
///
/// \param renderer  makes the picture; may be the truth's own
ErrorPicture render_to_error(const Renderer& renderer, const Truth& truth, const View& view,
                             const ErrorGoal& goal, const Progress& progress);

}  // namespace lancer::accuracy
