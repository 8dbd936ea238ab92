// Which combinations of knobs promise something, by what each does alone.
#pragma once

#include <vector>

#include "judge/tradeoff/settings.h"

namespace lancer::judge {

/// What was measured of a setting, for guessing.
struct KnobEffect {
    TradeSetting setting;
    double rays = 0;         ///< of all kinds
    double mean_square = 0;  ///< error
    double cut = 0;          ///< mean squared difference from the base, at the same points
    /// Share of the base's time where rays do not tell it: by its digits or its surfaces.
    double time = 1;
};

/// Combinations of one number of samples with one turn of each other knob that nothing should beat
/// if costs multiply and squared errors add, and worth a look (an RMSE up to 0.05): at most `most`,
/// spread evenly over the errors, none that `singles` holds. `base` is where the other knobs were
/// turned.
std::vector<TradeSetting> promising(const TurnedScene& turned, const KnobEffect& base,
                                    const std::vector<KnobEffect>& singles, std::size_t most);

}  // namespace lancer::judge
