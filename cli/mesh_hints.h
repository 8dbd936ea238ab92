// Hints of `check` about meshes.
#pragma once

#include <vector>

#include "model/diagnostic.h"
#include "model/scene.h"

namespace lancer::cli {

/// Finds meshes without normals that are smoothed across edges sharper than 60 degrees.
std::vector<Diagnostic> smoothed_edges(const Scene& scene);

}  // namespace lancer::cli
