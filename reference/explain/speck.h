// Pixels that the other program's own picture denies.
#pragma once

#include "reference/explain/explain.h"

namespace lancer::reference {

/// Asks the other program for what lies around a pixel's centre. True when it has there what we
/// have, or what its rules make of ours: docs/validation.md, "speck".
bool is_speck(const DifferentPixel& pixel, const Probe& probe, const Thresholds& limits,
              const SecondLook& second);

}  // namespace lancer::reference
