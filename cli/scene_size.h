// The size of pictures that are made for their numbers: small, in the scene's proportions.
#pragma once

#include <optional>

#include "cli/arguments.h"
#include "model/scene.h"

namespace lancer::cli {

/// `asked`, else `width` pixels wide, in the scene's own proportions.
PictureSize size_or(const std::optional<PictureSize>& asked, const Scene& scene, int width);

}  // namespace lancer::cli
