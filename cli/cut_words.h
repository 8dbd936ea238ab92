// What is said of the light that limits left out.
#pragma once

#include <string>

#include "accuracy/cut_bound.h"

namespace lancer::cli {

/// One line, and whether a 16-bit picture may show it: half a step of sRGB's dark end, where steps
/// are smallest, is 6e-7 in linear light.
std::string cut_line(const accuracy::CutBound& cut);

}  // namespace lancer::cli
