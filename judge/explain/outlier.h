// Pixels that the other program's own picture contradicts.
#pragma once

#include "judge/explain/explain.h"

namespace lancer::judge {

/// Has the other program render the points around a pixel's centre. True when its value there is
/// ours, or what its rules make of ours: docs/validation.md, "outlier".
bool is_outlier(const DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
                const SecondLook& second);

}  // namespace lancer::judge
