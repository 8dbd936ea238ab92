// The single colour of a surface whose texture is switched off.
#pragma once

#include "model/scene.h"

namespace lancer {

/// The mean colour of the texture, or the material's own colour if it has none. For a checker: both
/// colours in equal parts; for a gradient: the mean over one period; for an image: the mean over
/// its texels, weighted by alpha.
Color plain_color(const Scene& scene, const Material& material);

}  // namespace lancer
