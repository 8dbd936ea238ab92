// Scene → World: number type, scale, primitives, trees.
#pragma once

#include <memory>

#include "tracer/render.h"
#include "tracer/world.h"

namespace lancer {

/// Compiles for one number type. Throws SceneError at the place of what cannot be rendered: a
/// coordinate or colour that leaves the type's range.
template <class Real>
std::unique_ptr<World<Real>> compile_world(const Scene& scene, const Settings& settings);

extern template std::unique_ptr<World<float>> compile_world(const Scene&, const Settings&);
extern template std::unique_ptr<World<double>> compile_world(const Scene&, const Settings&);
extern template std::unique_ptr<World<long double>> compile_world(const Scene&, const Settings&);

}  // namespace lancer
