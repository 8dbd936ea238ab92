// Chooses promising combinations of knobs from the effect of each knob alone.
#pragma once

#include <vector>

#include "judge/tradeoff/settings.h"

namespace lancer::judge {

/// The measurements of a setting, for predictions.
struct KnobEffect {
    TradeSetting setting;
    double rays = 0;         ///< of all kinds
    double mean_square = 0;  ///< error
    double cut = 0;          ///< mean squared difference from the base, at the same points
    /// Share of the base's time, for knobs whose effect rays do not show: precision, surfaces.
    double time = 1;
};

/// Combinations of one number of samples with at most one value of each other knob. They are those
/// that no other combination beats, assuming that costs multiply and squared errors add, and whose
/// RMSE is at most 0.05. Returns at most `most`, spread evenly over the errors, and none that
/// `singles` contains. The other knobs were measured on `base`.
std::vector<TradeSetting> promising(const TurnedScene& turned, const KnobEffect& base,
                                    const std::vector<KnobEffect>& singles, std::size_t most);

}  // namespace lancer::judge
