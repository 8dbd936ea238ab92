// The size of pictures that serve measurements only: small, in the scene's proportions.
#pragma once

#include <optional>

#include "cli/arguments.h"
#include "model/scene.h"

namespace lancer::cli {

/// Returns `asked` if given; otherwise a size of `width` pixels in the scene's proportions.
PictureSize size_or(const std::optional<PictureSize>& asked, const Scene& scene, int width);

}  // namespace lancer::cli
