// Pixels that the other program's own picture denies.
#pragma once

#include "judge/explain/explain.h"

namespace lancer::judge {

/// Asks the other program for what lies around a pixel's centre. True when it has there what we
/// have, or what its rules make of ours: docs/validation.md, "outlier".
bool is_outlier(const DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
                const SecondLook& second);

}  // namespace lancer::judge
