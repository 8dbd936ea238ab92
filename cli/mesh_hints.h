// Hints of `check` about meshes.
#pragma once

#include <vector>

#include "model/diagnostic.h"
#include "model/scene.h"

namespace lancer::cli {

/// Meshes without normals that are smoothed over edges sharper than 60 degrees.
std::vector<Diagnostic> smoothed_edges(const Scene& scene);

}  // namespace lancer::cli
