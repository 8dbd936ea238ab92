// The ray tree as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "model/scene.h"
#include "model/source.h"
#include "tracer/rays/ray_tree.h"

namespace lancer::cli {

/// The list of the tree's rays; docs/command-line.md describes the keys.
nlohmann::ordered_json ray_tree_json(const RayTree& tree, const Scene& scene,
                                     const SourceMap& sources);

/// [x, y, z]
nlohmann::ordered_json vector_json(const Vec3d& v);

}  // namespace lancer::cli
