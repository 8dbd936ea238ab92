// Finds the explanation of one different pixel.
#pragma once

#include "judge/explain/explain.h"

namespace lancer::judge {

bool is_explained(PixelClass c);

/// Whether our picture has the value that our renderer gives. If not, its probes would explain
/// nothing.
bool is_ours(const DifferentPixel& pixel, const Thresholds& limits, const ProbeFunction& probe);

/// Whether the other program's rules alone make the difference, to within `tolerance`.
bool is_known(const DifferentPixel& pixel, double tolerance, const Thresholds& limits,
              const SecondLook& second);

/// Whether the other program has our value once coincident faces are told apart.
bool is_coincident(const DifferentPixel& pixel, double tolerance, const SecondLook& second);

/// Classifies why our pixel is not `pixel.theirs`.
void classify(DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
              const SecondLook& second);

/// Explains a pixel where the other program's second picture has a third value because an edge
/// passes the centre. This counts like an edge.
void explain_told_apart(DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
                        const SecondLook& second);

}  // namespace lancer::judge
