// Textures in the tracer's number type, and their binding to primitives.
#pragma once

#include <variant>

#include "tracer/textures/image_map.h"
#include "tracer/textures/pattern.h"
#include "tracer/textures/uv.h"

namespace lancer {

/// The colours of a mesh's vertices; the primitive's mesh has them.
struct VertexPattern {};

template <class Real>
using Pattern =
    std::variant<CheckerPattern<Real>, GradientPattern<Real>, ImagePattern<Real>, VertexPattern>;

/// One primitive's texture coordinates.
template <class Real>
struct TextureBinding {
    /// The map to the texture's own space; with `mapping uv`, to the object's own space.
    Placement<Real> placement;
    Chart<Real> chart;  ///< only used with `mapping uv`
};

}  // namespace lancer
