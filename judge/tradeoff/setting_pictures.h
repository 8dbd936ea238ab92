// The pictures of a setting on the page.
#pragma once

#include "judge/tradeoff/run_setting.h"
#include "judge/tradeoff/true_picture.h"

namespace lancer::judge {

/// PNG files, reduced in size where they would be large.
struct SettingPictures {
    std::string picture;
    std::string error;    ///< the difference from the truth, see reference::heat_map
    std::string guessed;  ///< the difference that the setting predicts; may be empty
    std::string samples;  ///< per pixel, logarithmic; empty when all have the same number
};
SettingPictures pictures_of(const SettingRun& run, const TruePicture& truth);

}  // namespace lancer::judge
