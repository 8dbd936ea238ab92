// A digest of what a scene shows. It is equal for scripts that differ only in names, comments or
// the order of computations.
#pragma once

#include <functional>
#include <string>

#include "model/scene.h"

namespace lancer::cli {

/// The digest of everything in the scene that pixels may depend on, except its settings. Places in
/// the script and names are ignored. Passes on what `file` throws.
///
/// \param file  returns the digest of the image file with this path
std::string scene_digest(const Scene& scene,
                         const std::function<std::string(const std::string& path)>& file);

}  // namespace lancer::cli
