// From a number to a colour whose lightness grows evenly with it.
#pragma once

#include "model/math.h"

namespace lancer::reference {

/// matplotlib's "magma" (Stéfan van der Walt and Nathaniel Smith, 2015, public domain): from black
/// over purple and orange to a pale yellow, evenly in lightness, so that it also reads in grey and
/// for the colour-blind. `t` is clamped to 0..1. Returns linear light.
Color magma(double t);

}  // namespace lancer::reference
