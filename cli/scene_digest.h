// What a scene shows, as a digest: scenes whose scripts differ only in words, in order of
// computing or in comments have the same.
#pragma once

#include <functional>
#include <string>

#include "model/scene.h"

namespace lancer::cli {

/// Digest of all in the scene that pixels may depend on but its settings. Places in the script and
/// names do not count. Throws what `file` throws.
///
/// \param file  digest of the image file that a path names
std::string scene_digest(const Scene& scene,
                         const std::function<std::string(const std::string& path)>& file);

}  // namespace lancer::cli
