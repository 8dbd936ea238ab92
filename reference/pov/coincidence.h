// Coincident faces of different objects: glued blocks, a glass standing on a table.
#pragma once

#include <vector>

#include "model/scene.h"
#include "reference/pov/export.h"
#include "reference/pov/faces.h"

namespace lancer::reference::pov {

/// Two coincident faces. If `alike`, the resolution puts `front` further out; otherwise it makes
/// the two bodies overlap, and `front` is the one that grows.
struct FacePair {
    Face front;
    Face back;
    bool alike = false;
    Coincidence::Resolution resolution = Coincidence::Resolution::none;
};

/// All pairs. Examines only the first 4,000 faces.
std::vector<FacePair> face_pairs(const Scene& scene);

/// One entry per pair of objects, at the first face that they share, in the order of declaration.
std::vector<Coincidence> coincidences(const std::vector<FacePair>& pairs);

}  // namespace lancer::reference::pov
