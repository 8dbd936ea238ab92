// Causes that change each value by itself: a curve applied too often, a factor.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "judge/against/trial_pixels.h"

namespace lancer::judge {

/// Curves applied once too often or too seldom, another exponent, a factor for all or for single
/// channels: those that can be fitted, the plainest first.
std::vector<Explanation> value_fits(const TrialPixels& samples);

/// A factor as text with up to six digits: as many as are needed to distinguish it from 1.
std::string factor_text(double factor);

}  // namespace lancer::judge
