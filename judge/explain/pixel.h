// What explains one pixel that differs.
#pragma once

#include "judge/explain/explain.h"

namespace lancer::judge {

bool is_explained(PixelClass c);

/// Whether our picture is what our renderer gives: were it not, its looks would explain nothing.
bool is_ours(const DifferentPixel& pixel, const Thresholds& limits, const ProbeFunction& probe);

/// Whether the other program's rules, and nothing else, make the difference to within `tolerance`.
bool is_known(const DifferentPixel& pixel, double tolerance, const Thresholds& limits,
              const SecondLook& second);

/// Whether the other program has our value once coincident faces are told apart.
bool is_coincident(const DifferentPixel& pixel, double tolerance, const SecondLook& second);

/// What explains that our pixel is not `pixel.theirs`.
void classify(DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
              const SecondLook& second);

/// The other program may have a value there that is neither, because an edge passes the centre:
/// that explains the pixel, and counts as an edge does.
void explain_told_apart(DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
                        const SecondLook& second);

}  // namespace lancer::judge
