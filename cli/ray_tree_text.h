// What one ray did, in words.
#pragma once

#include <string>

#include "model/scene.h"
#include "model/source.h"
#include "tracer/rays/ray_tree.h"

namespace lancer::cli {

/// An indented line for each thing that happened; what follows from it stands below, further in.
///
/// \param scene  that the tree was traced in, with these settings
std::string ray_tree_text(const RayTree& tree, const Scene& scene, const SourceMap& sources);

}  // namespace lancer::cli
