// `render --max-error`: which settings count as the truth, and what is said of the error.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "accuracy/error_target.h"
#include "cli/settings_options.h"
#include "model/scene.h"
#include "tracer/render.h"

namespace lancer::cli {

struct ErrorOptions {
    std::optional<double> max_error;
    bool no_audit = false;
};

/// A picture with a told error, and what the statistics say of its world.
struct ErrorRun {
    Image image;  ///< with `view.aov` also error.Y and samples.Z
    accuracy::ErrorReport report;
    WorldCounts world;
    Level level = Level::scalar;  ///< of rays side by side
    double build_seconds = 0;
};

/// Renders until the error is below options.max_error, which must be there. The truth is the scene
/// without limits on its recursion and with true surfaces, in double precision or better; what the
/// command line switches off is part of the error. Throws UsageError when the error cannot be
/// reached, SceneError.
ErrorRun render_to_error(const Scene& scene, const SettingsOptions& settings,
                         const ErrorOptions& options, Level level, const View& view,
                         const Progress& progress);

/// One line: the error with its interval, or why it cannot be told, and what it cost.
std::string error_line(const accuracy::ErrorReport& report);
/// The same for a picture's file: names and values.
std::vector<std::pair<std::string, std::string>> error_notes(const accuracy::ErrorReport& report);

}  // namespace lancer::cli
