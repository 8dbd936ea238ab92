// Warnings about what is valid in a scene but seldom meant. They need the whole scene.
#pragma once

#include <unordered_set>
#include <vector>

#include "model/diagnostic.h"
#include "model/scene.h"

namespace lancer {

/// Warns, once per place, about transparent meshes that have an index of refraction or an
/// absorption but no inside because they are not closed, and about composites of which nothing is
/// left.
///
/// \param pieces  meshes that hold the faces of one material of a file
std::vector<Diagnostic> advice_on(const Scene& scene,
                                  const std::unordered_set<const Mesh*>& pieces);

}  // namespace lancer
