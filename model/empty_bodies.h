// Finds composites of which nothing is left.
#pragma once

#include "model/scene.h"

namespace lancer {

/// Why a body contains no point.
enum class Emptiness {
    not_known,  ///< it may contain points
    apart,      ///< the parts of an intersection do not overlap
    cut_away,   ///< the cut parts contain the whole first part
};

/// Concludes this from the boxes of spheres, boxes, cylinders, cones and tori; for other shapes it
/// concludes nothing. The time is proportional to the leaves times the depth of the tree.
Emptiness emptiness_of(const Scene& scene, const Composite& composite);

}  // namespace lancer
