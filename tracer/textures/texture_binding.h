// Textures in the tracer's number type, and how each primitive wears its own.
#pragma once

#include <variant>

#include "tracer/textures/image_map.h"
#include "tracer/textures/pattern.h"
#include "tracer/textures/uv.h"

namespace lancer {

template <class Real>
using Pattern = std::variant<CheckerPattern<Real>, GradientPattern<Real>, ImagePattern<Real>>;

/// One primitive's texture coordinates.
template <class Real>
struct TextureBinding {
    /// To the texture's own space; with `mapping uv` to the object's.
    Placement<Real> placement;
    Chart<Real> chart;  ///< with `mapping uv`
};

}  // namespace lancer
