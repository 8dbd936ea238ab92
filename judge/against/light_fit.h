// Causes that lie in the light: one of the lights, the ambient light or the background is another,
// or a light falls off otherwise.
#pragma once

#include <vector>

#include "judge/against/value_fits.h"
#include "judge/validate/validate.h"

namespace lancer::judge {

/// So many lights are asked for one by one; each takes a picture of its own.
inline constexpr std::size_t most_lights = 12;

/// Light adds up: the other picture is ours and a share of what each light, the ambient light and
/// the background bring. The shares by least squares, channel by channel; nothing where no light
/// brings anything.
std::vector<Explanation> other_lights(const TrialPixels& samples, const VariantTracer& tracer,
                                      const ValidationJob& job);

/// Lights, one alone or all, that fall off by another law, of any brightness.
std::vector<Explanation> other_falloffs(const TrialPixels& samples, const VariantTracer& tracer,
                                        const ValidationJob& job);

}  // namespace lancer::judge
