// Renders a picture with one setting, as `render` does, and measures its cost.
#pragma once

#include <vector>

#include "judge/tradeoff/cost.h"
#include "judge/tradeoff/settings.h"

namespace lancer::judge {

struct SettingRun {
    Image image;
    Cost cost;  ///< the world's building included, the file's writing not
    RayCounts rays;
    std::vector<double> guessed;         ///< standard errors that such a setting guesses, a pixel
    std::vector<std::uint32_t> samples;  ///< a pixel; empty where all have as many
};

/// Throws accuracy::Unreachable when an error cannot be reached, SceneError.
SettingRun run_setting(const Scene& scene, const View& view, const TradeSetting& setting,
                       const Progress& progress);

}  // namespace lancer::judge
