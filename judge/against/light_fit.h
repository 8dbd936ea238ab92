// Causes that lie in the light: one of the lights, the ambient light, the background or the sky is
// another, or a light falls off otherwise.
#pragma once

#include <vector>

#include "judge/against/value_fits.h"
#include "judge/validate/validate.h"

namespace lancer::judge {

/// The largest number of lights that are tried one by one; each needs a picture.
inline constexpr std::size_t most_lights = 12;

/// Light adds up: the other picture is ours and a share of what each light, the ambient light, the
/// background and the sky bring. The shares by least squares, channel by channel; nothing where no
/// light brings anything.
std::vector<Explanation> other_lights(const TrialPixels& samples, const VariantTracer& tracer,
                                      const ValidationJob& job);

/// Lights, one alone or all, that fall off by another law, of any brightness.
std::vector<Explanation> other_falloffs(const TrialPixels& samples, const VariantTracer& tracer,
                                        const ValidationJob& job);

}  // namespace lancer::judge
