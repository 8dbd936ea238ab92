// Textures in the tracer's number type, and how each primitive wears its own.
#pragma once

#include <variant>

#include "tracer/textures/image_map.h"
#include "tracer/textures/pattern.h"
#include "tracer/textures/uv.h"

namespace lancer {

/// The colours of a mesh's vertices: the primitive has them.
struct VertexPattern {};

template <class Real>
using Pattern =
    std::variant<CheckerPattern<Real>, GradientPattern<Real>, ImagePattern<Real>, VertexPattern>;

/// One primitive's texture coordinates.
template <class Real>
struct TextureBinding {
    /// To the texture's own space; with `mapping uv` to the object's.
    Placement<Real> placement;
    Chart<Real> chart;  ///< with `mapping uv`
};

}  // namespace lancer
