// The one colour that stands for a surface when its texture is left out.
#pragma once

#include "model/scene.h"

namespace lancer {

/// The texture's mean colour, or the material's own colour without one: a checker's two colours in
/// equal parts, a gradient over one period, an image over its texels, each weighted by its alpha.
Color plain_color(const Scene& scene, const Material& material);

}  // namespace lancer
