// The ray tree as text.
#pragma once

#include <string>

#include "model/scene.h"
#include "model/source.h"
#include "tracer/rays/ray_tree.h"

namespace lancer::cli {

/// One line per event; events that follow from it stand below, indented further.
///
/// \param scene  the scene in which the tree was traced, with the same settings
std::string ray_tree_text(const RayTree& tree, const Scene& scene, const SourceMap& sources);

}  // namespace lancer::cli
