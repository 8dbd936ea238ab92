// Unions, intersections and differences of which nothing is left.
#pragma once

#include "model/scene.h"

namespace lancer {

/// True where boxes round the parts show that the whole holds no point: parts of an intersection lie
/// apart, or a ball, box, cylinder, cone or half space that is cut away holds all of the first part.
/// False says nothing. Takes time in proportion to the leaves times the depth of the tree.
bool is_surely_empty(const Scene& scene, const Composite& composite);

}  // namespace lancer
