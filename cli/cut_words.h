// Describes the light that limits on the recursion left out.
#pragma once

#include <string>

#include "accuracy/cut_bound.h"

namespace lancer::cli {

/// One line, which also says whether a 16-bit picture may show the loss: half a step at the dark
/// end of sRGB, where steps are smallest, is 6e-7 in linear light.
std::string cut_line(const accuracy::CutBound& cut);

}  // namespace lancer::cli
