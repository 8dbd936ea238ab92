// What is no mistake in a scene but seldom meant, and shows only when all of it is known.
#pragma once

#include <vector>

#include "model/diagnostic.h"
#include "model/scene.h"

namespace lancer {

/// Warns, once for each place, of meshes that let light through and have an index of refraction or
/// an absorption, but no inside, as they are not closed.
std::vector<Diagnostic> advice_on(const Scene& scene);

}  // namespace lancer
