// `render` with a target error, a time or a number of passes: builds the truth that errors are
// measured against.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "accuracy/error_picture.h"
#include "cli/arguments.h"
#include "cli/settings_options.h"
#include "model/scene.h"
#include "tracer/render.h"

namespace lancer::cli {

struct ErrorOptions {
    std::optional<double> max_error;
    std::optional<OffTarget> max_off;
    std::optional<double> seconds;       ///< --time
    std::optional<std::int64_t> passes;  ///< --passes
    bool no_audit = false;

    /// Whether one of these takes the place of a number of samples.
    bool any() const { return max_error || max_off || seconds || passes; }
};

/// A picture with its measured error, and statistics of its world.
struct ErrorRun {
    Image image;  ///< with `view.aov` also error.Y and samples.Z
    accuracy::ErrorReport report;
    accuracy::ErrorSums sums;  ///< the sums from which the report is computed
    WorldCounts world;
    Level level = Level::scalar;  ///< of rays side by side
    double build_seconds = 0;
};

/// Renders until the error is below options.max_error, which must be set. The truth is the scene
/// without limits on its recursion and with exact surfaces, in double precision or better; what the
/// command line switches off is part of the error. Throws UsageError when the error cannot be
/// reached, and SceneError.
///
/// \param rows  the rows of one part; the image then holds only these. None: a whole picture
ErrorRun render_to_error(const Scene& scene, const SettingsOptions& settings,
                         const ErrorOptions& options, Level level, const View& view,
                         const std::optional<accuracy::PictureRows>& rows,
                         const Progress& progress);

/// Renders until at most options.max_off.share of the pixels are off; otherwise as above.
ErrorRun render_to_share(const Scene& scene, const SettingsOptions& settings,
                         const ErrorOptions& options, Level level, const View& view,
                         const std::optional<accuracy::PictureRows>& rows,
                         const Progress& progress);

/// The clock and the display of a picture that improves pass by pass.
struct PassClock {
    /// Seconds since the work on the picture began, including its script and its world.
    std::function<double()> seconds;
    /// Takes the current picture, to show or to store it.
    std::function<void(const Image&)> show;
};

/// Renders options.passes passes, or as many as options.seconds allow, including audits and the
/// writing of the file. Throws UsageError when the time is too short for one ray a pixel.
ErrorRun render_by_passes(const Scene& scene, const SettingsOptions& settings,
                          const ErrorOptions& options, Level level, const View& view,
                          const PassClock& clock);

}  // namespace lancer::cli
