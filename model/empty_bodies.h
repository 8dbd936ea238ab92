// Finds composites of which nothing is left.
#pragma once

#include "model/scene.h"

namespace lancer {

/// Why a body contains no point.
enum class Emptiness {
    not_known,  ///< it may hold some
    apart,      ///< parts of an intersection have no room in common
    cut_away,   ///< what is cut away holds all of the first part
};

/// Concludes this from the boxes of spheres, boxes, cylinders, cones and tori; for other shapes it
/// concludes nothing. The time is proportional to the leaves times the depth of the tree.
Emptiness emptiness_of(const Scene& scene, const Composite& composite);

}  // namespace lancer
