// Maps a number to a colour whose lightness grows evenly with it.
#pragma once

#include "model/math.h"

namespace lancer::reference {

/// matplotlib's "magma" (Stéfan van der Walt and Nathaniel Smith, 2015, public domain): from black
/// through purple and orange to pale yellow. Its lightness grows evenly, so it is readable in grey
/// and for the colour-blind. `t` is clamped to 0..1. Returns linear light.
Color magma(double t);

}  // namespace lancer::reference
