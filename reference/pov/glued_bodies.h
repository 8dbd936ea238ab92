// Glued bodies of the same glass as one body each: what `merge` means, as a scene.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene.h"

namespace lancer::reference::pov {

/// The scene in which each group of objects is one union, at the place of the group's first object.
///
/// \param groups  of objects that are no composites, as ResolvedScene::merged
Scene with_unions(Scene scene, const std::vector<std::vector<std::uint32_t>>& groups);

}  // namespace lancer::reference::pov
