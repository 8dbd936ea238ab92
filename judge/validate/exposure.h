// Scales the light of both pictures by a power of two: POV-Ray's 16-bit picture ends at 1.
#pragma once

#include "model/image.h"

namespace lancer::judge {

/// The power of two that brings the brightest value into 0..1, or 1. Scaling by it is exact.
double exposure_for(const Image& image);

/// `value` times the exposure, clipped to 0..1. NaN and infinity are unchanged, so that a
/// comparison finds them.
double exposed(double value, double exposure);

}  // namespace lancer::judge
