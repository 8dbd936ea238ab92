// Unions, intersections and differences of which nothing is left.
#pragma once

#include "model/scene.h"

namespace lancer {

/// Why a body holds no point.
enum class Emptiness {
    not_known,  ///< it may hold some
    apart,      ///< parts of an intersection have no room in common
    cut_away,   ///< what is cut away holds all of the first part
};

/// What boxes round the balls, boxes, cylinders, cones and tori of the whole show; of other shapes
/// it concludes nothing. Takes time in proportion to the leaves times the depth of the tree.
Emptiness emptiness_of(const Scene& scene, const Composite& composite);

}  // namespace lancer
