// Renders a picture with one setting, as `render` does, and measures its cost.
#pragma once

#include <vector>

#include "judge/tradeoff/cost.h"
#include "judge/tradeoff/settings.h"

namespace lancer::judge {

struct SettingRun {
    Image image;
    Cost cost;  ///< including building the world, without writing the file
    RayCounts rays;
    /// the standard errors that an adaptive setting predicts, per pixel
    std::vector<double> guessed;
    std::vector<std::uint32_t> samples;  ///< per pixel; empty when all pixels have the same number
};

/// Throws accuracy::Unreachable when an error cannot be reached, SceneError.
SettingRun run_setting(const Scene& scene, const View& view, const TradeSetting& setting,
                       const Progress& progress);

}  // namespace lancer::judge
