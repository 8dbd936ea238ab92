// The options of `lancer stability`, and its run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/exit_codes.h"
#include "cli/scene_loader.h"
#include "cli/session.h"
#include "cli/settings_options.h"
#include "cli/stability_options.h"
#include "cli/sweep_share.h"

namespace lancer::cli {

struct StabilityJob {
    std::vector<std::string> scenes;
    std::optional<PartOf> part;  ///< of all changes of all scenes
    std::string camera;
    std::string json;
    std::string plot;
    std::optional<PictureSize> size;
    std::vector<ChangeRange> tries;
    std::vector<ChangeRange> demands;
    std::optional<double> fail;
    std::optional<double> fail_percent;
    std::optional<double> time;
    bool every = false;
    bool no_povray = false;
    bool no_cache = false;
    bool quiet = false;
    SettingsOptions settings;
    SceneOptions scene_options;
};

ExitCode run_stability(const StabilityJob& job, Session& session);

}  // namespace lancer::cli
