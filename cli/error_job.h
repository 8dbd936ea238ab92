// `render` by an error, a time or passes: which settings count as the truth.
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

    /// In place of a number of samples.
    bool any() const { return max_error || max_off || seconds || passes; }
};

/// A picture with a told error, and what the statistics say of its world.
struct ErrorRun {
    Image image;  ///< with `view.aov` also error.Y and samples.Z
    accuracy::ErrorReport report;
    accuracy::ErrorSums sums;  ///< what the report rests on
    WorldCounts world;
    Level level = Level::scalar;  ///< of rays side by side
    double build_seconds = 0;
};

/// Renders until the error is below options.max_error, which must be there. The truth is the scene
/// without limits on its recursion and with true surfaces, in double precision or better; what the
/// command line switches off is part of the error. Throws UsageError when the error cannot be
/// reached, SceneError.
///
/// \param rows  those of one part; the image then has them alone. None: a whole picture
ErrorRun render_to_error(const Scene& scene, const SettingsOptions& settings,
                         const ErrorOptions& options, Level level, const View& view,
                         const std::optional<accuracy::PictureRows>& rows,
                         const Progress& progress);

/// Renders until at most options.max_off.share of the pixels are off; all else as above.
ErrorRun render_to_share(const Scene& scene, const SettingsOptions& settings,
                         const ErrorOptions& options, Level level, const View& view,
                         const std::optional<accuracy::PictureRows>& rows,
                         const Progress& progress);

/// A picture that gets better pass by pass.
struct PassClock {
    /// Since the work on the picture began, with its script and its world.
    std::function<double()> seconds;
    /// Takes the picture as it is now, to show or to store it.
    std::function<void(const Image&)> show;
};

/// As many passes as options.passes says or as options.seconds has time for, audits and the writing
/// of the file included. Throws UsageError when the time is too short for a ray a pixel.
ErrorRun render_by_passes(const Scene& scene, const SettingsOptions& settings,
                          const ErrorOptions& options, Level level, const View& view,
                          const PassClock& clock);

}  // namespace lancer::cli
