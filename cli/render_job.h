// The plan of a `render` command, checked as far as possible before the scene is read.
#pragma once

#include <optional>
#include <string>

#include "cli/arguments.h"
#include "cli/error_job.h"
#include "cli/scene_loader.h"
#include "cli/session.h"
#include "cli/settings_options.h"
#include "model/io/image_file.h"
#include "tracer/render.h"

namespace lancer::cli {

struct RenderJob {
    std::string scene;
    std::string output;  ///< empty: the scene's name with .png
    std::string camera;  ///< empty: the first
    std::optional<PictureSize> size;
    std::optional<Crop> crop;
    std::optional<FrameRange> frames;
    std::optional<PartOf> part;  ///< of the picture, or of the frames in an animation
    bool resume = false;   ///< keep existing files that are complete and are what would be drawn
    bool loop = false;     ///< the first frame follows the last one
    bool preview = false;  ///< one ray per pixel, a quarter of the width and of the height
    bool aov = false;
    bool alpha = false;
    bool bound_cut = false;  ///< report a bound on the light that the limits leave out
    bool quiet = false;
    Level level = best_level();  ///< the fastest allowed level
    std::string
        statistics;  ///< path of the JSON file; `-`: for people, to standard output; may be empty
    io::ImageWriteOptions image;
    SceneOptions scene_options;
    SettingsOptions settings;
    ErrorOptions error;
};

/// Renders and writes all pictures. Returns ExitCode::differs when a picture misses its target
/// error or time. Throws UsageError, SceneRejected, SceneError, FileError.
ExitCode run(const RenderJob& job, Session& session);

}  // namespace lancer::cli
