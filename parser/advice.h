// What is no mistake in a scene but seldom meant, and shows only when all of it is known.
#pragma once

#include <unordered_set>
#include <vector>

#include "model/diagnostic.h"
#include "model/scene.h"

namespace lancer {

/// Warns, once for each place, of meshes that let light through and have an index of refraction or
/// an absorption, but no inside, as they are not closed; and of bodies of which nothing is left.
///
/// \param pieces  meshes that are one material's share of a file's
std::vector<Diagnostic> advice_on(const Scene& scene,
                                  const std::unordered_set<const Mesh*>& pieces);

}  // namespace lancer
