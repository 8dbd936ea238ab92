// Renderers in which textbook formulas replace some kernels, each in a library of its own.
#pragma once

#include <memory>

#include "tracer/render.h"

namespace lancer {

/// \tparam Methods  see textbook_methods.h; 0: the tracer as it is, compiled like the others
template <unsigned Methods>
std::unique_ptr<Renderer> compile_set(const Scene& scene, const Settings& settings);

}  // namespace lancer
